/* SPDX-License-Identifier: Apache-2.0 */
/* Solutions of several bands to VDB and back. */
#include "lit_volumes.h"

#include "murk/bands.h"

enum { BANDS_MAX = 5 };

/* Bands to write: the last has half the extinction of the others where it is not shared. */
typedef struct bands {
    size_t count;
    const char *name[BANDS_MAX];
    double factor[BANDS_MAX];
    bool own_extinction;
} bands;

typedef struct lit {
    murk_volume *source;
    murk_medium *medium[BANDS_MAX];
    murk_solution *solution[BANDS_MAX];
    size_t count;
} lit;

static lit make_lit(murk_context *context, const char *file, const bands *b)
{
    lit l = {.source = read_volume(context, odd(file)), .count = b->count};
    for (size_t i = 0; i < b->count; i++) {
        murk_medium_options options = MURK_MEDIUM_DEFAULT;
        options.extinction.scale = b->own_extinction && i + 1 == b->count ? 0.5 : 1;
        options.albedo.value = 0.9 - (double)i / 8;
        if (murk_medium_from_volume(context, l.source, &options, &l.medium[i]))
            fail_msg("%s", murk_context_message(context));
        l.solution[i] = make_solution(context, l.medium[i], b->factor[i]);
        murk_report *report = &l.solution[i]->report;
        report->method = "lines";
        report->tolerance = 0.01;
        report->estimate = b->factor[i] / 1024;
        report->reached = b->factor[i] < 5;
    }
    return l;
}

static void release_lit(lit *l)
{
    for (size_t i = 0; i < l->count; i++) {
        murk_solution_release(l->solution[i]);
        murk_medium_release(l->medium[i]);
    }
    murk_volume_release(l->source);
}

static murk_status write_lit(const lit *l, const bands *b, const char *path, bool half)
{
    const murk_write_options options = {.source = l->source,
                                        .emission_coefficient = true,
                                        .extinction = true,
                                        .albedo = true,
                                        .half = half,
                                        .command = "murk solve"};
    return murk_solutions_write((const murk_solution *const *)l->solution, b->name, l->count, path,
                                &options);
}

/* Has read_bands.py look at what was written. */
static void read_back(const char *file, const char *path, const bands *b, bool half)
{
    char command[3000];
    int used = snprintf(command, sizeof command, "/usr/bin/python3 %s '%s' density '%s' %s %s",
                        MURK_READ_BANDS, odd(file), path, half ? "half" : "full",
                        b->own_extinction ? "own" : "shared");
    for (size_t i = 0; i < b->count; i++)
        used += snprintf(command + used, sizeof command - (size_t)used, " %s=%g", b->name[i],
                         b->factor[i]);
    assert_int_equal(system(command), 0);
}

static void assert_band(murk_context *context, const lit *l, const murk_volume *volume, size_t band,
                        const char *name, float tolerance)
{
    const murk_scene scene = {.medium = l->medium[band], .sky_radiance = 0.5};
    const murk_solution *before = l->solution[band];
    murk_solution *after = NULL;
    if (murk_solution_from_volume_band(context, &scene, volume, name, &after))
        fail_msg("%s", murk_context_message(context));
    assert_int_equal(after->grid->zone_count, before->grid->zone_count);
    for (size_t i = 0; i < before->grid->brick_count * MURK_BRICK_SLOTS; i++)
        assert_float_equal(after->radiosity[i], before->radiosity[i],
                           tolerance * before->radiosity[i]);
    murk_solution_release(after);
}

static void assert_no_band(murk_context *context, const lit *l, const murk_volume *volume,
                           const char *name, const char *part)
{
    const murk_scene scene = {.medium = l->medium[0], .sky_radiance = 0.5};
    murk_solution *solution = NULL;
    assert_int_equal(murk_solution_from_volume_band(context, &scene, volume, name, &solution),
                     MURK_ERROR_INPUT);
    assert_null(solution);
    assert_message(context, part);
}

static void round_trip(murk_context *context, const char *file, const bands *b, bool half)
{
    const char *path = odd("lit_bands.vdb");
    lit l = make_lit(context, file, b);
    if (write_lit(&l, b, path, half))
        fail_msg("%s", murk_context_message(context));
    read_back(file, path, b, half);
    murk_volume *again = read_volume(context, path);
    assert_string_equal(murk_volume_density(again), "density");
    for (size_t i = 0; i < b->count; i++)
        assert_band(context, &l, again, i, b->name[i], half ? 1e-3f : 0);
    murk_volume_release(again);
    release_lit(&l);
}

