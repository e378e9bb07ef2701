/* SPDX-License-Identifier: Apache-2.0 */
#include "multigrid.h"

#include <string.h>

/* Bricks of one cell halve in number along each axis until none has a neighbour; brick coordinates
   have 29 bits. */
enum { MOST_LEVELS = 3 + 30, MOST_CELLS = 64 };

/* Jacobi is damped so that it does not swing on the roughest modes: C < 2 diagonal(C). */
static const float DAMPING = 0.9f;

struct level {
    murk_diffusion matrix;
    int32_t *parent; /* of its bricks on the next level, where it has but one cell a brick */
    size_t cells;
    float *inverse; /* DAMPING / C_ii; undamped on the last level */
    float *b, *x, *next;
};

struct murk_multigrid {
    int count;
    struct level level[MOST_LEVELS];
};

/* ---- creation ------------------------------------------------------------------------------ */

static bool scattered(const murk_diffusion *matrix)
{
    for (size_t b = 0; b < matrix->brick_count; b++)
        for (int side = 0; side < 6; side++)
            if (matrix->edge > 1 || matrix->neighbour[b][side] != MURK_NO_BRICK)
                return false;
    return true;
}

static murk_status make_vectors(murk_context *context, struct level *level, bool last)
{
    const size_t cells = level->matrix.brick_count * murk_diffusion_cells(level->matrix.edge);
    level->cells = cells;
    level->inverse = murk_alloc(cells, sizeof(float));
    level->b = murk_alloc(cells, sizeof(float));
    level->x = murk_alloc(cells, sizeof(float));
    level->next = murk_alloc(last ? 0 : cells, sizeof(float));
    if (!level->inverse || !level->b || !level->x || !level->next)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for %zu cells", cells);
    murk_diffusion_invert_diagonal(&level->matrix, level->inverse);
    for (size_t i = 0; !last && i < cells; i++)
        level->inverse[i] *= DAMPING;
    return MURK_OK;
}

murk_status murk_multigrid_create(murk_context *context, const murk_medium *medium,
                                  murk_multigrid **out)
{
    murk_multigrid *multigrid = murk_alloc(1, sizeof *multigrid);
    if (!multigrid)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    multigrid->count = 1;
    struct level *level = multigrid->level;
    murk_status status = murk_diffusion_create(context, medium, &level->matrix);
    for (; !status; level++) {
        bool last = scattered(&level->matrix) || multigrid->count == MOST_LEVELS;
        status = make_vectors(context, level, last);
        if (status || last)
            break;
        status = murk_diffusion_coarsen(context, &level->matrix, &level[1].matrix, &level->parent);
        multigrid->count++;
    }
    if (status)
        murk_multigrid_release(multigrid);
    else
        *out = multigrid;
    return status;
}

void murk_multigrid_release(murk_multigrid *multigrid)
{
    if (!multigrid)
        return;
    for (int i = 0; i < multigrid->count; i++) {
        struct level *level = &multigrid->level[i];
        murk_diffusion_clear(&level->matrix);
        murk_free(level->parent);
        murk_free(level->inverse);
        murk_free(level->b);
        murk_free(level->x);
        murk_free(level->next);
    }
    murk_free(multigrid);
}

float *murk_multigrid_source(murk_multigrid *multigrid)
{
    return multigrid->level[0].b;
}

const float *murk_multigrid_solution(const murk_multigrid *multigrid)
{
    return multigrid->level[0].x;
}

const int32_t *murk_multigrid_neighbours(const murk_multigrid *multigrid, size_t brick)
{
    return multigrid->level[0].matrix.neighbour[brick];
}

/* ---- the cycle ----------------------------------------------------------------------------- */

/* Sweeps over levels with one cell a brick are too short to share out. */
static int threads_for(const murk_context *context, const struct level *level)
{
    return level->matrix.edge > 1 ? context->threads : 1;
}

/* x = D^-1 b, the first sweep from zero. */
static void begin(const murk_context *context, struct level *level)
{
#pragma omp parallel for num_threads(threads_for(context, level)) schedule(static)
    for (size_t i = 0; i < level->cells; i++)
        level->x[i] = level->inverse[i] * level->b[i];
}

/* x += D^-1 (b - C x) */
static void smooth(const murk_context *context, struct level *level)
{
    const size_t cells = murk_diffusion_cells(level->matrix.edge);
#pragma omp parallel for num_threads(threads_for(context, level)) schedule(static)
    for (size_t b = 0; b < level->matrix.brick_count; b++) {
        float r[MOST_CELLS];
        murk_diffusion_residual(&level->matrix, b, level->b, level->x, r);
        for (size_t i = 0; i < cells; i++)
            level->next[b * cells + i] =
                level->x[b * cells + i] + level->inverse[b * cells + i] * r[i];
    }
    float *x = level->x;
    level->x = level->next;
    level->next = x;
}

/* Number of the cell of the next level, in the same brick, that cell i of a brick belongs to. */
static size_t coarse_cell(size_t i, int edge)
{
    size_t e = (size_t)edge, half = e / 2;
    return (i / e / e / 2 * half + i / e % e / 2) * half + i % e / 2;
}

/* Sums the residual over the cells of the next level. */
static void restrict_to(const murk_context *context, struct level *level, struct level *next)
{
    const size_t cells = murk_diffusion_cells(level->matrix.edge);
    memset(next->b, 0, next->cells * sizeof(float));
#pragma omp parallel for num_threads(threads_for(context, level)) schedule(static)
    for (size_t b = 0; b < level->matrix.brick_count; b++) {
        float r[MOST_CELLS];
        murk_diffusion_residual(&level->matrix, b, level->b, level->x, r);
        if (level->parent)
            next->b[level->parent[b]] += r[0];
        else
            for (size_t i = 0; i < cells; i++)
                next->b[b * cells / 8 + coarse_cell(i, level->matrix.edge)] += r[i];
    }
}

static void add_from(const murk_context *context, struct level *level, const struct level *next)
{
    const size_t cells = murk_diffusion_cells(level->matrix.edge);
#pragma omp parallel for num_threads(threads_for(context, level)) schedule(static)
    for (size_t b = 0; b < level->matrix.brick_count; b++) {
        if (level->parent)
            level->x[b] += next->x[level->parent[b]];
        else
            for (size_t i = 0; i < cells; i++)
                level->x[b * cells + i] +=
                    next->x[b * cells / 8 + coarse_cell(i, level->matrix.edge)];
    }
}

void murk_multigrid_cycle(murk_context *context, murk_multigrid *multigrid)
{
    struct level *level = multigrid->level, *last = level + multigrid->count - 1;
    for (; level < last; level++) {
        begin(context, level);
        smooth(context, level);
        restrict_to(context, level, level + 1);
    }
    begin(context, last);
    while (level-- > multigrid->level) {
        add_from(context, level, level + 1);
        smooth(context, level);
        smooth(context, level);
    }
}
