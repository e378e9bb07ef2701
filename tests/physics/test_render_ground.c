/* SPDX-License-Identifier: Apache-2.0 */
/* The ground in pictures: bare, in the shadow of a medium, under an opaque one. Black media: what a
   point of the ground gets is the sun and the sky that are left. */
#include "camera.h"

enum { COLUMNS = 12, ROWS = 10 };

static const double F = 1.3, SKY = 0.25, SUN[3] = {0.36, -0.48, -0.8};
static const double LOW[3] = {0.4, 0.4, 0.2}, HIGH[3] = {0.8, 0.7, 0.6}; /* of the medium */

static float rho[ROWS * COLUMNS], glow[ROWS * COLUMNS]; /* image order */

static void open_scene(struct world *w, double kappa_t)
{
    uint64_t random = 4;
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        rho[i] = (float)check_random(&random);
        glow[i] = (float)check_random(&random);
    }
    const murk_array array = {.size = {4, 3, 4},
                              .voxel_size = {0.1, 0.1, 0.1},
                              .origin = {LOW[0], LOW[1], LOW[2]},
                              .kappa_t_value = kappa_t};
    murk_ground_options ground = MURK_GROUND_DEFAULT;
    ground.extent_max[0] = 0.1 * COLUMNS;
    ground.extent_max[1] = 0.1 * ROWS;
    ground.patches[0] = COLUMNS;
    ground.patches[1] = ROWS;
    ground.reflectance_image = rho;
    ground.emission_image = glow;
    world_open(w, 1, &array, &ground);
}

static double mean_of(const float *values)
{
    double sum = 0;
    for (int i = 0; i < ROWS * COLUMNS; i++)
        sum += values[i];
    return sum / (ROWS * COLUMNS);
}

/* Reflectance and emission at a point of the ground: the patch's, outside their means. */
static void ground_at(const double at[3], double *reflectance, double *emission)
{
    int i = (int)floor(at[0] / 0.1), row = ROWS - 1 - (int)floor(at[1] / 0.1);
    bool inside = i >= 0 && i < COLUMNS && row >= 0 && row < ROWS;
    *reflectance = inside ? rho[row * COLUMNS + i] : mean_of(rho);
    *emission = inside ? glow[row * COLUMNS + i] : mean_of(glow);
}

/* Whether a point lies on the border of two patches as far as rounding can tell. */
static bool is_border(const double at[3])
{
    return fabs(at[0] / 0.1 - round(at[0] / 0.1)) < 1e-9 ||
           fabs(at[1] / 0.1 - round(at[1] / 0.1)) < 1e-9;
}

/* Every pixel, with eq. (11) for a black medium over a ground that gets the irradiance `sky` from
   the sky: tau (e + rho (F cos(theta) tau_sun + sky)) / pi, above the horizon tau L. */
static void check_picture(const struct world *w, double kappa_t, double tolerance)
{
    const murk_camera camera = {{1.9, -0.9, 0.9}, {0.6, 0.5, 0.2}, {0, 0, 1}, 60, {45, 37}, 0};
    const double back[3] = {-SUN[0], -SUN[1], -SUN[2]};
    const double sky = w->scene.sky_radiance, sun = w->scene.sun.irradiance * back[2];
    murk_image *image = take(w, &camera, &(murk_render_options){.samples = 1});
    int above = 0, shaded = 0;
    for (int j = 0; j < 37; j++)
        for (int i = 0; i < 45; i++) {
            double along[3], at[3], wanted = sky, reflectance, emission;
            look_through(&camera, i, j, along);
            double tau = exp(-kappa_t * chord(LOW, HIGH, camera.eye, along));
            if (along[2] < 0) {
                for (int c = 0; c < 3; c++)
                    at[c] = camera.eye[c] - camera.eye[2] / along[2] * along[c];
                if (is_border(at))
                    continue;
                ground_at(at, &reflectance, &emission);
                double shadow = exp(-kappa_t * chord(LOW, HIGH, at, back));
                wanted = (emission + reflectance * (sun * shadow + M_PI * sky)) / M_PI;
                shaded += shadow < 0.9 && tau > 0.5;
            } else {
                above++;
            }
            assert_within(pixel(image, "R", i, j), tau * wanted, tolerance);
            assert_within(pixel(image, "surface.R", i, j), tau * wanted, tolerance);
        }
    assert_true(above > 45); /* there is something to see of everything */
    assert_true(kappa_t == 0 || shaded > 20);
    murk_image_release(image);
}

static void bare(void **state)
{
    (void)state;
    struct world w;
    open_scene(&w, 0);
    w.scene.sun = (murk_sun){{SUN[0], SUN[1], SUN[2]}, F};
    w.scene.sky_radiance = SKY;
    world_solve(&w, NULL);
    check_picture(&w, 0, 1e-5);
    world_close(&w);
}

