/* SPDX-License-Identifier: Apache-2.0 */
/* Files of aerosols: what is read, what is refused, and means over bands. */
#include "check.h"
#include "obscurant.h"

#include <dirent.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_obscurant_XXXXXX", path[64];

static int open_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return 1;
    snprintf(path, sizeof path, "%s/a.json", folder);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

static murk_status read_text(const char *json, struct scene_obscurant *out, char *message)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(json, file);
    fclose(file);
    return scene_obscurant_read(path, out, message);
}

static struct scene_obscurant read_good(const char *json)
{
    struct scene_obscurant out;
    char message[SCENE_MESSAGE_SIZE] = "";
    if (read_text(json, &out, message))
        fail_msg("%s", message);
    return out;
}

/* One number stands for all wavelengths; texts may be absent. */
static void content(void **state)
{
    (void)state;
    struct scene_obscurant o = read_good("{\"wavelength\": [4e-7, 7e-7], \"asymmetry\": -0.5, "
                                         "\"mass_extinction\": [10, 8], \"albedo\": 0.25, "
                                         "\"name\": \"soot\", \"source\": null}");
    assert_int_equal(o.count, 2);
    assert_string_equal(o.name, "soot");
    assert_null(o.source);
    assert_within(o.wavelength[1], 7e-7, 0);
    assert_within(o.optics[0].mass_extinction, 10, 0);
    assert_within(o.optics[1].mass_extinction, 8, 0);
    assert_within(o.optics[1].albedo, 0.25, 0);
    assert_within(o.optics[1].asymmetry, -0.5, 0);
    scene_obscurant_release(&o);
    assert_null(o.optics);
}

static struct scene_optics mean(const struct scene_obscurant *o, double low, double high)
{
    const double band[2] = {low, high};
    struct scene_optics out;
    char message[SCENE_MESSAGE_SIZE] = "";
    if (scene_obscurant_band(o, band, &out, message))
        fail_msg("%s", message);
    return out;
}

static void assert_optics(struct scene_optics o, double k, double albedo, double asymmetry)
{
    assert_within(o.mass_extinction, k, 1e-12);
    assert_within(o.albedo, albedo, 1e-12);
    assert_within(o.asymmetry, asymmetry, 1e-12);
}

/* k 2, 4, 1; a 0.5, 1, 0; g 0, 0.8, 0.3 at 1, 2 and 4 um. */
static void means(void **state)
{
    (void)state;
    struct scene_obscurant o =
        read_good("{\"wavelength\": [1e-6, 2e-6, 4e-6], \"mass_extinction\": [2, 4, 1], "
                  "\"albedo\": [0.5, 1, 0], \"asymmetry\": [0, 0.8, 0.3]}");
    assert_optics(mean(&o, 1e-6, 1e-6), 2, 0.5, 0);
    assert_optics(mean(&o, 4e-6, 4e-6), 1, 0, 0); /* nothing scattered, so no asymmetry */
    assert_optics(mean(&o, 1.5e-6, 1.5e-6), 3, 0.75, 0.4);
    /* k: (2 + 4)/2; k a: (1 + 4)/2 = 2.5; k a g: (0 + 3.2)/2 = 1.6. */
    assert_optics(mean(&o, 1e-6, 2e-6), 3, 2.5 / 3, 1.6 / 2.5);
    /* Over both intervals, of 1 and 2 um: k (3 + 2 2.5)/3, k a (2.5 + 2 2)/3, k a g (1.6 +
     * 2 1.6)/3. */
    assert_optics(mean(&o, 1e-6, 4e-6), 8.0 / 3, 6.5 / 8, 4.8 / 6.5);
    /* From 1.5 um (k 3, a 0.75, g 0.4) over 2 um to 3 um (k 2.5, a 0.5, g 0.55), 0.5 and 1 um:
       k (0.5 3.5 + 3.25)/1.5; k a 2.25, 4, 1.25; k a g 0.9, 3.2, 0.6875. */
    const double k = 0.5 * 3.5 + 3.25, ka = 0.5 * 3.125 + 2.625, kag = 0.5 * 2.05 + 1.94375;
    assert_optics(mean(&o, 1.5e-6, 3e-6), k / 1.5, ka / k, kag / ka);
    scene_obscurant_release(&o);
}

