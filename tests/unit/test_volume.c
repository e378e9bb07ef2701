/* SPDX-License-Identifier: Apache-2.0 */
/* Media from volumes, and solutions to VDB and back. */
#include "lit_volumes.h"

#include <math.h>

static void assert_refused(murk_context *context, const char *file,
                           const murk_medium_options *options, const char *part)
{
    murk_volume *volume = read_volume(context, odd(file));
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_volume(context, volume, options, &medium), MURK_ERROR_INPUT);
    assert_null(medium);
    assert_message(context, part);
    assert_message(context, file);
    murk_volume_release(volume);
}

static double kappa_at(const murk_medium *medium, int i, int j, int k)
{
    int64_t slot = murk_grid_slot(medium->grid, i, j, k);
    assert_true(slot >= 0);
    return medium->kappa_t[slot];
}

static void test_quantities(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction.scale = 4;
    options.albedo.grid = "scatter";
    options.emission.grid = "glow";
    options.emission.scale = 0.5;
    murk_medium *medium = make_medium(*state, "medium.vdb", &options);
    int64_t slot = murk_grid_slot(medium->grid, 1, 2, 3); /* value (16 + 8 + 3 + 1) / 64 */
    assert_true(slot >= 0);
    assert_float_equal(medium->kappa_t[slot], 4 * 28.0 / 64, 1e-6);
    assert_float_equal(murk_value(&medium->albedo, (size_t)slot), 28.0 / 64, 1e-6);
    assert_float_equal(murk_value(&medium->emission, (size_t)slot), 0.5 * 280.0 / 64, 1e-5);
    assert_true(medium->grid->voxel[0] == 0.5 && medium->grid->voxel[2] == 0.25);
    murk_medium_release(medium);

    options = (murk_medium_options)MURK_MEDIUM_DEFAULT;
    options.extinction.value = 3;
    options.voxel_size = 1.5;
    medium = make_medium(*state, "medium.vdb", &options);
    assert_float_equal(kappa_at(medium, 0, 0, 0), 3, 0);
    assert_float_equal(kappa_at(medium, 3, 3, 3), 3, 0);
    assert_float_equal(medium->grid->voxel[0], 1.5, 1e-12);
    assert_float_equal(medium->grid->voxel[2], 0.75, 1e-12);
    murk_medium_release(medium);
}

static void test_corner(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    murk_medium_info centred, cornered;
    murk_medium *medium = make_medium(*state, "medium.vdb", &options);
    murk_medium_info_get(medium, &centred);
    murk_medium_release(medium);
    options.corner = true;
    medium = make_medium(*state, "medium.vdb", &options);
    murk_medium_info_get(medium, &cornered);
    murk_medium_release(medium);
    assert_float_equal(centred.box_min[0], -0.25, 1e-12);
    assert_float_equal(cornered.box_min[0], 0, 1e-12);
    assert_float_equal(cornered.box_max[2], 1, 1e-12);
}

static void test_topology(void **state)
{
    static const struct {
        const char *file;
        uint64_t zones, input, invalid;
    } all[] = {
        {"active_zeros.vdb", 128, 512, 0}, {"invalid.vdb", 59, 64, 4}, {"empty.vdb", 0, 0, 0},
        {"background.vdb", 64, 64, 0},     {"double.vdb", 63, 64, 1},  {"rotated.vdb", 729, 729, 0},
        {"tiles.vdb", 2098182, 2098182, 0}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        murk_medium_info info;
        murk_medium *medium = make_medium(*state, all[i].file, NULL);
        murk_medium_info_get(medium, &info);
        assert_int_equal(info.zones, all[i].zones);
        assert_int_equal(info.input_voxels, all[i].input);
        assert_int_equal(info.invalid_voxels, all[i].invalid);
        murk_medium_release(medium);
    }
}

