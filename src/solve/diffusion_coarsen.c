/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From cells to cells twice as large. A face conducts what the lines of faces behind one another
 * do side by side, each from the middle of one cell to the middle of the next: the face between
 * them in series with half of the face inside either. Where the medium is uniform that halves the
 * sum of the faces, as twice the distance demands; a barrier between two conductors stays.
 */
#include "diffusion.h"

#include <stdlib.h>
#include <string.h>

static float in_series(float face, float below, float above)
{
    return 1 / (1 / face + (below + above));
}

static bool allocate(murk_diffusion *d)
{
    d->brick = murk_alloc(d->brick_count, sizeof *d->brick);
    d->neighbour = murk_alloc(d->brick_count, sizeof *d->neighbour);
    d->face = murk_alloc(d->brick_count * murk_diffusion_faces(d->edge), sizeof(float));
    d->sink = murk_alloc(d->brick_count * murk_diffusion_cells(d->edge), sizeof(float));
    return d->brick && d->neighbour && d->face && d->sink;
}

/* ---- within bricks ------------------------------------------------------------------------- */

/* Half the resistance of face p of the lines through `brick`, 0 beyond the bricks. */
static float half_of(const murk_diffusion *fine, int64_t brick, size_t face)
{
    if (brick == MURK_NO_BRICK)
        return 0;
    return 0.5f / fine->face[(size_t)brick * murk_diffusion_faces(fine->edge) + face];
}

static void join_faces(const murk_diffusion *fine, size_t b, int axis, float *face)
{
    const int edge = fine->edge;
    const murk_layout from = murk_face_layout(axis, edge), to = murk_face_layout(axis, edge / 2);
    const int32_t *neighbour = fine->neighbour[b] + 2 * axis;
    for (int p = 0; p <= edge; p += 2)
        for (int u = 0; u < edge; u++)
            for (int v = 0; v < edge; v++) {
                size_t line = from.first + (size_t)u * from.u + (size_t)v * from.v;
                size_t below = line + (size_t)(p ? p - 1 : edge - 1) * from.along;
                size_t above = line + (size_t)(p < edge ? p + 1 : 1) * from.along;
                float t =
                    fine->face[b * murk_diffusion_faces(edge) + line + (size_t)p * from.along];
                face[to.first + (size_t)(p / 2) * to.along + (size_t)(u / 2) * to.u +
                     (size_t)(v / 2) * to.v] +=
                    in_series(t, half_of(fine, p ? (int64_t)b : neighbour[0], below),
                              half_of(fine, p < edge ? (int64_t)b : neighbour[1], above));
            }
}

static murk_status coarsen_within(murk_context *context, const murk_diffusion *fine,
                                  murk_diffusion *out)
{
    const size_t bricks = fine->brick_count, cells = murk_diffusion_cells(fine->edge);
    memcpy(out->brick, fine->brick, bricks * sizeof *out->brick);
    memcpy(out->neighbour, fine->neighbour, bricks * sizeof *out->neighbour);
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t b = 0; b < bricks; b++) {
        for (int a = 0; a < 3; a++)
            join_faces(fine, b, a, out->face + b * murk_diffusion_faces(out->edge));
        for (int i = 0; i < (int)cells; i++) {
            int e = fine->edge, x = i / e / e / 2, y = i / e % e / 2, z = i % e / 2;
            out->sink[b * cells / 8 + (size_t)((x * out->edge + y) * out->edge + z)] +=
                fine->sink[b * cells + (size_t)i];
        }
    }
    return MURK_OK;
}

/* ---- bricks of one cell -------------------------------------------------------------------- */

struct member {
    int32_t parent[3], child;
};

static int compare_members(const void *a, const void *b)
{
    const struct member *u = a, *v = b;
    int order = murk_brick_compare(u->parent, v->parent);
    return order ? order : (u->child > v->child) - (u->child < v->child);
}

