/* SPDX-License-Identifier: Apache-2.0 */
/* What the frames of a sequence came to, told in their order. */
#ifndef CLI_TALLY_H
#define CLI_TALLY_H

#include "frame.h"
#include "frames.h"

struct cli_tally {
    murk_status worst; /* of the frames told so far */
    size_t skipped;
    struct cli_frames failed, not_reached;
    bool told_unsteady;
};

/* Counts a frame, and warns once about what frames leave open. To be called in the order of the
   sequence. */
void cli_tally_add(struct cli_tally *tally, struct cli_job *job, int frame,
                   const struct cli_frame_result *result);

/* Says what came of count frames in all, and releases the lists; gives the sequence's status. */
murk_status cli_tally_end(struct cli_tally *tally, struct cli_job *job, size_t count);

/* The worse of two: a failure of the system before bad input before a tolerance that is not
   reached. */
murk_status cli_worse(murk_status a, murk_status b);

#endif
