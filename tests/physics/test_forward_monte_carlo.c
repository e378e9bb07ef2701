/* SPDX-License-Identifier: Apache-2.0 */
/* The error of pictures of media that scatter forward: the path radiance of a cube in the sun,
   against the Monte Carlo with the phase function of Henyey and Greenstein, and what the similar
   medium that scatters isotropically would show. */
#include "camera.h"
#include "setting.h"

#include "monte_carlo_view.h"
#include "scenes.h"

enum { EDGE = 16, PLACES = 4 };

/* The middle of a picture along y. */
static const murk_camera CAMERA = {{0.5, -4, 0.5}, {0.5, 0.5, 0.5}, {0, 0, 1}, 10, {24, 24}, 0};
enum { LEFT = 8, SPOT = 8 };

/* The sun's way is 16 degrees off the camera's, across it, and 16 degrees off the opposite; the sky
   is all around. */
static const double SUNS[PLACES - 1][3] = {{0.28, 0.96, 0}, {0.96, 0.28, 0}, {0.28, -0.96, 0}};
static const char *const NAMES[PLACES] = {"behind", "beside", "in front", "sky"};

/* The largest errors allowed [%]: the measured ones, rounded up. */
static const struct row {
    double g, albedo, depth, most[PLACES];
} ROWS[] = {
    {0.3, 0.9, 0.5, {1, 2, 1, 1}},    {0.3, 0.9, 2.0, {3, 3, 1, 1}},
    {0.3, 0.9, 8.0, {8, 1, 13, 2}},   {0.3, 0.99, 0.5, {1, 2, 1, 1}},
    {0.3, 0.99, 2.0, {3, 3, 1, 1}},   {0.3, 0.99, 8.0, {7, 1, 11, 1}},
    {0.6, 0.9, 0.5, {3, 3, 1, 1}},    {0.6, 0.9, 2.0, {3, 7, 1, 1}},
    {0.6, 0.9, 8.0, {11, 6, 19, 3}},  {0.6, 0.99, 0.5, {3, 3, 1, 1}},
    {0.6, 0.99, 2.0, {3, 6, 1, 1}},   {0.6, 0.99, 8.0, {9, 5, 16, 1}},
    {0.85, 0.9, 0.5, {3, 3, 3, 1}},   {0.85, 0.9, 2.0, {2, 7, 2, 1}},
    {0.85, 0.9, 8.0, {6, 13, 13, 3}}, {0.85, 0.99, 0.5, {3, 3, 4, 1}},
    {0.85, 0.99, 2.0, {1, 8, 1, 1}},  {0.85, 0.99, 8.0, {2, 11, 2, 1}},
};

enum { ROW_COUNT = sizeof ROWS / sizeof *ROWS };

static double path_of(const struct bench_mc_scene *s, const murk_array *array)
{
    struct world w;
    world_open(&w, 0, array, NULL);
    w.scene.sun = (murk_sun){{s->sun[0], s->sun[1], s->sun[2]}, s->irradiance};
    w.scene.sky_radiance = s->sky_radiance;
    world_solve(&w, NULL);
    murk_image *image = take(&w, &CAMERA, &(murk_render_options){.samples = 1});
    double sum = 0;
    for (int n = 0; n < SPOT * SPOT; n++)
        sum += pixel(image, "path.R", LEFT + n % SPOT, LEFT + n / SPOT);
    murk_image_release(image);
    world_close(&w);
    return sum / (SPOT * SPOT);
}

static void check_place(const struct row *row, int place)
{
    static struct setting s;
    struct bench_mc_scene *mc = setting_start(&s, EDGE, EDGE, EDGE);
    struct bench_mc_radiance wanted;
    for (int a = 0; a < 3; a++)
        mc->voxel[a] = 1.0 / EDGE;
    setting_fill(&s, row->depth, row->albedo);
    mc->asymmetry = row->g;
    if (place < PLACES - 1)
        setting_sun(mc, SUNS[place][0], SUNS[place][1], SUNS[place][2]);
    else
        mc->sky_radiance = 1;
    const struct bench_mc_view view = {
        .scene = mc, .camera = CAMERA, .left = LEFT, .top = LEFT, .width = SPOT, .height = SPOT};
    assert_true(bench_mc_view_radiance(&view, row->g > 0.7 ? 200000 : 50000, 64, 0, &wanted));
    double mean = wanted.path.value, noise = wanted.path.error;
    assert_at_most(noise, 0.05 * mean);

    murk_array array = {.size = {EDGE, EDGE, EDGE},
                        .voxel_size = {mc->voxel[0], mc->voxel[1], mc->voxel[2]},
                        .kappa_t_value = row->depth,
                        .albedo_value = row->albedo,
                        .asymmetry = row->g};
    murk_array similar = array;
    similar.asymmetry = 0;
    similar.kappa_t_value *= 1 - row->albedo * row->g;
    similar.albedo_value *= (1 - row->g) / (1 - row->albedo * row->g);
    double got = path_of(mc, &array);
    print_message("| %.2f | %.2f | %.1f | %s | %+.1f | %.1f | %+.0f |\n", row->g, row->albedo,
                  row->depth, NAMES[place], 100 * (got / mean - 1), 100 * noise / mean,
                  100 * (path_of(mc, &similar) / mean - 1));
    assert_within(got, mean, 0.01 * row->most[place] * mean + 3 * noise);
}

