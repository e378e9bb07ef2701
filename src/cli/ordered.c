/* SPDX-License-Identifier: Apache-2.0 */
#include "ordered.h"

#include "report.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

bool cli_text_take(struct cli_text *text, int pipe)
{
    enum { PIECE = 4096 };
    for (;;) {
        char *larger = realloc(text->bytes, text->size + PIECE);
        if (!larger)
            return false;
        text->bytes = larger;
        ssize_t size = read(pipe, larger + text->size, PIECE);
        if (size <= 0 && !(size < 0 && errno == EINTR))
            return true;
        text->size += size > 0 ? (size_t)size : 0;
    }
}

static void release_text(struct cli_text *text)
{
    free(text->bytes);
    *text = (struct cli_text){0};
}

void cli_ordered_messages(struct cli_ordered *ordered, struct cli_text *messages)
{
    size_t size = messages->size;
    while (size > 0 && messages->bytes[size - 1] != '\n')
        size--;
    if (size == 0)
        return;
    cli_terminal_clear(&ordered->job->terminal);
    fwrite(messages->bytes, 1, size, stderr);
    memmove(messages->bytes, messages->bytes + size, messages->size - size);
    messages->size -= size;
}

static void say_how(struct cli_ordered *ordered, int frame, int how)
{
    struct cli_terminal *terminal = &ordered->job->terminal;
    int signal = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    cli_terminal_frame(terminal, frame);
    if (signal)
        cli_error(terminal, "its process was killed by signal %d (%s)%s", signal, strsignal(signal),
                  signal == SIGKILL ? "; if memory ran out, fewer --jobs need less" : "");
    else
        cli_error(terminal, "its process ended on the way, with status %d", WEXITSTATUS(how));
    cli_terminal_frames_end(terminal);
}

/* Trouble is told once: what reads standard output is gone, but frames are written all the same. */
static void pass_output(struct cli_ordered *ordered, const struct cli_ended *ended, int frame)
{
    struct cli_terminal *terminal = &ordered->job->terminal;
    if (ended->output.size && !ended->how)
        fwrite(ended->output.bytes, 1, ended->output.size, stdout);
    if (ended->how && ordered->job->options->json)
        cli_report_frame(frame, "failed", terminal->error);
    if (fflush(stdout) && ordered->output_status == MURK_OK) {
        cli_error(terminal, "standard output: %s", strerror(errno));
        ordered->output_status = MURK_ERROR_IO;
    }
    clearerr(stdout);
}

static void tell(struct cli_ordered *ordered, size_t index)
{
    struct cli_ended *ended = &ordered->frame[index];
    int frame = ordered->frames->number[index];
    cli_terminal_clear(&ordered->job->terminal);
    cli_ordered_messages(ordered, &ended->messages);
    if (ended->messages.size) /* a line that was cut short */
        fprintf(stderr, "%.*s\n", (int)ended->messages.size, ended->messages.bytes);
    if (ended->how)
        say_how(ordered, frame, ended->how);
    pass_output(ordered, ended, frame);
    cli_tally_add(ordered->tally, ordered->job, frame, ended->result);
    release_text(&ended->output);
    release_text(&ended->messages);
    free(ended->result);
    ended->result = NULL;
}

bool cli_ordered_end(struct cli_ordered *ordered, size_t index,
                     const struct cli_frame_result *result, int how, struct cli_text *output,
                     struct cli_text *messages)
{
    struct cli_ended *ended = &ordered->frame[index];
    ended->result = malloc(sizeof *ended->result);
    if (!ended->result)
        return false;
    *ended->result = *result;
    ended->how = how;
    ended->output = *output;
    ended->messages = *messages;
    *output = *messages = (struct cli_text){0};
    ordered->ended++;
    ordered->skipped += result->skipped;
    while (ordered->told < ordered->frames->count && ordered->frame[ordered->told].result)
        tell(ordered, ordered->told++);
    return true;
}

bool cli_ordered_start(struct cli_ordered *ordered, struct cli_job *job,
                       const struct cli_frames *frames, struct cli_tally *tally)
{
    *ordered = (struct cli_ordered){.job = job,
                                    .tally = tally,
                                    .frames = frames,
                                    .frame = calloc(frames->count, sizeof *ordered->frame)};
    return ordered->frame;
}

void cli_ordered_release(struct cli_ordered *ordered)
{
    for (size_t i = ordered->told; ordered->frame && i < ordered->frames->count; i++) {
        release_text(&ordered->frame[i].output);
        release_text(&ordered->frame[i].messages);
        free(ordered->frame[i].result);
    }
    free(ordered->frame);
}