static void expect_outside(const struct scene_obscurant *o, double low, double high,
                           const char *wanted)
{
    const double band[2] = {low, high};
    struct scene_optics out = {-1, -1, -1};
    char message[SCENE_MESSAGE_SIZE] = "";
    assert_int_equal(scene_obscurant_band(o, band, &out, message), MURK_ERROR_INPUT);
    assert_non_null(strstr(message, path));
    if (!strstr(message, wanted))
        fail_msg("\"%s\" has no \"%s\"", message, wanted);
    assert_within(out.albedo, -1, 0);
}

/* Nothing is extrapolated; one wavelength serves the bands that hold it. */
static void coverage(void **state)
{
    (void)state;
    struct scene_obscurant o = read_good("{\"wavelength\": [4e-7, 7e-7], \"mass_extinction\": 8, "
                                         "\"albedo\": 0.2, \"asymmetry\": 0.3}");
    assert_optics(mean(&o, 0.4e-6, 0.7e-6), 8, 0.2, 0.3);
    expect_outside(
        &o, 0.39e-6, 0.5e-6,
        "covers 4e-07 to 7e-07 m, which the band from 3.9e-07 to 5e-07 m reaches beyond");
    expect_outside(&o, 0.6e-6, 0.71e-6, "covers 4e-07 to 7e-07 m");
    expect_outside(&o, 8e-6, 12e-6, "covers 4e-07 to 7e-07 m");
    scene_obscurant_release(&o);

    o = read_good("{\"wavelength\": 6.33e-7, \"mass_extinction\": 8.7, \"albedo\": [0.2], "
                  "\"asymmetry\": 0.3}");
    assert_optics(mean(&o, 0.6e-6, 0.7e-6), 8.7, 0.2, 0.3);
    assert_optics(mean(&o, 6.33e-7, 6.33e-7), 8.7, 0.2, 0.3);
    expect_outside(&o, 0.5e-6, 0.6e-6,
                   "has 6.33e-07 m alone, which the band from 5e-07 to 6e-07 m does not hold");
    scene_obscurant_release(&o);
}

