/* SPDX-License-Identifier: Apache-2.0 */
#include "shot.h"

#include "blocks.h"

#include <string.h>

/* Rays along the edge of a packet. */
enum { EDGE = 4 };

/* Rays of a packet in the world. */
typedef struct beam {
    double x[MURK_LANES], y[MURK_LANES]; /* in the picture, in pixels from the top left */
    double origin[3][MURK_LANES];
    double direction[3][MURK_LANES]; /* unit vectors */
    double cosine[MURK_LANES];       /* of the angle to the viewing axis */
    double t_ground[MURK_LANES];     /* where they meet it; MURK_FOREVER where they do not */
} beam;

static void set_frame(murk_shot *shot)
{
    const murk_grid *grid = shot->solution->medium->grid;
    murk_grid_from_world(grid, shot->view.eye, shot->eye);
    murk_grid_direction_from_world(grid, shot->view.right, shot->right);
    murk_grid_direction_from_world(grid, shot->view.up, shot->up);
    murk_grid_direction_from_world(grid, shot->view.forward, shot->forward);
    for (int a = 0; a < 3; a++) {
        shot->eye[a] /= grid->voxel[a];
        shot->right[a] /= grid->voxel[a];
        shot->up[a] /= grid->voxel[a];
        shot->forward[a] /= grid->voxel[a];
    }
}

/* A second march for the emitted part, where neither all of the light is that nor none. */
static murk_status take_parts(murk_context *context, murk_shot *shot)
{
    const murk_medium *medium = shot->solution->medium;
    bool glows = murk_blocks_any_glow(shot->solution);
    shot->all_glow = glows && !medium->albedo.field && !(medium->albedo.constant > 0);
    if (!glows || shot->all_glow)
        return MURK_OK;
    return murk_march_glow(context, shot->solution, &shot->march, &shot->glow);
}

/* Light that is scattered forward out of the beam reaches the ground with it: the solution has lit
   the patches through the reduced medium, and so must be the points of the picture. */
static const murk_march *shadow_march(const murk_shot *shot)
{
    const murk_forward *forward = &shot->peaked;
    return murk_forward_needed(forward) ? &forward->march : &shot->march;
}

murk_status murk_shot_create(murk_context *context, const murk_solution *solution,
                             const murk_view *view, const murk_render_options *options,
                             murk_shot *out)
{
    int samples = options->samples > 0 ? options->samples : 2;
    *out = (murk_shot){.solution = solution,
                       .view = *view,
                       .samples = samples,
                       .block = samples % 4 == 0   ? 1
                                : samples % 2 == 0 ? 2
                                                   : 4,
                       .parts = options->parts,
                       .has_backdrop = !options->no_background};
    set_frame(out);
    murk_status status = murk_march_create(context, solution, &out->march);
    if (!status && out->parts)
        status = take_parts(context, out);
    if (!status && solution->medium->asymmetry != 0)
        status = murk_forward_create(context, solution, &out->peaked);
    if (!status)
        status = murk_seen(context, solution->medium->grid, out->march.box, view, &out->seen);
    if (!status && out->has_backdrop)
        status = murk_backdrop_create(context, solution, shadow_march(out), options->background,
                                      &out->backdrop);
    if (status)
        murk_shot_clear(out);
    return status;
}

void murk_shot_clear(murk_shot *shot)
{
    murk_free(shot->glow.blocks);
    if (murk_forward_needed(&shot->peaked))
        murk_forward_clear(&shot->peaked);
    murk_march_clear(&shot->march);
    murk_bins_clear(&shot->seen);
    murk_backdrop_clear(&shot->backdrop);
}