static void test_refusals(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.strict = true;
    assert_refused(*state, "invalid.vdb", &options, "4");
    assert_refused(*state, "frustum.vdb", NULL, "frustum");
    assert_refused(*state, "sheared.vdb", NULL, "sheared");
    assert_refused(*state, "huge_tiles.vdb", NULL, "expand");
    assert_refused(*state, "several.vdb", NULL, "\"a\", \"b\"");
    assert_refused(*state, "int32.vdb", NULL, "no grid looks like a density");
    assert_refused(*state, "ball.vdb", NULL, "--grid");
    assert_refused(*state, "ball.vdb", NULL, "\"surface\" (a level set: its inside)");
    assert_refused(*state, "no_grids.vdb", NULL, "no grids");
    options = (murk_medium_options)MURK_MEDIUM_DEFAULT;
    options.albedo.grid = "bright";
    assert_refused(*state, "medium.vdb", &options, "albedo");
    options.albedo.grid = "scater";
    assert_refused(*state, "medium.vdb", &options, "there are \"scatter\", ");
    options = (murk_medium_options)MURK_MEDIUM_DEFAULT;
    options.extinction.grid = "velocity";
    assert_refused(*state, "beside.vdb", &options, "vec3s");
    options.extinction.grid = "smoke";
    assert_refused(*state, "points_stream.vdb", &options, "\"?\" (unreadable)");
    options.extinction.grid = "?";
    assert_refused(*state, "points_stream.vdb", &options, "behind grid points");
    options.extinction.grid = "points";
    assert_refused(*state, "points.vdb", &options, "of type point");
    options.extinction.grid = "density[7]";
    assert_refused(*state, "same_names.vdb", &options, "density[7]");
    options.extinction.grid = "density";
    options.extinction.scale = NAN;
    assert_refused(*state, "same_names.vdb", &options, "scale");
}

/* A plain name finds the first of several. */
static void test_names(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction.grid = "density";
    options.extinction.scale = 1;
    murk_medium *medium = make_medium(*state, "same_names.vdb", &options);
    assert_float_equal(kappa_at(medium, 0, 0, 0), 1e-9, 1e-15);
    murk_medium_release(medium);
    options.extinction.grid = "density[2]";
    medium = make_medium(*state, "same_names.vdb", &options);
    assert_float_equal(kappa_at(medium, 4, 4, 4), 1, 1e-6);
    murk_medium_release(medium);
}

/* A grid on another transform, here of voxels twice as long along z, is resampled. */
static void test_resampled(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.albedo.grid = "elsewhere";
    murk_medium *medium = make_medium(*state, "medium.vdb", &options);
    for (int z = 0; z < 4; z++) { /* value (16 x + 4 y + z / 2 + 1) / 64 */
        int64_t slot = murk_grid_slot(medium->grid, 2, 1, z);
        assert_true(slot >= 0);
        assert_float_equal(murk_value(&medium->albedo, (size_t)slot), (37 + 0.5 * z) / 64, 1e-6);
    }
    murk_medium_release(medium);
    options.corner =
        true; /* voxel z covers [z, z + 1] / 2 there: its centre lies a quarter lower */
    medium = make_medium(*state, "medium.vdb", &options);
    int64_t slot = murk_grid_slot(medium->grid, 2, 1, 2);
    assert_float_equal(murk_value(&medium->albedo, (size_t)slot), (37 + 0.75) / 64, 1e-6);
    murk_medium_release(medium);
}

static double sum_extinction(const murk_medium *medium)
{
    double sum = 0;
    for (size_t i = 0; i < medium->grid->brick_count * MURK_BRICK_SLOTS; i++)
        sum += medium->kappa_t[i];
    return sum * medium->grid->volume;
}

/* The inside of a level set: a ball of 20 voxels has the volume and the depth of one, and what lies
   in tiles is there. */
static void test_level_set(void **state)
{
    const double radius = 10, scale = 3;
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction = (murk_quantity){"surface", scale, 0};
    murk_medium *medium = make_medium(*state, "ball.vdb", &options);
    murk_medium_info info;
    murk_medium_info_get(medium, &info);
    assert_float_equal(sum_extinction(medium) / (scale * 4 / 3 * M_PI * pow(radius, 3)), 1, 2e-3);
    assert_float_equal(info.max_depth / (scale * 2 * radius), 1, 2e-3);
    assert_float_equal(info.mean_depth / (scale * 4 / 3. * radius), 1, 0.05); /* rim columns thin */
    assert_float_equal(kappa_at(medium, 0, 0, 0), scale, 0);
    murk_medium_release(medium);

    medium = make_medium(*state, "filled.vdb", &options);
    murk_medium_info_get(medium, &info);
    assert_int_equal(info.zones, 128 * 128 * 128 + 1);
    assert_int_equal(info.invalid_voxels, 1);
    assert_float_equal(kappa_at(medium, 127, 64, 1), scale, 0);
    assert_float_equal(kappa_at(medium, 128, 0, 0), scale * 0.25, 1e-6);
    murk_medium_release(medium);
}

