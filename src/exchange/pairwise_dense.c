/* SPDX-License-Identifier: Apache-2.0 */
/* All exchange factors of any medium, zone by zone. */
#include "factor_far.h"
#include "factor_near.h"
#include "factor_offset.h"
#include "factor_patch.h"
#include "pairwise_state.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Distances in units of the longest zone edge. */
static const double NEAR = 3;  /* up to here factors come from the lines through each zone */
static const double EXACT = 8; /* up to here the integral of 1/r^2 is exact */

/* The integral of 1/(pi r^2) over two zones by offset [m^4]. */
typedef struct geometry {
    const double *size;
    int reach[3];
    double *table;
} geometry;

static double longest_edge(const double size[3])
{
    return fmax(size[0], fmax(size[1], size[2]));
}

static void set_reach(const murk_grid *grid, double distance, int reach[3])
{
    for (int a = 0; a < 3; a++) {
        double cells = floor(distance * longest_edge(grid->voxel) / grid->voxel[a] + 1e-6);
        reach[a] = (int)fmin(cells, (double)grid->hi[a] - grid->lo[a] - 1);
    }
}

static bool geometry_create(geometry *g, const murk_grid *grid, int threads)
{
    g->size = grid->voxel;
    set_reach(grid, EXACT, g->reach);
    const int n[3] = {g->reach[0] + 1, g->reach[1] + 1, g->reach[2] + 1};
    g->table = murk_alloc((size_t)n[0] * (size_t)n[1] * (size_t)n[2], sizeof(double));
    if (!g->table)
        return false;
#pragma omp parallel for schedule(dynamic, 16) num_threads(threads)
    for (int i = 0; i < n[0] * n[1] * n[2]; i++) {
        const int offset[3] = {i / (n[1] * n[2]), i / n[2] % n[1], i % n[2]};
        g->table[i] = murk_factor_offset_zone(g->size, offset, 0);
    }
    return true;
}

static double geometry_factor(const geometry *g, const int offset[3])
{
    size_t index = 0;
    bool inside = true;
    double distance[3];
    for (int a = 0; a < 3; a++) {
        int d = abs(offset[a]);
        inside = inside && d <= g->reach[a];
        index = index * ((size_t)g->reach[a] + 1) + (size_t)d;
        distance[a] = d * g->size[a];
    }
    return inside ? g->table[index] : murk_far_geometry(g->size, distance);
}

static bool is_near(const double size[3], const int offset[3])
{
    double r2 = 0, limit = NEAR * longest_edge(size) * (1 + 1e-6);
    for (int a = 0; a < 3; a++)
        r2 += offset[a] * size[a] * offset[a] * size[a];
    return r2 <= limit * limit;
}

static double pair_weight(const murk_pairwise *p, const int offset[3])
{
    double weight = 1;
    for (int a = 0; a < 3; a++)
        weight *= murk_window_weight(p, a, offset[a]);
    return weight;
}

static void pair_offset(const murk_pairwise *p, size_t m, size_t k, int offset[3])
{
    for (int a = 0; a < 3; a++)
        offset[a] = p->cell[k][a] - p->cell[m][a];
}

static double kappa_of(const murk_pairwise *p, size_t zone)
{
    return p->sight.kappa_t[p->slot[zone]];
}

/* Where the light of each zone goes, apart from the zones near it [m^2]. */
typedef struct leaving {
    double *up, *down, *ground; /* as in murk_near */
    double *far;                /* to zones that are not near */
} leaving;

/* Row m as the lines through zone m have it: near factors (-1 where no line met the neighbour),
   self-factor, and what leaves the medium without meeting a patch. */
static void near_row(murk_pairwise *p, const geometry *g, const murk_lines_through *lines, size_t m,
                     murk_near *near, leaving *out)
{
    double kappa = kappa_of(p, m);
    int offset[3] = {0, 0, 0};
    float *row = p->matrix + m * p->zones;
    murk_near_trace(&p->sight, lines, p->cell[m], kappa, near);
    double thin = kappa * kappa * geometry_factor(g, offset);
    p->self[m] = near->chord > 0 ? thin * near->self / near->chord : thin;
    out->up[m] = p->weight[m] * near->up;
    out->down[m] = p->weight[m] * near->down;
    out->ground[m] = p->weight[m] * near->ground;
    double far = 1 - near->self - near->up - near->down - near->ground;
    for (size_t i = 0; near->patch && i < p->other_count; i++)
        p->other_matrix[m * p->other_count + i] = (float)(p->weight[m] * near->patch[p->other[i]]);
    for (size_t k = 0; k < p->zones; k++) {
        pair_offset(p, m, k, offset);
        if (k == m || !is_near(g->size, offset))
            continue;
        size_t index = 0;
        for (int a = 0; a < 3; a++)
            index = index * (size_t)(2 * near->reach[a] + 1) + (size_t)(offset[a] + near->reach[a]);
        row[k] = near->length[index] > 0
                     ? (float)(kappa * kappa_of(p, k) * geometry_factor(g, offset) *
                               near->caught[index] / near->length[index])
                     : -1;
        far -= kappa_of(p, k) * near->caught[index];
    }
    out->far[m] = p->weight[m] * fmax(0, far);
}