/* The value of a key in an otherwise good file, and what the message says. */
static void errors(void **state)
{
    static const struct {
        const char *json, *message;
    } CASES[] = {
        {"[]", "not an object {...}"},
        {"{", ":1:1: "},
        {"{\"albedo\": NaN}", ":1:"},
        {"{\"albedo\": 1e999}", ":1:"},
        {"{\"albedo\": 1, \"albedo\": 1}", "duplicate"},
        {"{\"wavelenght\": 1e-6}",
         "wavelenght: unknown key; the nearest known one is \"wavelength\""},
        {"{\"wavelength\": 1e-6, \"mass_extinction\": 1, \"albedo\": 1}", "no \"asymmetry\""},
        {"{\"name\": 3}", "name: not a text in quotes"},
        {"{\"wavelength\": 0.55}", "wavelength: 0.55 is not between 1e-8 and 0.01 metres"},
        {"{\"wavelength\": []}", "wavelength: is empty"},
        {"{\"wavelength\": \"1e-6\"}", "wavelength: not a number or an array of numbers"},
        {"{\"wavelength\": [1e-6, null]}", "wavelength[1]: not a number"},
        {"{\"mass_extinction\": [1, -2]}", "mass_extinction[1]: -2 is not a number >= 0 [m^2/g]"},
        {"{\"albedo\": 1.01}", "albedo: 1.01 is not between 0 and 1"},
        {"{\"albedo\": [-0.1]}", "albedo[0]: -0.1 is not between 0 and 1"},
        {"{\"asymmetry\": 1}", "asymmetry: 1 is not between -1 and 1"},
        {"{\"asymmetry\": [0, -1]}", "asymmetry[1]: -1 is not between -1 and 1"},
        {"{\"wavelength\": [1e-6, 2e-6], \"mass_extinction\": 1, \"albedo\": [1, 1, 1], "
         "\"asymmetry\": 0}",
         "albedo: 3 numbers for 2 wavelengths: needs as many, or one number for all"},
        {"{\"wavelength\": [2e-6, 2e-6], \"mass_extinction\": 1, \"albedo\": 1, \"asymmetry\": 0}",
         "wavelength: has to ascend"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        struct scene_obscurant out = {.count = 7};
        char message[SCENE_MESSAGE_SIZE] = "";
        assert_int_equal(read_text(CASES[i].json, &out, message), MURK_ERROR_INPUT);
        assert_int_equal(out.count, 7);
        assert_int_equal(strncmp(message, path, strlen(path)), 0);
        if (!strstr(message, CASES[i].message))
            fail_msg("\"%s\" has no \"%s\"", message, CASES[i].message);
    }
    struct scene_obscurant out;
    char message[SCENE_MESSAGE_SIZE] = "";
    assert_int_equal(scene_obscurant_read("/nowhere.json", &out, message), MURK_ERROR_INPUT);
    assert_string_equal(message, "/nowhere.json: cannot read: No such file or directory");
}

/* The shipped ones are complete, name their source, and serve every band that has a name. */
static void shipped(void **state)
{
    static const double BANDS[][2] = {{4e-7, 5e-7},   {5e-7, 6e-7}, {6e-7, 7e-7}, {7.5e-7, 1.4e-6},
                                      {1.4e-6, 3e-6}, {3e-6, 5e-6}, {8e-6, 12e-6}};
    DIR *all = opendir(MURK_OBSCURANTS_DIR);
    int count = 0;
    (void)state;
    assert_non_null(all);
    for (const struct dirent *entry; (entry = readdir(all));) {
        struct scene_obscurant o;
        char file[512], message[SCENE_MESSAGE_SIZE] = "";
        if (!strstr(entry->d_name, ".json"))
            continue;
        snprintf(file, sizeof file, MURK_OBSCURANTS_DIR "/%s", entry->d_name);
        if (scene_obscurant_read(file, &o, message))
            fail_msg("%s", message);
        assert_true(o.name && o.source && strlen(o.source) > 100);
        for (size_t n = 0; n < sizeof BANDS / sizeof *BANDS; n++)
            assert_true(mean(&o, BANDS[n][0], BANDS[n][1]).mass_extinction > 0);
        scene_obscurant_release(&o);
        count++;
    }
    closedir(all);
    assert_true(count >= 3);
}

/* What others measured, which no shipped file was made from: smoke of flames at 633 nm (Mulholland
   and Croarkin 2000: 8.7 +- 1.1 m^2/g), and what a gram of stratocumulus absorbs from 10 to 12 um
   (Platt 1976: 0.070 to 0.103 m^2/g). */
static void measured(void **state)
{
    struct scene_obscurant o;
    char message[SCENE_MESSAGE_SIZE] = "";
    (void)state;
    if (scene_obscurant_read(MURK_OBSCURANTS_DIR "/soot.json", &o, message))
        fail_msg("%s", message);
    assert_within(mean(&o, 6.33e-7, 6.33e-7).mass_extinction, 8.7, 1.1);
    assert_within(mean(&o, 5.5e-7, 5.5e-7).mass_extinction * (1 - mean(&o, 5.5e-7, 5.5e-7).albedo),
                  7.5, 0.01);
    scene_obscurant_release(&o);
    if (scene_obscurant_read(MURK_OBSCURANTS_DIR "/stratus.json", &o, message))
        fail_msg("%s", message);
    struct scene_optics window = mean(&o, 1e-5, 1.2e-5);
    assert_within(window.mass_extinction * (1 - window.albedo), 0.0865, 0.0165);
    scene_obscurant_release(&o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(content),  cmocka_unit_test(means),
                                       cmocka_unit_test(coverage), cmocka_unit_test(errors),
                                       cmocka_unit_test(shipped),  cmocka_unit_test(measured)};
    return cmocka_run_group_tests(tests, open_folder, remove_folder);
}
