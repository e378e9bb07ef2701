/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The finest level of the multigrid, on voxels. Its matrix is made anew from kappa_t, brick by
 * brick and both times it is needed, because keeping it would take more memory than all the rest.
 */
#include "preconditioner.h"

#include "multigrid.h"

#include <string.h>

/* A brick's voxels with a layer around them; edges and corners are there but not used. */
enum { N = MURK_BRICK_EDGE, P = N + 2, I = P * P, J = P, PADDED = P * P * P, COARSE = N / 2 };

static const float DAMPING = 0.9f;

struct murk_preconditioner {
    const murk_medium *medium;
    murk_voxel_shape shape;
    bool cubic;
    murk_multigrid *coarse;
};

/* A brick with its neighbours' nearest layers. */
struct block {
    float kappa_t[PADDED], albedo[PADDED];
    float source[PADDED];        /* W r */
    float resistance[3][PADDED]; /* half of a voxel's along each axis */
    const float *along[3];       /* that of each axis */
    float conductance[PADDED];   /* sum of area / resistance */
    float sink[PADDED];
    float step[PADDED];  /* of damped Jacobi */
    float share[PADDED]; /* of x in that of its cell, as murk_diffusion_create() has it */
    float x[PADDED];
    float coarse[(COARSE + 2) * (COARSE + 2) * (COARSE + 2)];
    float residual[MURK_BRICK_SLOTS]; /* source - C x */
};

murk_status murk_preconditioner_create(murk_context *context, const murk_medium *medium,
                                       murk_preconditioner **out)
{
    murk_preconditioner *made = murk_alloc(1, sizeof *made);
    if (!made)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory");
    made->medium = medium;
    made->shape = murk_voxel_shape_of(medium->grid);
    made->cubic =
        made->shape.edge[0] == made->shape.edge[1] && made->shape.edge[1] == made->shape.edge[2];
    murk_status status = murk_multigrid_create(context, medium, &made->coarse);
    if (status)
        murk_preconditioner_release(made);
    else
        *out = made;
    return status;
}

void murk_preconditioner_release(murk_preconditioner *preconditioner)
{
    if (!preconditioner)
        return;
    murk_multigrid_release(preconditioner->coarse);
    murk_free(preconditioner);
}

/* ---- a brick and the layer around it ------------------------------------------------------- */

/* Copies a field on bricks of n^3 into an array padded by one on each side, with 0 beyond. */
static inline void pad(const float *field, size_t brick, const int32_t neighbour[6], int n,
                       float *padded)
{
    static const float nothing[MURK_BRICK_SLOTS];
    const int p = n + 2, layer = n * n;
    const float *own = field + brick * (size_t)(n * layer), *beside[6];
    float *inner = padded + p * p + p + 1;
    for (int s = 0; s < 6; s++)
        beside[s] = neighbour[s] == MURK_NO_BRICK
                        ? nothing
                        : field + (size_t)neighbour[s] * (size_t)(n * layer);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            float *row = inner + (i * p + j) * p;
            for (int k = 0; k < n; k++)
                row[k] = own[i * layer + j * n + k];
            row[-1] = beside[4][i * layer + j * n + n - 1];
            row[n] = beside[5][i * layer + j * n];
        }
    for (int u = 0; u < n; u++)
        for (int v = 0; v < n; v++) {
            inner[(u - p) * p + v] = beside[0][(n - 1) * layer + u * n + v];
            inner[(u + n * p) * p + v] = beside[1][u * n + v];
            inner[(u * p - 1) * p + v] = beside[2][u * layer + (n - 1) * n + v];
            inner[(u * p + n) * p + v] = beside[3][u * layer + v];
        }
}

/* The half resistances, with a vacuum where there is no brick, and the conductance of each voxel.
   The layers around a brick serve one axis each, so that the axes of cubic voxels can share theirs.
 */
static void resist(const murk_preconditioner *p, const int32_t neighbour[6], struct block *block)
{
    const int axes = p->cubic ? 1 : 3;
    memset(block->conductance, 0, sizeof block->conductance);
    for (int a = 0; a < axes; a++) {
        const float edge = p->shape.edge[a], area = (p->cubic ? 3 : 1) * p->shape.area[a];
        for (int i = 0; i < PADDED; i++) {
            float resistance = murk_half_resistance(edge * block->kappa_t[i]);
            block->resistance[a][i] = resistance;
            block->conductance[i] += area / resistance;
        }
    }
    for (int a = 0; a < 3; a++)
        block->along[a] = block->resistance[a % axes];
    for (int s = 0; s < 6; s++) {
        const int strides[3] = {I, J, 1}, axis = s / 2;
        const int along = strides[axis], u = strides[axis ? 0 : 1], v = strides[axis == 2 ? 1 : 2];
        float *layer = block->resistance[axis % axes] + (s & 1 ? (P - 1) * along : 0);
        for (int n = 0; neighbour[s] == MURK_NO_BRICK && n < P * P; n++)
            layer[n / P * u + n % P * v] = MURK_VACUUM;
    }
}

/* Sets up the matrix around a brick, W r, and x = D^-1 W r: the first sweep of Jacobi from zero,
   damped and with D what the diagonal would be among equal voxels, which is never too small. */