/* The packet at column i, row j of those of a block. */
static void aim(const murk_shot *shot, int left, int top, int i, int j, beam *rays,
                murk_packet *packet)
{
    const murk_view *view = &shot->view;
    const murk_ground *ground = shot->solution->ground;
    double right[MURK_LANES], up[MURK_LANES], aside[MURK_LANES], above[MURK_LANES],
        *scale = rays->cosine;
    for (int l = 0; l < MURK_LANES; l++) {
        rays->x[l] = left + (i * EDGE + l % EDGE + 0.5) / shot->samples;
        rays->y[l] = top + (j * EDGE + l / EDGE + 0.5) / shot->samples;
        double u = (2 * rays->x[l] / view->size[0] - 1) * view->half_width;
        double v = (1 - 2 * rays->y[l] / view->size[1]) * view->half_height;
        scale[l] = view->parallel ? 1 : 1 / sqrt(1 + u * u + v * v);
        right[l] = view->parallel ? 0 : u * scale[l];
        up[l] = view->parallel ? 0 : v * scale[l];
        aside[l] = view->parallel ? u : 0;
        above[l] = view->parallel ? v : 0;
        rays->t_ground[l] = MURK_FOREVER;
    }
    for (int a = 0; a < 3; a++)
        for (int l = 0; l < MURK_LANES; l++) {
            double d =
                scale[l] * shot->forward[a] + right[l] * shot->right[a] + up[l] * shot->up[a];
            packet->origin[a][l] =
                shot->eye[a] + aside[l] * shot->right[a] + above[l] * shot->up[a];
            packet->direction[a][l] = murk_packet_direction(d);
            packet->inverse[a][l] = 1 / packet->direction[a][l];
            rays->origin[a][l] = view->eye[a] + aside[l] * view->right[a] + above[l] * view->up[a];
            rays->direction[a][l] =
                scale[l] * view->forward[a] + right[l] * view->right[a] + up[l] * view->up[a];
        }
    if (ground) {
        int axis = murk_ground_axis_up(ground);
        for (int l = 0; l < MURK_LANES; l++) {
            double height = fmax(0, rays->origin[axis][l] - ground->height);
            rays->t_ground[l] = rays->direction[axis][l] < -height / MURK_FOREVER
                                    ? -height / rays->direction[axis][l]
                                    : MURK_FOREVER;
        }
    }
    for (int l = 0; l < MURK_LANES; l++) {
        packet->t_max[l] = rays->t_ground[l];
        packet->depth[l] = packet->path[l] = 0;
        packet->tau[l] = 1;
    }
}

static void look_behind(const murk_shot *shot, const beam *rays, const murk_packet *packet,
                        double radiance[3][MURK_LANES])
{
    const murk_view *view = &shot->view;
    const murk_ground *ground = shot->solution->ground;
    int a = ground ? murk_ground_axis_a(ground) : 0, b = ground ? murk_ground_axis_b(ground) : 0;
    murk_ends ends;
    if (!shot->has_backdrop) {
        memset(radiance, 0, 3 * sizeof *radiance);
        return;
    }
    for (int l = 0; l < MURK_LANES; l++) {
        double t = rays->t_ground[l];
        ends.wanted[l] = shot->parts || packet->tau[l] >= MURK_OPAQUE;
        ends.ground[l] = t < MURK_FOREVER;
        ends.a[l] = rays->origin[a][l] + t * rays->direction[a][l];
        ends.b[l] = rays->origin[b][l] + t * rays->direction[b][l];
        ends.x[l] = rays->x[l] / view->size[0];
        ends.y[l] = rays->y[l] / view->size[1];
        for (int c = 0; c < 3; c++)
            ends.point[c][l] = packet->origin[c][l] + t * packet->direction[c][l];
    }
    murk_backdrop_light(&shot->backdrop, &ends, radiance);
}

/* The pixel of its block that a lane of the packet at column i, row j is in. */
static int pixel_of(const murk_shot *shot, int i, int j, int lane)
{
    return (j * EDGE + lane / EDGE) / shot->samples * MURK_BLOCK_PIXELS +
           (i * EDGE + lane % EDGE) / shot->samples;
}

/* Adds a packet's light, seen through the medium, to the sums of its pixels. */
static void add(const murk_shot *shot, int i, int j, const beam *rays, const murk_packet *packet,
                const double glow[MURK_LANES], const murk_trace *trace,
                const double behind[3][MURK_LANES], murk_sum *sum)
{
    for (int l = 0; l < MURK_LANES; l++) {
        murk_sum *to = &sum[pixel_of(shot, i, j, l)];
        double depth = packet->depth[l], tau = depth > 0 ? exp(-depth) : 1;
        to->transmittance += tau;
        to->path += packet->path[l] * M_1_PI;
        for (int c = 0; c < 3; c++)
            to->surface[c] += tau * behind[c][l];
        if (depth > 0) {
            to->distance += rays->cosine[l] * murk_trace_half(trace, l, depth);
            to->deep++;
        }
        to->emitted += glow[l] * M_1_PI;
        for (int c = 0; c < 3; c++)
            to->inherent[c] += behind[c][l];
        to->depth += depth;
    }
}

/* What zones on the way of a packet radiate by themselves, as the path. */
static bool march_glow(const murk_shot *shot, const int32_t *brick, size_t count,
                       const murk_packet *packet, murk_trace *trace, double glow[MURK_LANES])
{
    murk_packet again = *packet;
    memset(glow, 0, MURK_LANES * sizeof *glow);
    if (!shot->glow.blocks)
        return true;
    if (!murk_march_light(&shot->glow, brick, count, &again, trace))
        return false;
    memcpy(glow, again.path, MURK_LANES * sizeof *glow);
    return true;
}

/* pi times the radiance that lies behind the medium about each ray: of the sky, or of the ground,
   as far around as light is turned aside half way through the medium. */
