/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Paths that stand for the files of a sequence. The frame's number goes where a path holds
 *   ####          with as many digits at least as there are #
 *   %04d, %d      with 4 digits at least, with as many as it takes
 *   $F4, $F       the same; a letter behind makes it a variable of another name
 * in all places alike, those in the names of folders too. What is there under just its name is
 * meant by that name: /proj#1/plume.####.vdb has one place where there is a folder /proj#1. A minus
 * sign counts as a digit, as for printf's %04d.
 */
#ifndef CLI_PATTERN_H
#define CLI_PATTERN_H

#include "frames.h"

/* Whether a path holds a place for the frame. */
bool cli_pattern_has(const char *path);

/* Whether a path to be read is a pattern: it holds a place, and no file has just this name. */
bool cli_pattern_is_input(const char *path);

/* The path of a frame, from malloc; NULL when memory runs out. */
char *cli_pattern_expand(const char *path, int frame);

/* The frames of a pattern that are on disk, in ascending order; none is no failure. Fails with
   MURK_ERROR_MEMORY. Released with cli_frames_release(). */
murk_status cli_pattern_find(const char *path, struct cli_frames *out);

#endif
