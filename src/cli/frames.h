/* SPDX-License-Identifier: Apache-2.0 */
/* Numbers of frames: "1-100x2,120". */
#ifndef CLI_FRAMES_H
#define CLI_FRAMES_H

#include "murk/murk.h"

enum {
    CLI_FRAME_MAX = 999999999, /* the largest number, of either sign */
    CLI_FRAME_COUNT_MAX = 1000000
};

/* Frames in the order of running, each once. */
struct cli_frames {
    int *number;
    size_t count;
};

/*
 * Reads a list of frames: numbers and ranges with commas between them, a range FIRST-LAST or
 * FIRST-LASTxSTEP, downwards where FIRST > LAST. A frame that comes up again is dropped. Fails
 * with MURK_ERROR_INPUT for anything else, numbers beyond CLI_FRAME_MAX and longer lists than
 * CLI_FRAME_COUNT_MAX. Released with cli_frames_release().
 */
murk_status cli_frames_parse(const char *text, struct cli_frames *out);

/* Appends a frame. Fails with MURK_ERROR_MEMORY. */
murk_status cli_frames_add(struct cli_frames *frames, int number);

/* Reads a frame's number at *text, which is moved behind it. */
bool cli_frame_read(const char **text, int *out);

/* Sorts the frames in ascending order. */
void cli_frames_sort(struct cli_frames *frames);

/* Writes the frames as "1-5, 7, 10-12", the way cli_frames_parse() reads them but for the spaces;
   "..." stands for what does not fit. */
void cli_frames_text(const struct cli_frames *frames, char *text, size_t size);

void cli_frames_release(struct cli_frames *frames);

#endif
