/* SPDX-License-Identifier: Apache-2.0 */
/* [BG91] section 5 seen by a camera: how bright the square and its surround look through ever more
   extinction, and the contrast C = (L_t - L_b) / L_b that is left of them. */
#include "camera.h"
#include "setting.h"

#include "monte_carlo_view.h"
#include "scenes.h"

enum { EDGE = 20, SIZE = 60, PATHS = 100000 };

static const double HIGH[3] = {1, 1, 0.5}, LOW[3] = {0, 0, 0};
static const double KAPPAS[] = {0.1, 0.2, 0.5, 0.8, 1.5, 3, 5};

enum { KAPPA_COUNT = sizeof KAPPAS / sizeof *KAPPAS };

/* From the side; and from so high up that all lines of sight are equal to 1e-5. */
static const murk_camera SIDE = {{0.5, -1.1, 1.6}, {0.5, 0.5, 0}, {0, 0, 1}, 40, {SIZE, SIZE}, 0};
static const murk_camera ABOVE = {{0.5, 0.5, 200}, {0.5, 0.5, 0}, {0, 1, 0}, 0.2, {SIZE, SIZE}, 0};

/* Pixels, of a side of 4, on the square and beside it. */
struct spot {
    int left, top;
    double reflectance;
};
static const struct spot TARGET = {28, 28, 0.6}, SIDE_SURROUND = {28, 20, 0.3},
                         FRONT = {28, 38, 0.3}, ABOVE_SURROUND = {28, 52, 0.3};
enum { SPOT = 4 };

static void open_box(int edge, double kappa_t, double albedo, struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, edge, edge, edge);
    for (int a = 0; a < 3; a++)
        mc->voxel[a] = HIGH[a] / edge;
    setting_fill(s, kappa_t, albedo);
    setting_lay_ground(mc, 0, 0);
    setting_sun(mc, 0, 0, -1);
    for (int n = 0; n < edge * edge; n++)
        s->rho[n] = bench_paper_reflectance(n % edge, n / edge, edge, edge);
}

/* Where the ray through a pixel's middle meets the ground, and the patch's reflectance. */
static double meet_ground(const murk_camera *camera, int i, int j, double along[3])
{
    double at[3];
    look_through(camera, i, j, along);
    for (int c = 0; c < 3; c++)
        at[c] = camera->eye[c] - camera->eye[2] / along[2] * along[c];
    assert_true(at[0] > 0 && at[0] < 1 && at[1] > 0 && at[1] < 1);
    return bench_paper_reflectance((int)(at[0] * EDGE), (int)(at[1] * EDGE), EDGE, EDGE);
}

static double mean_of_spot(const murk_image *image, const char *channel, const struct spot *spot)
{
    double sum = 0;
    for (int n = 0; n < SPOT * SPOT; n++)
        sum += pixel(image, channel, spot->left + n % SPOT, spot->top + n / SPOT);
    return sum / (SPOT * SPOT);
}

/* The mean over a spot of tau L + (1 - tau) L_m for a ground that sends emission or what it
   reflects of `sun`. */
static double closed_form(const murk_camera *camera, const struct spot *spot, double kappa_t,
                          double sun, double glow, double medium)
{
    double sum = 0;
    for (int n = 0; n < SPOT * SPOT; n++) {
        double along[3];
        double reflectance =
            meet_ground(camera, spot->left + n % SPOT, spot->top + n / SPOT, along);
        assert_within(reflectance, spot->reflectance, 1e-6);
        double tau = exp(-kappa_t * chord(LOW, HIGH, camera->eye, along));
        sum += tau * reflectance * (sun + glow) / M_PI + (1 - tau) * medium;
    }
    return sum / (SPOT * SPOT);
}

static double contrast(double target, double surround)
{
    return (target - surround) / surround;
}

static const murk_render_options ONE_SAMPLE = {.samples = 1};

/* A black medium that is cold takes from both and leaves the contrast where lines of sight are
   equal; else it is that of exp(-kappa s) L. */
static void black(void **state)
{
    (void)state;
    static struct setting s;
    for (int n = 0; n < KAPPA_COUNT; n++) {
        struct world w;
        double sun = exp(-0.5 * KAPPAS[n]);
        open_box(EDGE, KAPPAS[n], 0, &s);
        setting_open(&s.mc, 1, &w);
        world_solve(&w, NULL);
        murk_image *side = take(&w, &SIDE, &ONE_SAMPLE), *above = take(&w, &ABOVE, &ONE_SAMPLE);
        double wanted = contrast(closed_form(&SIDE, &TARGET, KAPPAS[n], sun, 0, 0),
                                 closed_form(&SIDE, &SIDE_SURROUND, KAPPAS[n], sun, 0, 0));
        assert_within(
            contrast(mean_of_spot(side, "R", &TARGET), mean_of_spot(side, "R", &SIDE_SURROUND)),
            wanted, 1e-5);
        assert_within(
            contrast(mean_of_spot(above, "R", &TARGET), mean_of_spot(above, "R", &ABOVE_SURROUND)),
            1, 1e-4);
        murk_image_release(side);
        murk_image_release(above);
        world_close(&w);
    }
}

/* A black medium of one temperature over a ground that only radiates: C = C_0 tau L_b / (tau L_b +
   (1 - tau) L_m). */