/* The rest of row m up to the diagonal, and the same column. */
static void finish_row(murk_pairwise *p, const geometry *g, size_t m)
{
    for (size_t k = 0; k < m; k++) {
        int offset[3];
        pair_offset(p, m, k, offset);
        double weight = pair_weight(p, offset), factor = 0;
        float *one = p->matrix + m * p->zones + k, *other = p->matrix + k * p->zones + m;
        if (weight > 0 && is_near(g->size, offset) && *one >= 0 && *other >= 0)
            factor = ((double)*one + (double)*other) / 2;
        else if (weight > 0)
            factor = kappa_of(p, m) * kappa_of(p, k) * geometry_factor(g, offset) *
                     murk_far_attenuation(&p->sight, p->cell[m], p->cell[k], kappa_of(p, m),
                                          kappa_of(p, k));
        *one = *other = (float)(weight * factor);
    }
}

/* What the lines say over what the factors sum to, where both are sure enough to tell. */
static double correction(double lines, double sum, double weight)
{
    return sum > 0 && lines > 0.002 * weight ? fmin(2, fmax(0.5, lines / sum)) : 1;
}

/*
 * Factors of far zones and patches are even, but a few lines between two thick zones miss their
 * corners, from which most of the light escapes. The lines through a zone are scattered over single
 * far elements but right for their sum: each row's factors are scaled to it. In thin media the few
 * lines are the better of the two.
 */
static bool correct_far(murk_pairwise *p, const geometry *g, const leaving *out)
{
    double *root = murk_alloc(p->zones, sizeof *root);
    if (!root)
        return false;
#pragma omp parallel num_threads(p->threads)
    {
#pragma omp for
        for (size_t m = 0; m < p->zones; m++) {
            float *row = p->matrix + m * p->zones, *patch = p->other_matrix + m * p->other_count;
            double sum = 0, ground = 0;
            for (size_t k = 0; k < p->zones; k++) {
                int offset[3];
                pair_offset(p, m, k, offset);
                sum += is_near(g->size, offset) ? 0 : row[k];
            }
            root[m] = p->windowed ? 1 : sqrt(correction(out->far[m], sum, p->weight[m]));
            for (size_t i = 0; i < p->other_count; i++)
                ground += patch[i];
            double scale = correction(out->ground[m], ground, p->weight[m]);
            for (size_t i = 0; i < p->other_count; i++)
                patch[i] *= (float)scale;
        }
#pragma omp for
        for (size_t m = 0; m < p->zones; m++)
            for (size_t k = 0; k < p->zones; k++) {
                int offset[3];
                pair_offset(p, m, k, offset);
                if (!is_near(g->size, offset))
                    p->matrix[m * p->zones + k] *= (float)(root[m] * root[k]);
            }
    }
    murk_free(root);
    return true;
}

/* Sum of row k over all zones and patches with the scales d of zones, c of patches, and what
   leaves. */
static double row_sum(const murk_pairwise *p, size_t k, const double *d, const double *c,
                      double escape)
{
    double sum = p->self[k] * d[k] + escape;
    const float *row = p->matrix + k * p->zones, *patch = p->other_matrix + k * p->other_count;
    for (size_t j = 0; j < p->zones; j++)
        sum += row[j] * d[j];
    for (size_t i = 0; i < p->other_count; i++)
        sum += patch[i] * c[i];
    return d[k] * sum;
}

/* A patch cannot see more zones than fill its sky: where the factors with zone scales d sum to more
   than its area, c brings them down to it. */
static void bound_patches(const murk_pairwise *p, const double *d, double *c)
{
#pragma omp parallel for num_threads(p->threads)
    for (size_t i = 0; i < p->other_count; i++) {
        double sum = 0, area = p->area[p->other[i]];
        for (size_t k = 0; k < p->zones; k++)
            sum += d[k] * p->other_matrix[k * p->other_count + i];
        c[i] = sum > area ? area / sum : 1;
    }
}

/*
 * Scales zones by factors close to 1 so that every row comes to 4 kappa V. Each factor carries an
 * error of its own quadrature (of order 1e-3); unless rows close, conservative thick media would
 * gain or lose that much at every scattering. Symmetric, so reciprocity stays.
 */