/* Masks and whole numbers are a medium where they are asked for. */
static void test_other_types(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction = (murk_quantity){"mask", 2, 0};
    murk_medium *medium = make_medium(*state, "beside.vdb", &options);
    assert_float_equal(sum_extinction(medium), 2 * 64, 1e-9);
    murk_medium_release(medium);
    options.extinction.grid = "density";
    medium = make_medium(*state, "int32.vdb", &options);
    assert_float_equal(kappa_at(medium, 0, 0, 2), 6, 0);
    murk_medium_release(medium);
    options.extinction.grid = "long";
    medium = make_medium(*state, "int32.vdb", &options);
    assert_float_equal(kappa_at(medium, 3, 3, 3), 128, 0);
    murk_medium_release(medium);
}

/* What goes with a solution is the grid that the extinction came from, on whose transform the
   radiosity is. */
static void test_passes_extinction(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction.grid = "elsewhere";
    murk_medium *medium = make_medium(*state, "medium.vdb", &options);
    murk_volume *source = read_volume(*state, odd("medium.vdb"));
    murk_solution *solution = make_solution(*state, medium, 1);
    const murk_write_options write = {.source = source};
    assert_int_equal(murk_solution_write(solution, odd("chosen.vdb"), &write), MURK_OK);
    murk_volume *volume = read_volume(*state, odd("chosen.vdb"));
    assert_int_equal(murk_volume_grid_count(volume), 2);
    for (size_t i = 0; i < 2; i++) {
        murk_grid_info info;
        assert_int_equal(murk_volume_grid_info(volume, i, &info), MURK_OK);
        assert_true(!strcmp(info.name, "radiosity") || !strcmp(info.name, "elsewhere"));
        assert_float_equal(info.voxel_size[2], 0.5, 1e-12);
    }
    murk_volume_release(volume);
    murk_volume_release(source);
    murk_solution_release(solution);
    murk_medium_release(medium);
}

/* A solution is one of the asymmetry that it was solved with. */
static void test_foreign_asymmetry(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.asymmetry = 0.5;
    murk_medium *medium = make_medium(*state, "half.vdb", &options);
    murk_solution *solution = make_solution(*state, medium, 1), *again = NULL;
    assert_int_equal(murk_solution_write(solution, odd("forward.vdb"), NULL), MURK_OK);
    murk_volume *volume = read_volume(*state, odd("forward.vdb"));
    const murk_scene same = {.medium = medium, .sky_radiance = 0.5};
    assert_int_equal(murk_solution_from_volume(*state, &same, volume, &again), MURK_OK);
    murk_solution_release(again);
    again = NULL;
    options.asymmetry = 0.6;
    murk_medium *other = make_medium(*state, "half.vdb", &options);
    const murk_scene scene = {.medium = other, .sky_radiance = 0.5};
    assert_int_equal(murk_solution_from_volume(*state, &scene, volume, &again), MURK_ERROR_INPUT);
    assert_null(again);
    assert_message(*state, "forward.vdb: solved with asymmetry 0.5, but that of the medium is 0.6");
    murk_volume_release(volume);
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_medium_release(other);
}

