/* SPDX-License-Identifier: Apache-2.0 */
#include "bricks.h"

#include "context.h"

#include <string.h>

void murk_bricks_clear(murk_bricks *bricks)
{
    murk_free(bricks->brick);
    murk_free(bricks->mask);
    murk_free(bricks->values);
    memset(bricks, 0, sizeof *bricks);
}