static void test_round_trip(void **state)
{
    const bands all[] = {
        {5, {"NIR", "B", "G", "R", "LWIR"}, {0.5, 3, 2, 1, 5}, false},
        {4, {"R", "G", "B", "LWIR"}, {1, 2, 3, 5}, true},
        {3, {"R", "G", "B"}, {1, 2, 7}, false},
        {3, {"R", "B", "LWIR"}, {1, 2, 4}, true},
    };
    static const char *const files[] = {"rotated.vdb", "active_zeros.vdb", "empty.vdb"};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        for (size_t f = 0; f < sizeof files / sizeof *files; f++)
            if (strcmp(files[f], "empty.vdb") || !all[i].own_extinction)
                for (int half = 0; half < 2; half++)
                    round_trip(*state, files[f], &all[i], half);
}

/* Bands on other voxels than the first: each goes to a grid of its own, R, G and B too where one
   grid cannot hold them. */
static void test_own_voxels(void **state)
{
    const bands b = {4, {"R", "G", "B", "LWIR"}, {1, 2, 3, 4}, false};
    static const int other_of[] = {2, 3};
    for (int n = 0; n < 2; n++) {
        lit l = make_lit(*state, "active_zeros.vdb", &b), other = make_lit(*state, "half.vdb", &b);
        const int k = other_of[n];
        murk_solution *solution = l.solution[k];
        murk_medium *medium = l.medium[k];
        l.solution[k] = other.solution[k];
        l.medium[k] = other.medium[k];
        if (write_lit(&l, &b, odd("own_voxels.vdb"), false))
            fail_msg("%s", murk_context_message(*state));
        murk_volume *again = read_volume(*state, odd("own_voxels.vdb"));
        bool coloured = false;
        for (size_t i = 0; i < murk_vdb_count(again->vdb); i++)
            coloured |= murk_vdb_components(again->vdb, i) == 3;
        assert_int_equal(coloured, k == 3);
        for (size_t i = 0; i < b.count; i++)
            assert_band(*state, &l, again, i, b.name[i], 0);
        murk_volume_release(again);
        l.solution[k] = solution;
        l.medium[k] = medium;
        release_lit(&l);
        release_lit(&other);
    }
}

/* One band: a float radiosity, whose name, if there is one, is in the metadata. */
static void test_one_band(void **state)
{
    static const char *const names[] = {"NIR", "R", NULL};
    for (int n = 0; n < 3; n++) {
        const bands b = {1, {names[n]}, {2}, false};
        lit l = make_lit(*state, "rotated.vdb", &b);
        assert_int_equal(write_lit(&l, &b, odd("lit_band.vdb"), false), MURK_OK);
        murk_vdb *vdb = NULL;
        assert_int_equal(murk_vdb_read(*state, odd("lit_band.vdb"), &vdb), MURK_OK);
        assert_string_equal(murk_vdb_band(vdb), names[n] ? names[n] : "single");
        assert_int_equal(murk_vdb_count(vdb), 5);
        murk_vdb_release(vdb);
        murk_volume *again = read_volume(*state, odd("lit_band.vdb"));
        assert_band(*state, &l, again, 0, NULL, 0);
        assert_band(*state, &l, again, 0, names[n] ? names[n] : "anything", 0);
        if (names[n])
            assert_no_band(*state, &l, again, "LWIR", "lit_band.vdb: no band \"LWIR\"; it has ");
        if (n == 0)
            assert_no_band(*state, &l, again, "R", "it has radiosity (NIR)");
        murk_volume_release(again);
        release_lit(&l);
    }
}

static void test_unknown_band(void **state)
{
    const bands b = {4, {"R", "G", "B", "LWIR"}, {1, 2, 3, 4}, false};
    lit l = make_lit(*state, "rotated.vdb", &b);
    assert_int_equal(write_lit(&l, &b, odd("lit_bands.vdb"), false), MURK_OK);
    murk_volume *volume = read_volume(*state, odd("lit_bands.vdb"));
    assert_no_band(*state, &l, volume, "NIR",
                   "lit_bands.vdb: no band \"NIR\"; it has radiosity (R, G, B), radiosity_LWIR");
    assert_no_band(*state, &l, volume, "LWI", "no band \"LWI\"");
    assert_no_band(*state, &l, volume, NULL,
                   "lit_bands.vdb, grid radiosity: holds bands R, G, B; name the one to take");
    assert_no_band(*state, &l, l.source, "R", "no band \"R\"; it has no radiosity grid");
    murk_volume_release(volume);

    lit other = make_lit(*state, "active_zeros.vdb", &b);
    volume = read_volume(*state, odd("lit_bands.vdb"));
    assert_no_band(*state, &other, volume, "G", "lit_bands.vdb, grid radiosity, band G: ");
    murk_volume_release(volume);
    release_lit(&other);
    release_lit(&l);
}