static void write_and_check(murk_context *context, const char *file, const char *path,
                            const char *grid, bool half)
{
    murk_volume *source = read_volume(context, file);
    murk_medium *medium = NULL;
    assert_int_equal(murk_medium_from_volume(context, source, NULL, &medium), MURK_OK);
    murk_solution *solution = make_solution(context, medium, 1);
    const murk_write_options options = {.source = source,
                                        .emission_coefficient = true,
                                        .extinction = true,
                                        .albedo = true,
                                        .half = half,
                                        .command = "murk solve"};
    if (murk_solution_write(solution, path, &options))
        fail_msg("%s", murk_context_message(context));
    char command[2000];
    snprintf(command, sizeof command, "/usr/bin/python3 %s '%s' '%s' '%s'", MURK_READ_BACK, file,
             grid, path);
    assert_int_equal(system(command), 0);

    murk_volume *again = read_volume(context, path);
    murk_solution *second = NULL;
    const murk_scene scene = {.medium = medium, .sun = {{0, 0, -1}, 2}, .sky_radiance = 0.5};
    assert_string_equal(murk_volume_density(again), grid);
    if (murk_solution_from_volume(context, &scene, again, &second))
        fail_msg("%s", murk_context_message(context));
    assert_int_equal(second->grid->zone_count, solution->grid->zone_count);
    for (size_t i = 0; i < solution->grid->brick_count * MURK_BRICK_SLOTS; i++)
        assert_float_equal(second->radiosity[i], solution->radiosity[i],
                           half ? 1e-3 * solution->radiosity[i] : 0);
    murk_solution_release(second);
    murk_volume_release(again);
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_volume_release(source);
}

static void test_solution(void **state)
{
    write_and_check(*state, shipped("plume64_f045.vdb"), odd("lit_plume.vdb"), "density", false);
    write_and_check(*state, odd("rotated.vdb"), odd("lit_rotated.vdb"), "density", true);
    write_and_check(*state, odd("active_zeros.vdb"), odd("lit_zeros.vdb"), "density", false);
    write_and_check(*state, odd("flames.vdb"), odd("lit_flames.vdb"), "flames", false);
    write_and_check(*state, odd("empty.vdb"), odd("lit_empty.vdb"), "density", false);
}

/* Without a source the written transform puts indices at the centres of the zones. */
static void test_own_transform(void **state)
{
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.corner = true;
    murk_medium *medium = make_medium(*state, "medium.vdb", &options);
    murk_solution *solution = make_solution(*state, medium, 1);
    assert_int_equal(murk_solution_write(solution, odd("own.vdb"), NULL), MURK_OK);
    murk_volume *volume = read_volume(*state, odd("own.vdb"));
    murk_grid_info info;
    assert_int_equal(murk_volume_grid_info(volume, 0, &info), MURK_OK);
    assert_string_equal(info.name, "radiosity");
    assert_float_equal(info.index_to_world[0], 0.5, 1e-12);
    assert_float_equal(info.index_to_world[3], 0.25, 1e-12);
    assert_float_equal(info.index_to_world[11], 0.125, 1e-12);
    murk_volume_release(volume);
    murk_solution_release(solution);
    murk_medium_release(medium);
}

static void test_foreign_radiosity(void **state)
{
    murk_medium *medium = make_medium(*state, "lit.vdb", NULL);
    const murk_scene scene = {.medium = medium, .sky_radiance = 0.5};
    murk_solution *solution = NULL;
    murk_volume *lit = read_volume(*state, odd("lit.vdb"));
    murk_volume *unlit = read_volume(*state, odd("unlit.vdb"));
    murk_volume *without = read_volume(*state, odd("half.vdb"));
    if (murk_solution_from_volume(*state, &scene, lit, &solution))
        fail_msg("%s", murk_context_message(*state));
    const int32_t inside[3] = {-1, 5, 2};
    assert_float_equal(murk_solution_radiosity(solution, inside), 2, 0);
    murk_solution_release(solution);
    assert_int_equal(murk_solution_from_volume(*state, &scene, unlit, &solution), MURK_ERROR_INPUT);
    assert_message(*state, "unlit.vdb, grid radiosity: 37 of the medium's 64 zones");
    assert_int_equal(murk_solution_from_volume(*state, &scene, without, &solution),
                     MURK_ERROR_INPUT);
    assert_message(*state, "half.vdb: no grid \"radiosity\"");
    murk_volume_release(lit);
    murk_volume_release(unlit);
    murk_volume_release(without);
    murk_medium_release(medium);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_quantities),
        cmocka_unit_test(test_corner),
        cmocka_unit_test(test_topology),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_solution),
        cmocka_unit_test(test_own_transform),
        cmocka_unit_test(test_foreign_radiosity),
        cmocka_unit_test(test_resampled),
        cmocka_unit_test(test_level_set),
        cmocka_unit_test(test_other_types),
        cmocka_unit_test(test_passes_extinction),
        cmocka_unit_test(test_foreign_asymmetry),
    };
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