static void cube(void **state)
{
    (void)state;
    for (int n = 0; n < ROW_COUNT; n++)
        for (int place = 0; place < PLACES; place++)
            check_place(&ROWS[n], place);
}

/* The paper's box, on the ground, in the sun and under the sky: the bright square and what is
   beside it. The light that is scattered forward out of the ground's is spread by rule of thumb. */
static const struct box_row {
    double g, kappa_t, sky, most[2];
} BOXES[] = {
    {0.6, 0.8, 0, {2, 1}}, {0.6, 3, 0, {4, 4}},    {0.6, 8, 0, {9, 8}},    {0.6, 0.8, 1, {2, 1}},
    {0.6, 3, 1, {4, 3}},   {0.6, 8, 1, {5, 1}},    {0.85, 0.8, 0, {4, 3}}, {0.85, 3, 0, {10, 4}},
    {0.85, 8, 0, {5, 7}},  {0.85, 0.8, 1, {6, 4}}, {0.85, 3, 1, {15, 4}},  {0.85, 8, 1, {8, 3}},
};

static double spot_of(const murk_image *image, const int spot[2])
{
    double sum = 0;
    for (int n = 0; n < 16; n++)
        sum += pixel(image, "R", spot[0] + n % 4, spot[1] + n / 4);
    return sum / 16;
}

static void box(void **state)
{
    (void)state;
    static const murk_camera side = {{0.5, -1.1, 1.6}, {0.5, 0.5, 0}, {0, 0, 1}, 40, {60, 60}, 0};
    static const int spots[2][2] = {{28, 28}, {28, 20}};
    static struct setting s;
    for (size_t n = 0; n < sizeof BOXES / sizeof *BOXES; n++) {
        const struct box_row *row = &BOXES[n];
        struct bench_mc_scene *mc = setting_start(&s, 20, 20, 20);
        mc->voxel[0] = mc->voxel[1] = 0.05;
        mc->voxel[2] = 0.025;
        mc->asymmetry = row->g;
        setting_fill(&s, row->kappa_t, 0.9);
        setting_lay_ground(mc, 0, 0);
        for (int i = 0; i < 400; i++)
            s.rho[i] = bench_paper_reflectance(i % 20, i / 20, 20, 20);
        mc->sky_radiance = row->sky;
        if (row->sky == 0)
            setting_sun(mc, 0, 0, -1);
        struct world w;
        setting_open(mc, 0, &w);
        world_solve(&w, NULL);
        murk_image *image = take(&w, &side, NULL);
        for (int i = 0; i < 2; i++) {
            struct bench_mc_radiance wanted;
            const struct bench_mc_view view = {.scene = mc,
                                               .camera = side,
                                               .left = spots[i][0],
                                               .top = spots[i][1],
                                               .width = 4,
                                               .height = 4};
            assert_true(bench_mc_view_radiance(&view, 60000, 64, 0, &wanted));
            double got = spot_of(image, spots[i]), mean = wanted.total.value;
            print_message("| %.2f | %.1f | %s | %s | %+.1f | %.1f |\n", row->g, row->kappa_t,
                          row->sky > 0 ? "sky" : "sun", i ? "beside" : "square",
                          100 * (got / mean - 1), 100 * wanted.total.error / mean);
            assert_at_most(wanted.total.error, 0.02 * mean);
            assert_within(got, mean, 0.01 * row->most[i] * mean + 3 * wanted.total.error);
        }
        murk_image_release(image);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube),
        cmocka_unit_test(box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