/* No sky, so nothing has to be integrated over directions: shadows are sharp and exact. */
static void shadow(void **state)
{
    (void)state;
    const double kappa_t[] = {2, 1e4};
    for (int n = 0; n < 2; n++) {
        struct world w;
        open_scene(&w, kappa_t[n]);
        w.scene.sun = (murk_sun){{SUN[0], SUN[1], SUN[2]}, F};
        world_solve(&w, NULL);
        check_picture(&w, kappa_t[n], 2e-6);
        world_close(&w);
    }
}

/* ---- The sky under an opaque box ---- */

/* Form factor of a rectangle (corners in order) from a horizontal ground element: Lambert's sum
   over the edges of angle times the vertical part of the unit normal to the edge's plane. */
static double form_factor(double corner[4][3])
{
    double sum = 0;
    for (int n = 0; n < 4; n++) {
        double normal[3];
        const double *a = corner[n], *b = corner[(n + 1) % 4];
        cross_product(a, b, normal);
        double length = sqrt(dot_product(normal, normal));
        if (length > 0)
            sum += normal[2] / length * atan2(length, dot_product(a, b));
    }
    return fabs(sum) / (2 * M_PI);
}

/* The share of the sky that the box takes from the ground at a point: its faces that look there. */
static double hidden_share(const double at[3])
{
    double share = 0;
    for (int face = 0; face < 6; face++) {
        int a = face / 2, u = (a + 1) % 3, v = (a + 2) % 3;
        bool high = face % 2;
        if (high ? at[a] <= HIGH[a] : at[a] >= LOW[a])
            continue;
        double corner[4][3];
        for (int n = 0; n < 4; n++) {
            corner[n][a] = (high ? HIGH[a] : LOW[a]) - at[a];
            corner[n][u] = (n == 1 || n == 2 ? HIGH[u] : LOW[u]) - at[u];
            corner[n][v] = (n >= 2 ? HIGH[v] : LOW[v]) - at[v];
        }
        share += form_factor(corner);
    }
    return share;
}

/* Mean over a patch, 8 x 8 points. */
static double hidden_from_patch(int i, int j)
{
    double sum = 0;
    for (int n = 0; n < 64; n++) {
        const double at[3] = {0.1 * (i + (n % 8 + 0.5) / 8), 0.1 * (j + (n / 8 + 0.5) / 8), 0};
        sum += hidden_share(at) / 64;
    }
    return sum;
}

/*
 * In the umbra only the sky beside the box is left, rho pi L (1 - f), f the box's form factor. The
 * sky comes from 1536 directions, half of them from above, so that the share that a body of
 * unknown outline hides is good to N^(-3/4) = 0.7 % (the discrepancy of N well-spread points on the
 * sphere: J. Beck, 1984); 8 x 8 lines a face, so that the outline itself is sharper than that (2 x
 * 2 leave up to 1.8 % right under the box). The light at a patch's centre is that of the patch.
 */
static void umbra(void **state)
{
    (void)state;
    struct world w;
    open_scene(&w, 1e4);
    w.scene.sun = (murk_sun){{0, 0, -1}, F};
    w.scene.sky_radiance = SKY;
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.directions = 1536;
    options.rays = 8;
    world_solve(&w, &options);
    double worst = 0;
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++) {
            const double centre[3] = {0.1 * (i + 0.5), 0.1 * (j + 0.5), 0};
            /* From the side, under the box. */
            murk_camera camera = {
                {centre[0], -1, 0.12}, {centre[0], centre[1], 0}, {0, 0, 1}, 1, {1, 1}, 0};
            murk_image *image = take(&w, &camera, &(murk_render_options){.samples = 1});
            double reflectance, emission;
            ground_at(centre, &reflectance, &emission);
            bool lit = centre[0] < LOW[0] || centre[0] > HIGH[0] || centre[1] < LOW[1] ||
                       centre[1] > HIGH[1];
            double sky = M_PI * SKY * (1 - hidden_from_patch(i, j));
            double wanted = (emission + reflectance * ((lit ? F : 0) + sky)) / M_PI;
            double off = pixel(image, "R", 0, 0) - wanted;
            worst = fmax(worst, fabs(off) / (reflectance * SKY));
            assert_within(pixel(image, "R", 0, 0), wanted, 0.007 * reflectance * SKY + 1e-6);
            murk_image_release(image);
        }
    print_message("sky on the ground: off by %.2f %% at most\n", 100 * worst);
    world_close(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bare),
        cmocka_unit_test(shadow),
        cmocka_unit_test(umbra),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
