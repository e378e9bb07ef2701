/* SPDX-License-Identifier: Apache-2.0 */
/* Black bodies: tabulated fractions, Stefan and Boltzmann, Wien, an independent quadrature, and the
   way back to the temperature. */
#include "apparent.h"
#include "check.h"

static const double SIGMA = 5.670374419e-8; /* W/m^2/K^4 */

/* Fractions of sigma T^4 below lambda T [um K]: by Simpson's rule with 400,000 steps, and the five
   digits that books on radiative transfer print are the same (those of Incropera and DeWitt, table
   12.1, are up to 5e-5 too high above 3000 um K). */
static void tabulated(void **state)
{
    (void)state;
    static const double table[][2] = {
        {1000, 0.000320770},  {1400, 0.007790389},  {2000, 0.066729940},  {2400, 0.140257382},
        {3000, 0.273229260},  {4000, 0.480864644},  {5000, 0.633725872},  {6000, 0.737789418},
        {8000, 0.856250694},  {10000, 0.914156971}, {12000, 0.945053269}, {20000, 0.985553839},
        {50000, 0.998903877}, {100000, 0.999855210}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (double kelvin = 250; kelvin < 3000; kelvin *= 1.7) {
            const murk_band band = {{1e-12, 1e-6 * table[i][0] / kelvin}};
            double fraction = M_PI * murk_planck_radiance(&band, kelvin) / (SIGMA * pow(kelvin, 4));
            assert_within(fraction, table[i][1], 2e-9);
        }
}

static void whole_spectrum(void **state)
{
    (void)state;
    for (double kelvin = 3; kelvin < 1e5; kelvin *= 3) {
        const murk_band all = {{1e-10 / kelvin, 1e6 / kelvin}};
        double power = M_PI * murk_planck_radiance(&all, kelvin);
        assert_within(power / (SIGMA * pow(kelvin, 4)), 1, 1e-9);
    }
}

/* Simpson's rule over the logarithm of the wavelength, on Planck's law per wavelength. */
static double by_quadrature(const murk_band *band, double kelvin)
{
    enum { STEPS = 2000 };
    double from = log(band->wavelength[0]), width = log(band->wavelength[1]) - from, sum = 0;
    for (int i = 0; i <= STEPS; i++) {
        double lambda = exp(from + width * i / STEPS);
        const murk_band here = {{lambda, lambda}};
        double weight = i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2;
        sum += weight * lambda * 1e6 * murk_planck_radiance(&here, kelvin);
    }
    return sum * width / STEPS / 3;
}

static const murk_band BANDS[] = {{{0.4e-6, 0.5e-6}}, {{0.6e-6, 0.7e-6}}, {{1e-6, 2.5e-6}},
                                  {{3e-6, 5e-6}},     {{8e-6, 12e-6}},    {{100e-6, 1000e-6}}};
enum { BAND_COUNT = sizeof BANDS / sizeof *BANDS };

static void bands(void **state)
{
    (void)state;
    for (int b = 0; b < BAND_COUNT; b++)
        for (double kelvin = 200; kelvin < 5000; kelvin *= 1.5)
            assert_within(murk_planck_radiance(&BANDS[b], kelvin) /
                              by_quadrature(&BANDS[b], kelvin),
                          1, 1e-9);
}

/* At one wavelength: 2 h c^2 / lambda^5 / (exp(h c / (lambda k T)) - 1) of 10 um and 300 K, and the
   limit of narrow bands. */
static void one_wavelength(void **state)
{
    (void)state;
    const murk_band line = {{10e-6, 10e-6}}, narrow = {{9.99e-6, 10.01e-6}};
    double per_um = murk_planck_radiance(&line, 300);
    assert_within(per_um, 9.92403, 1e-4);
    assert_within(murk_planck_radiance(&narrow, 300) / 0.02 / per_um, 1, 1e-6);
}

static void back(void **state)
{
    (void)state;
    for (int b = 0; b <= BAND_COUNT; b++)
        for (double kelvin = 30; kelvin < 2e4; kelvin *= 1.3) {
            const murk_band line = {{4e-6, 4e-6}}, *band = b < BAND_COUNT ? &BANDS[b] : &line;
            double radiance = murk_planck_radiance(band, kelvin);
            if (radiance > 1e-300)
                assert_within(murk_planck_temperature(band, radiance) / kelvin, 1, 1e-9);
        }
}

/* The table for pictures is the same function, over 30 decades and over next to none. */
static void table(void **state)
{
    (void)state;
    static murk_apparent apparent;
    for (int b = 0; b < BAND_COUNT; b++)
        for (int narrow = 0; narrow < 2; narrow++) {
            double middle = murk_planck_radiance(&BANDS[b], 700);
            double low = middle * (narrow ? 1 - 1e-6 : 1e-15), high = middle * (narrow ? 1 : 1e15);
            murk_apparent_init(&BANDS[b], low, high, &apparent);
            for (int n = 0; n <= 1000; n++) {
                double radiance = low * pow(high / low, n / 1000.0);
                assert_within(murk_apparent_temperature(&apparent, radiance) /
                                  murk_planck_temperature(&BANDS[b], radiance),
                              1, 6e-8);
            }
            assert_true(murk_apparent_temperature(&apparent, 0) == 0);
        }
}

static void nothing(void **state)
{
    (void)state;
    const murk_band wrong = {{5e-6, 3e-6}}, none = {{0, 0}};
    assert_true(murk_planck_radiance(&BANDS[3], 0) == 0);
    assert_true(murk_planck_radiance(&BANDS[3], -5) == 0);
    assert_true(murk_planck_radiance(&BANDS[3], NAN) == 0);
    assert_true(murk_planck_radiance(&wrong, 300) == 0);
    assert_true(murk_planck_radiance(&none, 300) == 0);
    assert_true(murk_planck_temperature(&BANDS[3], 0) == 0);
    assert_true(murk_planck_temperature(&BANDS[3], NAN) == 0);
    assert_false(murk_band_valid(&wrong) || murk_band_valid(&none));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tabulated), cmocka_unit_test(whole_spectrum),
        cmocka_unit_test(bands),     cmocka_unit_test(one_wavelength),
        cmocka_unit_test(back),      cmocka_unit_test(nothing),
        cmocka_unit_test(table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
