/* SPDX-License-Identifier: Apache-2.0 */
/* Frames that end in any order, told in the order of the sequence. */
#ifndef CLI_ORDERED_H
#define CLI_ORDERED_H

#include "tally.h"

/* What a process printed; from malloc. */
struct cli_text {
    char *bytes;
    size_t size;
};

/* A frame that has ended, until those before it have. */
struct cli_ended {
    struct cli_frame_result *result; /* from malloc; NULL: has not ended */
    struct cli_text output, messages;
    int how; /* its process ended, as wait() tells, where that was on the way; else 0 */
};

struct cli_ordered {
    struct cli_job *job;
    struct cli_tally *tally;
    const struct cli_frames *frames;
    struct cli_ended *frame;
    size_t told, ended, skipped;
    murk_status output_status; /* of standard output */
};

/* Takes what there is to read of a pipe that does not block; false when memory runs out. */
bool cli_text_take(struct cli_text *text, int pipe);

/* Prints the whole lines of messages there are, and drops them. */
void cli_ordered_messages(struct cli_ordered *ordered, struct cli_text *messages);

/* Ends the frame at an index, takes what it printed, and tells of all frames whose turn has come:
   their messages, their standard output, the tally. False when memory runs out. */
bool cli_ordered_end(struct cli_ordered *ordered, size_t index,
                     const struct cli_frame_result *result, int how, struct cli_text *output,
                     struct cli_text *messages);

/* Room for the frames; false when memory runs out. */
bool cli_ordered_start(struct cli_ordered *ordered, struct cli_job *job,
                       const struct cli_frames *frames, struct cli_tally *tally);
void cli_ordered_release(struct cli_ordered *ordered);

#endif
