/* SPDX-License-Identifier: Apache-2.0 */
/* The rows of the stress suite: media of one extreme property each, and lights on a plain one. */
#include "stress_media.h"

static const double VOXEL = 0.125; /* [m]; a power of two */

/* ---- numbers at the ends of float ------------------------------------------------------------ */

static void denormal_extinction(struct stress_scene *scene, double part)
{
    uint64_t random = 35;
    stress_porous(scene, 0.6);
    for (size_t n = 0; n < scene->count; n++)
        if (check_random(&random) < part)
            scene->voxel[n].kappa_t = (float)(1e-45 * pow(10, 12 * check_random(&random)));
}

static void denormal_emission(struct stress_scene *scene, double irradiance)
{
    stress_porous(scene, 0.6);
    scene->sun.irradiance = irradiance;
    scene->sky = irradiance / 20;
    for (size_t n = 0; n < scene->count; n++)
        scene->voxel[n].emission *= 1e-40f;
}

static void faint_lights(struct stress_scene *scene, double irradiance)
{
    denormal_emission(scene, irradiance);
    scene->ground_emission = irradiance;
}

static void decades_of_emission(struct stress_scene *scene, double decades)
{
    uint64_t random = 36;
    stress_porous(scene, 0.6);
    for (size_t n = 0; n < scene->count; n++)
        scene->voxel[n].emission = (float)pow(10, decades * (check_random(&random) - 0.5));
}

/* The value that a half float holds: 11 bits, from 2^-14 downwards steps of 2^-24. */
static float to_half(float x)
{
    int exponent;
    frexpf(x, &exponent);
    float step = ldexpf(1, (exponent < -13 ? -13 : exponent) - 11);
    return nearbyintf(x / step) * step;
}

static void of_halves(struct stress_scene *scene, double tau)
{
    uint64_t random = 37;
    stress_porous(scene, tau);
    for (size_t n = 0; n < scene->count; n++) {
        struct stress_voxel *v = &scene->voxel[n];
        /* Some of them in the denormal halves. */
        double small = check_random(&random) < 0.2 ? 1e-6 * check_random(&random) : 1;
        v->kappa_t = to_half((float)(v->kappa_t * small));
        v->albedo = to_half(v->albedo);
    }
}

/* ---- lights -------------------------------------------------------------------------------- */

static void sun_along(struct stress_scene *scene, double x, double y, double z)
{
    stress_porous(scene, 0.6);
    scene->sun = (murk_sun){{x, y, z}, 2};
}

/* parameter: degrees below the horizontal that the light travels. */
static void low_sun(struct stress_scene *scene, double degrees)
{
    double angle = degrees * M_PI / 180;
    sun_along(scene, 0.8 * cos(angle), 0.6 * cos(angle), -sin(angle));
}

/* parameter: the components as digits 0, 1 and 9 for -1. */
static void straight_sun(struct stress_scene *scene, double digits)
{
    int d[3] = {(int)digits / 100, (int)digits / 10 % 10, (int)digits % 10};
    sun_along(scene, d[0] == 9 ? -1 : d[0], d[1] == 9 ? -1 : d[1], d[2] == 9 ? -1 : d[2]);
}

static void dark(struct stress_scene *scene, double parameter)
{
    (void)parameter;
    stress_porous(scene, 0.6);
    scene->sun.irradiance = scene->sky = 0;
    for (size_t n = 0; n < scene->count; n++)
        scene->voxel[n].emission = 0;
}

static void sky_alone(struct stress_scene *scene, double reflectance)
{
    dark(scene, 0);
    scene->sky = 0.1;
    scene->reflectance = reflectance;
}

static void of_ground(struct stress_scene *scene, double reflectance)
{
    stress_porous(scene, 0.6);
    scene->reflectance = reflectance;
}

static void on_ground(struct stress_scene *scene, double gap)
{
    stress_porous(scene, 0.6);
    scene->gap = gap;
}

static void glowing_ground(struct stress_scene *scene, double emission)
{
    dark(scene, 0);
    scene->ground_emission = emission;
}

/* ---- all ----------------------------------------------------------------------------------- */