static int32_t find(const murk_diffusion *d, const int32_t at[3])
{
    size_t low = 0, high = d->brick_count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        int order = murk_brick_compare(d->brick[middle], at);
        if (!order)
            return (int32_t)middle;
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return MURK_NO_BRICK;
}

static void find_neighbours(murk_diffusion *d)
{
    for (size_t b = 0; b < d->brick_count; b++)
        for (int side = 0; side < 6; side++) {
            int32_t at[3] = {d->brick[b][0], d->brick[b][1], d->brick[b][2]};
            at[side / 2] += side & 1 ? 1 : -1;
            d->neighbour[b][side] = find(d, at);
        }
}

/* What one child adds through one of its faces to the parent's. */
static void join_side(const murk_diffusion *fine, size_t b, int side, size_t parent,
                      murk_diffusion *out)
{
    const float *t = fine->face + 6 * b;
    const int32_t beyond = fine->neighbour[b][side], sibling = fine->neighbour[b][side ^ 1];
    const bool outward = (fine->brick[b][side / 2] & 1) == (side & 1);
    if (!outward) { /* to the sibling, or to where it would be */
        if (beyond == MURK_NO_BRICK)
            out->sink[parent] += t[side];
        return;
    }
    float own = sibling == MURK_NO_BRICK ? 0 : 0.5f / t[side ^ 1], theirs = 0;
    if (beyond != MURK_NO_BRICK && fine->neighbour[beyond][side] != MURK_NO_BRICK)
        theirs = 0.5f / fine->face[6 * (size_t)beyond + (size_t)side];
    float joined = in_series(t[side], own, theirs);
    /* Where some children end and others go on, what ends counts as lost in the cell. */
    if (beyond == MURK_NO_BRICK && out->neighbour[parent][side] != MURK_NO_BRICK)
        out->sink[parent] += joined;
    else
        out->face[6 * parent + (size_t)side] += joined;
}

static murk_status coarsen_bricks(murk_context *context, const murk_diffusion *fine,
                                  murk_diffusion *out, int32_t **parent)
{
    const size_t bricks = fine->brick_count;
    struct member *members = murk_alloc(bricks, sizeof *members);
    int32_t *of = murk_alloc(bricks, sizeof *of);
    for (size_t b = 0; members && b < bricks; b++) {
        members[b].child = (int32_t)b;
        for (int a = 0; a < 3; a++)
            members[b].parent[a] = fine->brick[b][a] >> 1;
    }
    if (members)
        qsort(members, bricks, sizeof *members, compare_members);
    out->brick_count = 0;
    for (size_t i = 0; members && of && i < bricks; i++) {
        out->brick_count += !i || murk_brick_compare(members[i].parent, members[i - 1].parent);
        of[members[i].child] = (int32_t)out->brick_count - 1;
    }
    if (!members || !of || !allocate(out)) {
        murk_free(members);
        murk_free(of);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu bricks", bricks);
    }
    for (size_t i = 0; i < bricks; i++)
        memcpy(out->brick[of[members[i].child]], members[i].parent, sizeof *out->brick);
    find_neighbours(out);
    for (size_t b = 0; b < bricks; b++) {
        out->sink[of[b]] += fine->sink[b];
        for (int side = 0; side < 6; side++)
            join_side(fine, b, side, (size_t)of[b], out);
    }
    murk_free(members);
    *parent = of;
    return MURK_OK;
}

murk_status murk_diffusion_coarsen(murk_context *context, const murk_diffusion *fine,
                                   murk_diffusion *out, int32_t **parent)
{
    murk_diffusion d = {.brick_count = fine->brick_count};
    murk_status status;
    d.edge = fine->edge > 1 ? fine->edge / 2 : 1;
    *parent = NULL;
    if (fine->edge == 1)
        status = coarsen_bricks(context, fine, &d, parent);
    else if (allocate(&d))
        status = coarsen_within(context, fine, &d);
    else
        status = murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu bricks",
                           fine->brick_count);
    if (status)
        murk_diffusion_clear(&d);
    else
        *out = d;
    return status;
}
