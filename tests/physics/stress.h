/* SPDX-License-Identifier: Apache-2.0 */
/* The stress suite: media at the edges of what there is (rows), and what must hold in each of them
   (checks). STABILITY.md describes it. */
#ifndef STRESS_H
#define STRESS_H

#include "check.h"

/* ---- scenes -------------------------------------------------------------------------------- */

struct stress_voxel {
    int32_t at[3];
    float kappa_t, albedo, emission;
};

/* A medium in space or over a ground that carries 6 x 6 patches below the medium's box. */
struct stress_scene {
    size_t count;
    struct stress_voxel *voxel; /* owned */
    double size[3];             /* of a voxel [m] */
    murk_sun sun;
    double sky;
    bool ground;
    murk_up up;
    double reflectance, ground_emission;
    double gap; /* between the ground and the box, in voxels */
};

/* A signed permutation of the axes: axis a of the moved scene is axis from[a] of the original,
   backwards where flip[a]; then moved by voxels, lengths times scale with kappa_t over it, and all
   lights times light. */
struct stress_motion {
    int from[3];
    bool flip[3];
    int32_t shift[3];
    double scale, light;
};

#define STRESS_STILL                                                                               \
    {                                                                                              \
        .from = {0, 1, 2}, .scale = 1, .light = 1                                                  \
    }

void stress_scene_clear(struct stress_scene *scene);
/* The voxels of the copy stand in the same order. A ground must be below afterwards, too. */
struct stress_scene stress_move(const struct stress_scene *scene, const struct stress_motion *m);
struct stress_scene stress_copy(const struct stress_scene *scene);

/* Medium and ground in memory; false, with a message, where murk refuses them. */
bool stress_open(struct world *w, const struct stress_scene *scene);

struct stress_solution {
    murk_status status;
    murk_report report;
    float *B;              /* of the voxels, in their order; owned */
    size_t bad, negative;  /* values that are not finite, or below 0: voxels, margin, patches */
    double patches_of_one; /* largest |Bs - 1| */
};

/* False, with a message, where murk fails. */
bool stress_solve(const struct stress_scene *scene, const murk_solve_options *options,
                  struct stress_solution *out);
void stress_solution_clear(struct stress_solution *solution);

/* sum of kappa_t B^2 over the zones, B = a - b, or the part of it where a < b; b may be NULL. The
   voxels' order is that of `scene`. */
double stress_norm(const struct stress_scene *scene, const float *a, const float *b);
double stress_norm_below(const struct stress_scene *scene, const float *a, const float *b);

/* ---- rows ---------------------------------------------------------------------------------- */

enum stress_group { STRESS_OPTICS, STRESS_SHAPES, STRESS_LIGHTS, STRESS_GROUPS };

/* What a row is not asked for, with the reason where it is named. */
enum {
    NO_SPACE = 1 << 0,     /* the scene makes sense over a ground alone */
    NO_GROUND = 1 << 1,    /* ... in space alone */
    PAIRED = 1 << 2,       /* small and thin enough to compare with pairwise */
    DENORMAL = 1 << 3,     /* lights of 1e-40: float has too few bits left for any relation */
    EMISSION_SET = 1 << 4, /* emission is the row's subject: not to be added to */
    BETWEEN = 1 << 5,      /* the sun has no dominant axis: which lattice it gets is arbitrary */
    EDGE_ON = 1 << 6,      /* the sun is on the horizon */
    MERGED = 1 << 7, /* orders on larger zones: iteration leaves up to 2.5 times its estimate */
};

struct stress_row {
    const char *name;
    enum stress_group group;
    void (*make)(struct stress_scene *scene, double parameter); /* the rest is set by default */
    double parameter;
    unsigned flags;
};

extern const struct stress_row STRESS_ROWS[];
extern const size_t STRESS_ROW_COUNT;

/* The scene of a row, in space or over ground. */
struct stress_scene stress_row_scene(const struct stress_row *row, bool ground);

/* ---- checks -------------------------------------------------------------------------------- */

/* What a check measured and what it may be at most. */
struct stress_outcome {
    double value, bound;
};

/* A row's scene and the two solutions of it that most checks look at. */
struct stress_subject {
    const struct stress_row *row;
    struct stress_scene scene;
    struct stress_solution plain; /* all defaults */
    struct stress_solution fixed; /* 96 directions, iterated to 1e-5 */
    struct stress_solution fine;  /* 1536 directions */
};

bool stress_subject_open(struct stress_subject *s, const struct stress_row *row, bool ground);
void stress_subject_close(struct stress_subject *s);

struct stress_check {
    const char *name;
    bool (*applies)(const struct stress_subject *s); /* NULL: always */
    struct stress_outcome (*run)(const struct stress_subject *s);
};

extern const struct stress_check STRESS_CHECKS[];
extern const size_t STRESS_CHECK_COUNT;

#endif
