/* SPDX-License-Identifier: Apache-2.0 */
#include "varied.h"

void setting_fill_at_random(struct setting *s, double least, double most)
{
    uint64_t random = 33;
    for (int n = 0; n < zone_count(&s->mc); n++) {
        double x = check_random(&random), y = check_random(&random);
        s->kappa_t[n] = x < 0.3 ? 0 : (float)(0.2 * pow(100, y));
        s->albedo[n] = (float)(least + (most - least) * check_random(&random));
    }
}

static void box_on_ground(struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, 6, 5, 4);
    setting_fill(s, 4, 0.9);
    setting_lay_ground(mc, 1, 0);
    for (int n = 0; n < patch_count(mc); n++)
        s->rho[n] = (n + n / 8) % 3 ? 0.3f : 0.8f;
    setting_sun(mc, 0.48, -0.36, -0.8);
    mc->sky_radiance = 0.1;
}

static void varied_with_hot_corner(struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, 10, 9, 8);
    setting_fill_at_random(s, 0.2, 0.99);
    for (int n = 0; n < zone_count(mc); n++)
        s->emission[n] = n / 72 < 3 && n / 8 % 9 < 3 && n % 8 < 3 ? 5 : 0;
    setting_sun(mc, 0.64, 0.48, -0.6);
}

static void box_over_bright_square(struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, 8, 8, 5);
    setting_fill(s, 3, 0.8);
    setting_lay_ground(mc, 1, 0.3);
    for (int n = 0; n < patch_count(mc); n++) {
        s->rho[n] = 0.2f;
        s->glow[n] = n % 10 >= 2 && n % 10 < 5 && n / 10 >= 5 && n / 10 < 8 ? 2 : 0.1f;
    }
    mc->sky_radiance = 0.05;
}

/* All there is: voids and zones of up to 2 optical depths, any albedo, a hot corner, a ground of
   patches that differ, sun and sky. */
static void everything(struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, 10, 9, 8);
    setting_fill_at_random(s, 0.2, 0.99);
    for (int n = 0; n < zone_count(mc); n++)
        s->emission[n] = n / 72 < 3 && n / 8 % 9 < 3 && n % 8 < 3 ? 2 : 0.1f;
    setting_lay_ground(mc, 1, 0.05);
    for (int n = 0; n < patch_count(mc); n++) {
        s->rho[n] = (n + n / 12) % 3 ? 0.2f : 0.7f;
        s->glow[n] = n % 5 ? 0 : 0.2f;
    }
    setting_sun(mc, -0.48, 0.64, -0.6);
    mc->sky_radiance = 0.1;
}

/* Nearly all light is scattered once: B shows the beam itself. */
static void varied_in_the_sun(struct setting *s)
{
    struct bench_mc_scene *mc = setting_start(s, 10, 9, 8);
    setting_fill_at_random(s, 0.05, 0.1);
    setting_sun(mc, 0.64, 0.48, -0.6);
}

const struct varied_scene VARIED[VARIED_SCENES] = {
    {"box on ground", box_on_ground, 2000000},
    {"varied, hot corner", varied_with_hot_corner, 2000000},
    {"box over bright square", box_over_bright_square, 2000000},
    {"varied in the sun", varied_in_the_sun, 8000000},
    {"everything", everything, 2000000},
};
