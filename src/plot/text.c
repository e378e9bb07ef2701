/* SPDX-License-Identifier: Apache-2.0 */
/* Text, from the coverage of its pixels. */
#include "canvas.h"
#include "context.h"
#include "image.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A piece of text in one font size and height. */
struct run {
    char text[128];
    bool raised;
};

/* Raised text: its size, and how far up, in sizes of the other. */
static const double RAISED_SIZE = 0.75, RAISED_BY = 0.4;

/* A plain font; NULL where none is installed. */
static const char *find_font(void)
{
    static const char *const PATHS[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",   /* Debian: fonts-dejavu-core */
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", /* Fedora */
        "/usr/share/fonts/TTF/DejaVuSans.ttf",               /* Arch */
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    };
    for (size_t i = 0; i < sizeof PATHS / sizeof *PATHS; i++)
        if (access(PATHS[i], R_OK) == 0)
            return PATHS[i];
    return NULL;
}

bool murk_text_possible(void)
{
    return find_font() != NULL;
}

/* Takes the run at *text, which is moved behind it; false at the end. */
static bool next_run(const char **text, struct run *out)
{
    out->raised = **text == '^';
    *text += out->raised;
    size_t length = out->raised ? strspn(*text, "+-0123456789") : strcspn(*text, "^");
    length = length < sizeof out->text ? length : sizeof out->text - 1;
    memcpy(out->text, *text, length);
    out->text[length] = '\0';
    *text += length;
    return length > 0 || **text;
}

static int run_size(const struct run *run, int size)
{
    return run->raised ? (int)round(RAISED_SIZE * size) : size;
}

double murk_text_width(const char *text, int size)
{
    struct run run;
    murk_oiio_box box;
    double width = 0;
    const char *font = find_font();
    while (font && next_run(&text, &run))
        if (murk_oiio_text_box(font, run.text, run_size(&run, size), &box))
            width += box.width;
    return width;
}

/* Draws a run whose left end is `shift` pixels along the text from `at`; moves shift to its end. */
static murk_status draw_run(murk_context *context, const murk_canvas *canvas, const char *font,
                            const murk_text *text, const struct run *run, int drop, int *shift)
{
    murk_oiio_box box;
    float *part = NULL;
    int size = run_size(run, text->size);
    if (!murk_oiio_text_box(font, run->text, size, &box))
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: OpenImageIO cannot use this font",
                         font);
    murk_status status = murk_oiio_text_cover(context, font, run->text, size, &box, &part);
    if (status)
        return status;
    int x = (int)round(text->at[0]), y = (int)round(text->at[1]);
    int top = drop + box.top - (run->raised ? (int)round(RAISED_BY * text->size) : 0);
    for (int j = 0; j < box.height; j++)
        for (int i = 0; i < box.width; i++) {
            int u = *shift + i, v = top + j;
            murk_canvas_cover(canvas, text->upward ? x + v : x + u, text->upward ? y - u : y + v,
                              part[j * box.width + i], text->color);
        }
    *shift += box.width;
    free(part);
    return MURK_OK;
}

murk_status murk_text_draw(murk_context *context, murk_image *image, const murk_text *text)
{
    murk_canvas canvas;
    murk_oiio_box digit = {0};
    struct run run;
    const char *font = find_font(), *at = text->text;
    if (!font || !murk_canvas_open(image, NULL, &canvas))
        return MURK_OK;
    murk_oiio_text_box(font, "0", text->size, &digit);
    int shift = (int)round(-text->align[0] * murk_text_width(text->text, text->size));
    int drop = (int)round((text->align[1] - 1) * digit.top);
    murk_status status = MURK_OK;
    while (!status && next_run(&at, &run))
        if (*run.text)
            status = draw_run(context, &canvas, font, text, &run, drop, &shift);
    return status;
}