const struct stress_row STRESS_ROWS[] = {
    {"albedo 0", STRESS_OPTICS, stress_of_albedo, 0, PAIRED},
    {"albedo 0.5", STRESS_OPTICS, stress_of_albedo, 0.5, PAIRED},
    {"albedo 0.99", STRESS_OPTICS, stress_of_albedo, 0.99, PAIRED},
    {"albedo 1 - 1e-6", STRESS_OPTICS, stress_of_albedo, 1 - 1e-6, PAIRED},
    {"albedo 1 - 1e-9", STRESS_OPTICS, stress_of_albedo, 1 - 1e-9, PAIRED},
    {"albedo 1", STRESS_OPTICS, stress_of_albedo, 1, PAIRED},
    {"any albedo, 0 and 1 too", STRESS_OPTICS, stress_of_any_albedo, 2, 0},
    {"1e-8 a voxel", STRESS_OPTICS, stress_thin, 1e-8, PAIRED},
    {"1e-4 a voxel", STRESS_OPTICS, stress_thin, 1e-4, PAIRED},
    {"0.02 a voxel, 32 cubed", STRESS_OPTICS, stress_large, 0.02, MERGED},
    {"1 a voxel", STRESS_OPTICS, stress_thick, 1, 0},
    {"20 a voxel", STRESS_OPTICS, stress_thick, 20, 0},
    {"1e3 a voxel", STRESS_OPTICS, stress_thick, 1e3, 0},
    {"1e5 a voxel", STRESS_OPTICS, stress_thick, 1e5, 0},
    {"neighbours 1e6 apart", STRESS_OPTICS, stress_neighbours, 10, 0},
    {"1e-5 ... 10 a voxel", STRESS_OPTICS, stress_wild, 10, 0},
    {"a third of kappa_t denormal", STRESS_OPTICS, denormal_extinction, 0.33, 0},
    {"all kappa_t denormal", STRESS_OPTICS, denormal_extinction, 1, DENORMAL},
    {"half floats", STRESS_OPTICS, of_halves, 0.6, 0},
    {"voxel checkerboard", STRESS_SHAPES, stress_voxel_checkers, 2, 0},
    {"brick checkerboard", STRESS_SHAPES, stress_brick_checkers, 1, 0},
    {"single voxel of 1e-4", STRESS_SHAPES, stress_single, 1e-4, PAIRED},
    {"single voxel of 1", STRESS_SHAPES, stress_single, 1, 0},
    {"single voxel of 1e5", STRESS_SHAPES, stress_single, 1e5, 0},
    {"sheet across x", STRESS_SHAPES, stress_sheet, 0, 0},
    {"sheet across y", STRESS_SHAPES, stress_sheet, 1, 0},
    {"sheet across z", STRESS_SHAPES, stress_sheet, 2, 0},
    {"diagonal of voxels", STRESS_SHAPES, stress_diagonal, 1, 0},
    {"clouds 60,000 voxels apart", STRESS_SHAPES, stress_clouds, 60000, 0},
    {"flat voxels 1:100", STRESS_SHAPES, stress_stretched, 0.01, 0},
    {"needle voxels 100:1", STRESS_SHAPES, stress_stretched, 100, 0},
    {"voxels of 1e-6 m", STRESS_SHAPES, stress_of_size, 1e-6, 0},
    {"voxels of 1e6 m", STRESS_SHAPES, stress_of_size, 1e6, 0},
    {"emission over 12 decades", STRESS_LIGHTS, decades_of_emission, 12, EMISSION_SET},
    {"denormal emission", STRESS_LIGHTS, denormal_emission, 2, EMISSION_SET},
    {"denormal emission alone", STRESS_LIGHTS, denormal_emission, 0, DENORMAL | EMISSION_SET},
    {"all lights denormal", STRESS_LIGHTS, faint_lights, 1e-40, DENORMAL | EMISSION_SET},
    {"sun 0.1 degree high", STRESS_LIGHTS, low_sun, 0.1, 0},
    {"sun 1e-6 degree high", STRESS_LIGHTS, low_sun, 1e-6, 0},
    {"sun on the horizon", STRESS_LIGHTS, low_sun, 0, EDGE_ON},
    {"sun along (1,0,0)", STRESS_LIGHTS, straight_sun, 100, NO_GROUND},
    {"sun along (0,0,-1)", STRESS_LIGHTS, straight_sun, 9, 0},
    {"sun along (1,1,0)", STRESS_LIGHTS, straight_sun, 110, NO_GROUND | BETWEEN},
    {"sun along (0,1,-1)", STRESS_LIGHTS, straight_sun, 19, BETWEEN},
    {"sun along (1,1,1)", STRESS_LIGHTS, straight_sun, 111, NO_GROUND | BETWEEN},
    {"sun along (1,1,-1)", STRESS_LIGHTS, straight_sun, 119, BETWEEN},
    {"sky alone, black ground", STRESS_LIGHTS, sky_alone, 0, 0},
    {"sky alone, bright ground", STRESS_LIGHTS, sky_alone, 0.8, NO_SPACE},
    {"sun and sky, black ground", STRESS_LIGHTS, of_ground, 0, NO_SPACE},
    {"sun and sky, white ground", STRESS_LIGHTS, of_ground, 1, NO_SPACE},
    {"medium on the ground", STRESS_LIGHTS, on_ground, 0, NO_SPACE},
    {"medium 1e4 voxels above it", STRESS_LIGHTS, on_ground, 1e4, NO_SPACE},
    {"glowing ground alone", STRESS_LIGHTS, glowing_ground, 1, NO_SPACE},
    {"no light", STRESS_LIGHTS, dark, 0, 0},
};

const size_t STRESS_ROW_COUNT = sizeof STRESS_ROWS / sizeof *STRESS_ROWS;

struct stress_scene stress_row_scene(const struct stress_row *row, bool ground)
{
    struct stress_scene scene = {.size = {VOXEL, VOXEL, VOXEL},
                                 .sun = {{0.4, -0.3, -0.9}, 2},
                                 .sky = 0.1,
                                 .ground = ground,
                                 .up = MURK_UP_Z,
                                 .reflectance = 0.8,
                                 .gap = 0.5};
    row->make(&scene, row->parameter);
    return scene;
}
