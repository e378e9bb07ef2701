/* SPDX-License-Identifier: Apache-2.0 */
#include "frames.h"

#include <ctype.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

void cli_frames_sort(struct cli_frames *frames)
{
    if (frames->count > 0)
        qsort(frames->number, frames->count, sizeof *frames->number, ascending);
}

void cli_frames_release(struct cli_frames *frames)
{
    free(frames->number);
    *frames = (struct cli_frames){0};
}

murk_status cli_frames_add(struct cli_frames *frames, int number)
{
    if ((frames->count & (frames->count - 1)) == 0) { /* full at every power of two */
        size_t room = frames->count ? 2 * frames->count : 1;
        int *larger = realloc(frames->number, room * sizeof *larger);
        if (!larger)
            return MURK_ERROR_MEMORY;
        frames->number = larger;
    }
    frames->number[frames->count++] = number;
    return MURK_OK;
}

/* A whole number up to max in magnitude; only frames have a sign. */
static bool whole_at(const char **text, bool is_signed, int *out)
{
    const char *digits = *text + (is_signed && **text == '-');
    char *end;
    if (!isdigit((unsigned char)*digits))
        return false;
    long value = strtol(*text, &end, 10);
    if (value > CLI_FRAME_MAX || value < -CLI_FRAME_MAX)
        return false;
    *text = end;
    *out = (int)value;
    return true;
}

bool cli_frame_read(const char **text, int *out)
{
    return whole_at(text, true, out);
}

/* "7", "1-9" or "1-9x2" at *text, which is moved behind it. */
static bool range_at(const char **text, int *first, int *last, int *step)
{
    if (!cli_frame_read(text, first))
        return false;
    *last = *first;
    *step = 1;
    if (**text != '-')
        return true;
    ++*text;
    if (!cli_frame_read(text, last))
        return false;
    if (**text != 'x')
        return true;
    ++*text;
    return whole_at(text, false, step) && *step > 0;
}

static murk_status add_range(struct cli_frames *frames, int first, int last, int step)
{
    int count = abs(last - first) / step + 1;
    if (count > CLI_FRAME_COUNT_MAX - (int)frames->count)
        return MURK_ERROR_INPUT;
    murk_status status = MURK_OK;
    for (int i = 0; i < count && status == MURK_OK; i++)
        status = cli_frames_add(frames, first < last ? first + i * step : first - i * step);
    return status;
}

/* A frame and where the list names it. */
struct place {
    int number;
    size_t position;
};

static int by_number_then_position(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    int order = ascending(&x->number, &y->number);
    return order ? order : (x->position > y->position) - (x->position < y->position);
}

/* Keeps the first mention of each frame. */
static murk_status drop_repeated(struct cli_frames *frames)
{
    const int repeated = INT_MIN; /* is no frame */
    struct place *places = malloc(frames->count * sizeof *places);
    if (!places)
        return MURK_ERROR_MEMORY;
    for (size_t i = 0; i < frames->count; i++)
        places[i] = (struct place){frames->number[i], i};
    qsort(places, frames->count, sizeof *places, by_number_then_position);
    for (size_t i = 1; i < frames->count; i++)
        if (places[i].number == places[i - 1].number)
            frames->number[places[i].position] = repeated;
    free(places);
    size_t kept = 0;
    for (size_t i = 0; i < frames->count; i++)
        if (frames->number[i] != repeated)
            frames->number[kept++] = frames->number[i];
    frames->count = kept;
    return MURK_OK;
}

murk_status cli_frames_parse(const char *text, struct cli_frames *out)
{
    struct cli_frames frames = {0};
    int first, last, step;
    murk_status status = MURK_OK;
    do {
        status = range_at(&text, &first, &last, &step) ? add_range(&frames, first, last, step)
                                                       : MURK_ERROR_INPUT;
    } while (status == MURK_OK && *text == ',' && *++text);
    if (status == MURK_OK)
        status = *text || text[-1] == ',' ? MURK_ERROR_INPUT : drop_repeated(&frames);
    if (status == MURK_OK)
        *out = frames;
    else
        cli_frames_release(&frames);
    return status;
}

void cli_frames_text(const struct cli_frames *frames, char *text, size_t size)
{
    static const char more[] = ", ...";
    const int *number = frames->number;
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0, last; i < frames->count; i = last + 1) {
        char item[32] = "";
        for (last = i; last + 1 < frames->count && number[last + 1] == number[last] + 1;)
            last++;
        last = last == i + 1 ? i : last; /* two frames are no range */
        int length = last == i ? snprintf(item, sizeof item, "%d", number[i])
                               : snprintf(item, sizeof item, "%d-%d", number[i], number[last]);
        if (used + 2 + (size_t)length + sizeof more > size) {
            snprintf(text + used, size - used, "%s", more + (i ? 0 : 2));
            return;
        }
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "", item);
    }
}