static void glowing(void **state)
{
    (void)state;
    static struct setting s;
    const double emission = 0.2;
    for (int n = 0; n < KAPPA_COUNT; n++) {
        struct world w;
        open_box(EDGE, KAPPAS[n], 0, &s);
        s.mc.irradiance = 0;
        for (int p = 0; p < EDGE * EDGE; p++) {
            s.glow[p] = s.rho[p];
            s.rho[p] = 0;
        }
        for (int z = 0; z < zone_count(&s.mc); z++)
            s.emission[z] = (float)emission;
        setting_open(&s.mc, 1, &w);
        world_solve(&w, NULL);
        murk_image *side = take(&w, &SIDE, &ONE_SAMPLE), *above = take(&w, &ABOVE, &ONE_SAMPLE);
        double target = closed_form(&SIDE, &TARGET, KAPPAS[n], 0, 1, emission / M_PI);
        double surround = closed_form(&SIDE, &SIDE_SURROUND, KAPPAS[n], 0, 1, emission / M_PI);
        assert_within(
            contrast(mean_of_spot(side, "R", &TARGET), mean_of_spot(side, "R", &SIDE_SURROUND)),
            contrast(target, surround), 1e-5);
        double tau = exp(-0.5 * KAPPAS[n]);
        assert_within(
            contrast(mean_of_spot(above, "R", &TARGET), mean_of_spot(above, "R", &ABOVE_SURROUND)),
            tau * 0.3 / (tau * 0.3 + (1 - tau) * emission), 1e-4);
        murk_image_release(side);
        murk_image_release(above);
        world_close(&w);
    }
}

static void look(const struct setting *s, const struct spot *spot, struct bench_mc_radiance *out)
{
    const struct bench_mc_view view = {.scene = &s->mc,
                                       .camera = SIDE,
                                       .left = spot->left,
                                       .top = spot->top,
                                       .width = SPOT,
                                       .height = SPOT};
    assert_true(bench_mc_view_radiance(&view, PATHS, 64, 0, out));
    assert_at_most(out->total.error, 0.003 * out->total.value);
}

/* With scattering: what the medium sends, what comes through it, both, to the tolerance of 1 %. */
static void check_spot(const struct setting *s, const murk_image *image, const struct spot *spot,
                       struct bench_mc_radiance *wanted)
{
    look(s, spot, wanted);
    double total = mean_of_spot(image, "R", spot);
    double surface = mean_of_spot(image, "surface.R", spot);
    double path = mean_of_spot(image, "path.R", spot);
    print_message("kappa %.1f albedo %.3f: %+.2f %% (surface %+.2f %%, path %+.2f %%), noise "
                  "%.2f %%\n",
                  s->kappa_t[0], s->albedo[0], 100 * (total / wanted->total.value - 1),
                  100 * (surface / wanted->surface.value - 1),
                  100 * (path / wanted->path.value - 1),
                  100 * wanted->total.error / wanted->total.value);
    assert_within(total, wanted->total.value, 0.01 * wanted->total.value + 3 * wanted->total.error);
    assert_within(surface, wanted->surface.value,
                  0.01 * wanted->surface.value + 3 * wanted->surface.error);
    assert_within(path, wanted->path.value, 0.01 * wanted->path.value + 3 * wanted->path.error);
}

static void scattering(void **state)
{
    (void)state;
    static struct setting s;
    static const double albedos[] = {0.625, 0.9};
    for (int a = 0; a < 2; a++)
        for (int n = 0; n < KAPPA_COUNT; n++) {
            struct world w;
            struct bench_mc_radiance target, surround;
            open_box(EDGE, KAPPAS[n], albedos[a], &s);
            setting_open(&s.mc, 0, &w);
            world_solve(&w, NULL);
            murk_image *image = take(&w, &SIDE, NULL);
            check_spot(&s, image, &TARGET, &target);
            check_spot(&s, image, &SIDE_SURROUND, &surround);
            double wanted = contrast(target.total.value, surround.total.value);
            double noise = (1 + wanted) * hypot(target.total.error / target.total.value,
                                                surround.total.error / surround.total.value);
            double got = contrast(mean_of_spot(image, "R", &TARGET),
                                  mean_of_spot(image, "R", &SIDE_SURROUND));
            print_message("contrast %.4f, Monte Carlo %.4f +- %.4f\n", got, wanted, noise);
            assert_within(got, wanted, 0.01 * (1 + wanted) + 3 * noise);
            murk_image_release(image);
            world_close(&w);
        }
}

/* Through a face along which the sun shines: outside of it, where the picture takes the source
   from that interpolation wants, the sun is bright to the ground. In half a voxel that adds too
   much light, in proportion to the voxel. */
static void rim(void **state)
{
    (void)state;
    static struct setting s;
    static const double most[2] = {0.12, 0.06};
    for (int n = 0; n < 2; n++) {
        struct world w;
        struct bench_mc_radiance wanted;
        open_box(10 * (n + 1), 3, 0.625, &s);
        setting_open(&s.mc, 0, &w);
        world_solve(&w, NULL);
        murk_image *image = take(&w, &SIDE, NULL);
        look(&s, &FRONT, &wanted);
        double path = mean_of_spot(image, "path.R", &FRONT);
        print_message("through the front, %d voxels: path %+.2f %%\n", 10 * (n + 1),
                      100 * (path / wanted.path.value - 1));
        assert_within(path, wanted.path.value, most[n] * wanted.path.value);
        murk_image_release(image);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(black),
        cmocka_unit_test(glowing),
        cmocka_unit_test(scattering),
        cmocka_unit_test(rim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