static void load(const murk_preconditioner *p, const float *r, size_t brick, struct block *block)
{
    const murk_medium *medium = p->medium;
    const int32_t *neighbour = murk_multigrid_neighbours(p->coarse, brick);
    pad(medium->kappa_t, brick, neighbour, N, block->kappa_t);
    pad(r, brick, neighbour, N, block->source);
    if (medium->albedo.field)
        pad(medium->albedo.field, brick, neighbour, N, block->albedo);
    else
        for (int i = 0; i < PADDED; i++)
            block->albedo[i] = medium->albedo.constant;
    resist(p, neighbour, block);
    for (int i = 0; i < PADDED; i++) {
        float albedo = block->albedo[i];
        float weight = murk_zone_weight(&p->shape, block->kappa_t[i], albedo);
        block->source[i] *= weight;
        block->sink[i] = (1 - albedo) * weight;
        block->step[i] = DAMPING / (block->conductance[i] + block->sink[i]);
        block->share[i] = block->conductance[i] * block->step[i] / DAMPING;
        block->x[i] = block->step[i] * block->source[i];
    }
}

static void find_residual(const murk_voxel_shape *shape, struct block *block)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const int first = (i + 1) * I + (j + 1) * J + 1;
            const float *x = block->x + first, *rx = block->along[0] + first,
                        *ry = block->along[1] + first, *rz = block->along[2] + first;
            float *out = block->residual + i * N * N + j * N;
            for (int k = 0; k < N; k++) {
                float lost_x = (x[k] - x[k - I]) / (rx[k] + rx[k - I]) +
                               (x[k] - x[k + I]) / (rx[k] + rx[k + I]);
                float lost_y = (x[k] - x[k - J]) / (ry[k] + ry[k - J]) +
                               (x[k] - x[k + J]) / (ry[k] + ry[k + J]);
                float lost_z = (x[k] - x[k - 1]) / (rz[k] + rz[k - 1]) +
                               (x[k] - x[k + 1]) / (rz[k] + rz[k + 1]);
                out[k] = block->source[first + k] - block->sink[first + k] * x[k] -
                         shape->area[0] * lost_x - shape->area[1] * lost_y -
                         shape->area[2] * lost_z;
            }
        }
}

/* ---- both halves of the cycle -------------------------------------------------------------- */

static void restrict_residual(const struct block *block, float *source)
{
    for (int i = 0; i < COARSE * COARSE * COARSE; i++)
        source[i] = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            for (int k = 0; k < N; k++)
                source[(i / 2 * COARSE + j / 2) * COARSE + k / 2] +=
                    block->share[(i + 1) * I + (j + 1) * J + k + 1] *
                    block->residual[(i * N + j) * N + k];
}

static void add_coarse(struct block *block)
{
    enum { C = COARSE + 2 };
    for (int i = 0; i < P; i++)
        for (int j = 0; j < P; j++)
            for (int k = 0; k < P; k++)
                block->x[i * I + j * J + k] +=
                    block->share[i * I + j * J + k] *
                    block->coarse[((i + 1) / 2 * C + (j + 1) / 2) * C + (k + 1) / 2];
}

/* Jacobi's method for slopes: of its slope's light a zone loses 1 - albedo, and through its faces
   what an opaque one does, 3 / (2 tau) through those that the slope leads to and 1 / (2 tau)
   through each other pair, or all. */
static void scale_slopes(const murk_preconditioner *p, const murk_system *system, const float *r,
                         float *z)
{
    const murk_medium *medium = p->medium;
    const float *edge = p->shape.edge;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t j = 0; j < system->slopes; j++) {
        size_t i = murk_bent_slot(system->bent, j);
        float albedo = murk_value(&medium->albedo, i), kappa_t = medium->kappa_t[i] + 1e-30f;
        float leak = 1 / edge[j / MURK_BRICK_SLOTS % 3];
        for (int a = 0; a < 3; a++)
            leak += 0.5f / edge[a];
        leak /= kappa_t;
        z[j] = albedo > 0 ? r[j] / (1 - albedo + albedo * leak / (1 + leak)) : 0;
    }
}

void murk_preconditioner_apply(murk_preconditioner *preconditioner, const murk_system *system,
                               const murk_vector *r, murk_vector *z)
{
    const murk_medium *medium = preconditioner->medium;
    const size_t bricks = medium->grid->brick_count;
    float *source = murk_multigrid_source(preconditioner->coarse);
#pragma omp parallel num_threads(system->context->threads)
    {
        struct block block = {.x = {0}};
#pragma omp for schedule(static)
        for (size_t b = 0; b < bricks; b++) {
            load(preconditioner, r->zone, b, &block);
            find_residual(&preconditioner->shape, &block);
            restrict_residual(&block, source + b * COARSE * COARSE * COARSE);
        }
    }
    murk_multigrid_cycle(system->context, preconditioner->coarse);
    const float *solution = murk_multigrid_solution(preconditioner->coarse);
#pragma omp parallel num_threads(system->context->threads)
    {
        struct block block = {.x = {0}};
#pragma omp for schedule(static)
        for (size_t b = 0; b < bricks; b++) {
            load(preconditioner, r->zone, b, &block);
            pad(solution, b, murk_multigrid_neighbours(preconditioner->coarse, b), COARSE,
                block.coarse);
            add_coarse(&block);
            find_residual(&preconditioner->shape, &block);
            for (int s = 0; s < MURK_BRICK_SLOTS; s++) {
                const size_t i = b * MURK_BRICK_SLOTS + (size_t)s;
                const int at = ((s >> 6) + 1) * I + ((s >> 3 & 7) + 1) * J + (s & 7) + 1;
                bool scatters = block.kappa_t[at] > 0 && block.albedo[at] > 0;
                z->zone[i] =
                    scatters ? r->zone[i] + block.x[at] + block.step[at] * block.residual[s] : 0;
            }
        }
    }
    scale_slopes(preconditioner, system, r->slope, z->slope);
    for (size_t i = 0; i < system->patches; i++)
        z->patch[i] = r->patch[i];
}
