/* SPDX-License-Identifier: Apache-2.0 */
/* Lamps in ever larger cells, so that from afar many are seen as one. */
#ifndef MURK_LIGHT_LAMP_TREE_H
#define MURK_LIGHT_LAMP_TREE_H

#include "lamps.h"

/* A zone that is a lamp, or a cell of such. Positions in the grid frame of the medium. */
typedef struct murk_lamp_node {
    double centre[3];       /* of the power [m] */
    double spread[3];       /* variance of the power's position on each axis [m^2] */
    double low[3], high[3]; /* box of the zones [m] */
    double power;           /* sum of kappa_t V times the radiosity [W] */
    double far;             /* it stands for its parts from this distance on [m] */
    double kappa_t;         /* of the zone; of a cell, the largest */
    uint64_t place;         /* order along a Z-shaped curve, in cells of its level */
    size_t first, end;      /* parts, or first == end: a zone */
    const murk_lamp *lamp;  /* the zone's */
} murk_lamp_node;

typedef struct murk_lamp_tree {
    size_t count;         /* parts before the cells that hold them */
    size_t roots;         /* the last of them, which no other holds */
    murk_lamp_node *node; /* zones first */
} murk_lamp_tree;

/* Makes the tree of lamps[0 ... count - 1], zones all, which it keeps pointers to. */
murk_status murk_lamp_tree_create(murk_context *context, const murk_medium *medium,
                                  const murk_lamp *lamps, size_t count, murk_lamp_tree *out);
void murk_lamp_tree_clear(murk_lamp_tree *tree);

/* Called with each node that stands for its zones at a point, and with the zones nearer than that
   of all others. */
typedef void murk_lamp_visit(void *user, const murk_lamp_node *node, const double offset[3]);

/* Visits the tree from a point; offset is from the node's centre to it. */
void murk_lamp_tree_visit(const murk_lamp_tree *tree, const double point[3], murk_lamp_visit *visit,
                          void *user);

#endif