/* Vector radiosities of other programs, with tiles, as streams, or of no use. */
static void test_foreign_colours(void **state)
{
    static const char *const files[] = {"coloured.vdb", "colours.vdb", "half_colours.vdb",
                                        "colours_stream.vdb", "half_colours_stream.vdb"};
    const int32_t inside[3] = {-2, -1, -2};
    murk_medium *medium = make_medium(*state, "half.vdb", NULL);
    const lit l = {.medium = {medium}};
    const murk_scene scene = {.medium = medium, .sky_radiance = 0.5};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        murk_volume *volume = read_volume(*state, odd(files[f]));
        for (int c = 0; c < 3; c++) {
            static const char *const names[] = {"R", "G", "B"};
            murk_solution *solution = NULL;
            if (murk_solution_from_volume_band(*state, &scene, volume, names[c], &solution))
                fail_msg("%s", murk_context_message(*state));
            assert_true(murk_solution_radiosity(solution, inside) == c + 1);
            murk_solution_release(solution);
        }
        assert_no_band(*state, &l, volume, NULL, "holds bands R, G, B");
        for (size_t i = 0; i < murk_vdb_count(volume->vdb); i++) {
            const char *name = murk_vdb_info(volume->vdb, i)->name;
            int components = !strcmp(name, "density") ? 1 : !strcmp(name, "radiosity") ? 3 : 0;
            assert_int_equal(murk_vdb_components(volume->vdb, i), components);
        }
        murk_volume_release(volume);
    }
    murk_volume *volume = read_volume(*state, odd("coloured_frustum.vdb"));
    assert_no_band(*state, &l, volume, "G", "grid radiosity: cannot be used: on a frustum");
    murk_volume_release(volume);
    volume = read_volume(*state, odd("precise_colours.vdb"));
    assert_no_band(*state, &l, volume, "G", "grid radiosity: cannot be used: of type vec3d");
    murk_volume_release(volume);
    murk_medium_release(medium);
}

static void assert_not_written(murk_context *context, const lit *l, const bands *b,
                               const char *part)
{
    const char *path = odd("not_written.vdb");
    assert_int_equal(write_lit(l, b, path, false), MURK_ERROR_INPUT);
    assert_message(context, part);
    assert_message(context, path);
    FILE *file = fopen(path, "rb");
    assert_null(file);
}

static void test_refusals(void **state)
{
    const bands good = {3, {"R", "G", "LWIR"}, {1, 2, 3}, false};
    const bands twice = {3, {"R", "G", "R"}, {1, 2, 3}, false};
    const bands nameless = {3, {"R", NULL, "B"}, {1, 2, 3}, false};
    const bands empty = {3, {"", "G", "B"}, {1, 2, 3}, false};
    const bands spaced = {3, {"R", "G", "a b"}, {1, 2, 3}, false};
    const bands lengthy = {
        3, {"R", "G", "abcdefghijklmnopqrstuvwxyz-1234567890abc"}, {1, 2, 3}, false};
    lit l = make_lit(*state, "rotated.vdb", &good);
    lit other = make_lit(*state, "active_zeros.vdb", &good);
    assert_not_written(*state, &l, &twice, "band R: there are two of that name");
    assert_not_written(*state, &l, &nameless, "band 2 of 3 has no name");
    assert_not_written(*state, &l, &empty, "band \"\": a name has letters");
    assert_not_written(*state, &l, &spaced, "band \"a b\": a name has letters");
    assert_not_written(*state, &l, &lengthy, "a name has letters, digits, _ and -, 39 at most");
    lit mixed = l;
    mixed.solution[2] = other.solution[2];
    assert_not_written(*state, &mixed, &good, "the bands R and LWIR are on different transforms");
    l.solution[1]->radiosity[0] = 70000; /* slot 0 counts, active or not */
    assert_int_equal(write_lit(&l, &good, odd("not_written.vdb"), true), MURK_ERROR_INPUT);
    assert_message(*state, "grid radiosity_G: 70000 is more than 16-bit floats hold");
    assert_int_equal(murk_solutions_write(NULL, NULL, 0, odd("not_written.vdb"), NULL),
                     MURK_ERROR_INPUT);
    release_lit(&other);
    release_lit(&l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),   cmocka_unit_test(test_one_band),
        cmocka_unit_test(test_unknown_band), cmocka_unit_test(test_foreign_colours),
        cmocka_unit_test(test_refusals),     cmocka_unit_test(test_own_voxels),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