static bool close_rows(murk_pairwise *p, double *up, double *down)
{
    double *d = murk_alloc(p->zones, sizeof *d), *sum = murk_alloc(p->zones, sizeof *sum);
    double *c = murk_alloc(p->other_count, sizeof *c);
    if (!d || !sum || !c) {
        murk_free(d);
        murk_free(sum);
        murk_free(c);
        return false;
    }
    for (size_t k = 0; k < p->zones; k++)
        d[k] = 1;
    for (int pass = 0; pass < 16; pass++) {
        bound_patches(p, d, c);
#pragma omp parallel for num_threads(p->threads)
        for (size_t k = 0; k < p->zones; k++)
            sum[k] = row_sum(p, k, d, c, up[k] + down[k]);
        for (size_t k = 0; k < p->zones; k++)
            d[k] *= sqrt(p->weight[k] / sum[k]);
    }
    bound_patches(p, d, c);
#pragma omp parallel for num_threads(p->threads)
    for (size_t k = 0; k < p->zones; k++) {
        for (size_t j = 0; j < p->zones; j++) {
            /* The same product in the same order on both sides of the diagonal. */
            double scale = j < k ? d[j] * d[k] : d[k] * d[j];
            p->matrix[k * p->zones + j] = (float)(scale * p->matrix[k * p->zones + j]);
        }
        for (size_t i = 0; i < p->other_count; i++)
            p->other_matrix[k * p->other_count + i] *= (float)(d[k] * c[i]);
        p->self[k] *= d[k] * d[k];
        up[k] *= d[k];
        down[k] *= d[k];
    }
    for (size_t k = 0; k < p->zones; k++)
        d[k] = 1;
    for (size_t i = 0; i < p->other_count; i++)
        c[i] = 1;
    for (size_t k = 0; k < p->zones; k++) { /* what rounding left over goes where there is most */
        double rest = p->weight[k] - row_sum(p, k, d, c, up[k] + down[k]);
        double *largest = up[k] > down[k] ? up + k : down + k;
        *(*largest > p->self[k] ? largest : p->self + k) += rest;
    }
    murk_free(d);
    murk_free(sum);
    murk_free(c);
    return true;
}

static bool fill(murk_context *context, murk_pairwise *p, const geometry *g,
                 const murk_lines_through *lines, leaving *out)
{
    bool complete = true, cut = p->sight.clearance < 0;
    size_t done = 0;
#pragma omp parallel num_threads(p->threads)
    {
        murk_near near;
        set_reach(p->sight.grid, NEAR, near.reach);
        near.length = murk_alloc(murk_near_count(near.reach), sizeof(double));
        near.caught = murk_alloc(murk_near_count(near.reach), sizeof(double));
        near.patch = cut ? murk_alloc(p->patches, sizeof(double)) : NULL;
        if (!near.length || !near.caught || (cut && !near.patch))
#pragma omp atomic write
            complete = false;
#pragma omp barrier
        bool go;
#pragma omp atomic read
        go = complete;
        if (go) {
#pragma omp for schedule(dynamic, 4)
            for (size_t m = 0; m < p->zones; m++)
                near_row(p, g, lines, m, &near, out);
#pragma omp for schedule(dynamic, 4)
            for (size_t m = 0; m < p->zones; m++) {
                finish_row(p, g, m);
                size_t now;
#pragma omp atomic capture
                now = ++done;
                if (omp_get_thread_num() == 0)
                    murk_progress(context, "factors",
                                  (double)now * (double)now /
                                      ((double)p->zones * (double)p->zones));
            }
        }
        murk_free(near.length);
        murk_free(near.caught);
        murk_free(near.patch);
    }
    return complete;
}

murk_status murk_pairwise_dense(murk_context *context, murk_pairwise *p)
{
    geometry g = {0};
    murk_lines_through lines = {0};
    size_t n = p->zones;
    double *rest = murk_alloc(3 * n, sizeof *rest);
    leaving out = {.up = p->sky, .down = rest, .ground = rest + n, .far = rest + 2 * n};
    p->matrix = murk_alloc(n * n, sizeof *p->matrix);
    p->self = murk_alloc(n, sizeof *p->self);
    bool thick = p->sight.kappa_max * longest_edge(p->sight.grid->voxel) > 0.15;
    murk_status status = MURK_ERROR_MEMORY;
    if (rest && p->matrix && p->self && geometry_create(&g, p->sight.grid, p->threads) &&
        !murk_lines_through_create(context, murk_lines_through_base(1 << 19, n), &lines) &&
        fill(context, p, &g, &lines, &out) && (!thick || correct_far(p, &g, &out)) &&
        (p->windowed || close_rows(p, out.up, out.down)))
        status = MURK_OK;
    if (status)
        murk_fail(context, status, "pairwise: out of memory for %zu zones", n);
    else if (p->sight.ground && p->sight.ground->horizon)
        memcpy(p->horizon, out.down, n * sizeof *p->horizon);
    murk_lines_through_clear(&lines);
    murk_free(g.table);
    murk_free(rest);
    return status;
}