static void look_around(const murk_shot *shot, const beam *rays, const murk_packet *packet,
                        const murk_forwarded *passed, const murk_trace *trace,
                        double behind[MURK_LANES])
{
    const murk_forward *forward = &shot->peaked;
    const murk_ground *ground = shot->solution->ground;
    int a = ground ? murk_ground_axis_a(ground) : 0, b = ground ? murk_ground_axis_b(ground) : 0;
    for (int l = 0; l < MURK_LANES; l++) {
        double t = rays->t_ground[l];
        behind[l] = M_PI * shot->solution->sky_radiance;
        if (t < MURK_FOREVER && packet->depth[l] > 0)
            behind[l] =
                murk_blur_mean(&forward->ground, rays->origin[a][l] + t * rays->direction[a][l],
                               rays->origin[b][l] + t * rays->direction[b][l],
                               murk_forward_spread(forward, packet->depth[l] - passed->depth[l]) *
                                   fmax(t - murk_trace_half(trace, l, packet->depth[l]), 1e-6 * t));
    }
}

/* Makes the recorded path that of the medium with forward scattering. All marches make the same
   steps, since they have the same voxels. */
static void record_forward(const murk_shot *shot, const beam *rays, const double behind[MURK_LANES],
                           murk_trace trace[MURK_SHOT_TRACES])
{
    for (size_t n = 0; n < trace->count; n++) {
        murk_packet so_far;
        murk_forwarded passed;
        for (int l = 0; l < MURK_LANES; l++) {
            so_far.depth[l] = trace[0].passed[n].depth[l];
            so_far.path[l] = trace[0].path[n][l];
            passed.depth[l] = trace[1].passed[n].depth[l];
            passed.path[l] = trace[1].path[n][l];
            for (int t = 1; t < MURK_FORWARD_TERMS && shot->peaked.weight; t++)
                passed.sun[t][l] = trace[1 + t].path[n][l];
        }
        murk_forward_light(&shot->peaked, &passed, rays->direction, behind, &so_far);
        for (int l = 0; l < MURK_LANES; l++)
            trace[0].path[n][l] = (float)so_far.path[l];
    }
}

/* The packet at column i, row j of those of a block: to its end, what is behind it not included.
   stride: 1 where each march has a trace of its own, else 0. */
static bool carry(const murk_shot *shot, const int32_t *brick, size_t count, const beam *rays,
                  murk_trace *trace, size_t stride, murk_packet *packet)
{
    const bool forward = murk_forward_needed(&shot->peaked);
    murk_forwarded passed;
    if ((forward && !murk_forward_march(&shot->peaked, brick, count, packet, trace + stride, stride,
                                        &passed)) ||
        !murk_march_light(murk_forward_itself(&shot->peaked, &shot->march), brick, count, packet,
                          trace))
        return false;
    if (forward) {
        double average[MURK_LANES];
        look_around(shot, rays, packet, &passed, trace, average);
        if (stride)
            record_forward(shot, rays, average, trace);
        murk_forward_light(&shot->peaked, &passed, rays->direction, average, packet);
    }
    return true;
}

/* Puts down the rays of the packet at column i, row j in the curves of their pixels. */
static bool record(const murk_shot *shot, int i, int j, const beam *rays, const murk_trace *trace,
                   murk_curves *curves)
{
    for (int l = 0; l < MURK_LANES; l++)
        if (!murk_curves_add(curves, pixel_of(shot, i, j, l), trace, l, rays->cosine[l],
                             rays->t_ground[l]))
            return false;
    return true;
}

bool murk_shot_block(const murk_shot *shot, int left, int top, murk_trace *trace,
                     murk_curves *curves, murk_sum sum[MURK_BLOCK_PIXELS * MURK_BLOCK_PIXELS])
{
    size_t count;
    const int32_t *brick =
        murk_bins_list(&shot->seen, left / MURK_BIN_PIXELS, top / MURK_BIN_PIXELS, &count);
    int packets = shot->block * shot->samples / EDGE;
    memset(sum, 0, MURK_BLOCK_PIXELS * MURK_BLOCK_PIXELS * sizeof *sum);
    if (curves)
        murk_curves_restart(curves);
    for (int j = 0; j < packets; j++)
        for (int i = 0; i < packets; i++) {
            beam rays;
            murk_packet packet;
            double behind[3][MURK_LANES], glow[MURK_LANES];
            aim(shot, left, top, i, j, &rays, &packet);
            if (!march_glow(shot, brick, count, &packet, trace, glow) ||
                !carry(shot, brick, count, &rays, trace, curves ? 1 : 0, &packet))
                return false;
            look_behind(shot, &rays, &packet, behind);
            add(shot, i, j, &rays, &packet, shot->all_glow ? packet.path : glow, trace, behind,
                sum);
            if (curves && !record(shot, i, j, &rays, trace, curves))
                return false;
        }
    return true;
}
