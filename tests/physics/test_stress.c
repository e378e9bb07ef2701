/* SPDX-License-Identifier: Apache-2.0 */
/* Every row of the stress suite through every check: test_stress [GROUP | --table]. */
#include "stress.h"

/* The worst of a check in space and over ground; applies is false where it was asked for in
   neither. */
struct cell {
    bool applies;
    struct stress_outcome outcome;
};

/* A bound of 0 allows nothing: how far from it counts alone. */
static double badness(struct stress_outcome o)
{
    if (isnan(o.value) || isnan(o.bound))
        return INFINITY;
    return o.bound > 0 ? o.value / o.bound : o.value > 0 ? 1e9 + o.value : 0;
}

/* Fills the cells of a row, one a check. */
static void run_row(const struct stress_row *row, struct cell *cells)
{
    memset(cells, 0, STRESS_CHECK_COUNT * sizeof *cells);
    for (int ground = 0; ground < 2; ground++) {
        if (row->flags & (ground ? NO_GROUND : NO_SPACE))
            continue;
        struct stress_subject subject;
        bool opened = stress_subject_open(&subject, row, ground);
        for (size_t c = 0; c < STRESS_CHECK_COUNT; c++) {
            const struct stress_check *check = &STRESS_CHECKS[c];
            struct cell now = {true, {NAN, 0}};
            if (opened && check->applies && !check->applies(&subject))
                continue;
            if (opened)
                now.outcome = check->run(&subject);
            if (!cells[c].applies || badness(now.outcome) > badness(cells[c].outcome))
                cells[c] = now;
        }
        stress_subject_close(&subject);
    }
}

static bool holds(struct stress_outcome o)
{
    return o.value <= o.bound;
}

static void test_row(void **state)
{
    const struct stress_row *row = *state;
    struct cell cells[32];
    int failed = 0;
    run_row(row, cells);
    for (size_t c = 0; c < STRESS_CHECK_COUNT; c++)
        if (cells[c].applies && !holds(cells[c].outcome)) {
            print_error("%s, %s: %.3g, above %.3g\n", row->name, STRESS_CHECKS[c].name,
                        cells[c].outcome.value, cells[c].outcome.bound);
            failed++;
        }
    assert_int_equal(failed, 0);
}

/* The row of half floats from a VDB of half floats, bit for bit. */
static void half_file(void **state)
{
    (void)state;
    const struct stress_row *row = STRESS_ROWS;
    while (strcmp(row->name, "half floats"))
        row++;
    struct stress_scene scene = stress_row_scene(row, false);
    for (size_t n = 0; n < scene.count; n++)
        scene.voxel[n].emission = 0;
    struct world w;
    assert_true(stress_open(&w, &scene));
    assert_int_equal(murk_solve(w.context, &w.scene, NULL, &w.solution), MURK_OK);
    murk_write_options halves = MURK_WRITE_DEFAULT;
    halves.half = halves.extinction = halves.albedo = true;
    const char *path = MURK_ODD_DIR "/stress_half.vdb";
    assert_int_equal(murk_solution_write(w.solution, path, &halves), MURK_OK);

    murk_volume *volume;
    murk_medium_options options = MURK_MEDIUM_DEFAULT;
    options.extinction = (murk_quantity){"extinction", 1, 0};
    options.albedo = (murk_quantity){"albedo", 1, 0};
    murk_scene again = w.scene;
    murk_medium *medium;
    murk_solution *solution;
    assert_int_equal(murk_volume_read(w.context, path, &volume), MURK_OK);
    assert_int_equal(murk_medium_from_volume(w.context, volume, &options, &medium), MURK_OK);
    again.medium = medium;
    assert_int_equal(murk_solve(w.context, &again, NULL, &solution), MURK_OK);
    for (size_t n = 0; n < scene.count; n++) {
        const int32_t *at = scene.voxel[n].at;
        assert_within(murk_solution_radiosity(solution, at), world_b(&w, at[0], at[1], at[2]), 0);
    }
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_volume_release(volume);
    world_close(&w);
    stress_scene_clear(&scene);
}

/* ---- the table ----------------------------------------------------------------------------- */

static void print_cell(const struct cell *cell)
{
    const struct stress_outcome o = cell->outcome;
    if (!cell->applies)
        printf(" – |");
    else if (!holds(o))
        printf(" **%.2g** (%.2g) |", o.value, o.bound);
    else if (o.value == 0)
        printf(" 0 |");
    else
        printf(" %.2g |", o.value / o.bound);
}

static void print_table(void)
{
    printf("| row |");
    for (size_t c = 0; c < STRESS_CHECK_COUNT; c++)
        printf(" %s |", STRESS_CHECKS[c].name);
    printf("\n|---|");
    for (size_t c = 0; c < STRESS_CHECK_COUNT; c++)
        printf("---|");
    printf("\n");
    for (size_t r = 0; r < STRESS_ROW_COUNT; r++) {
        struct cell cells[32];
        run_row(&STRESS_ROWS[r], cells);
        printf("| %s |", STRESS_ROWS[r].name);
        for (size_t c = 0; c < STRESS_CHECK_COUNT; c++)
            print_cell(&cells[c]);
        printf("\n");
        fflush(stdout);
    }
}

int main(int count, char **arguments)
{
    static const char *const groups[STRESS_GROUPS] = {"optics", "shapes", "lights"};
    if (count > 1 && !strcmp(arguments[1], "--table")) {
        print_table();
        return 0;
    }
    struct CMUnitTest tests[128];
    size_t chosen = 0;
    for (size_t r = 0; r < STRESS_ROW_COUNT; r++)
        if (count < 2 || !strcmp(arguments[1], groups[STRESS_ROWS[r].group]))
            tests[chosen++] = (struct CMUnitTest){STRESS_ROWS[r].name, test_row, NULL, NULL,
                                                  (void *)&STRESS_ROWS[r]};
    if (count < 2 || !strcmp(arguments[1], groups[STRESS_OPTICS]))
        tests[chosen++] = (struct CMUnitTest)cmocka_unit_test(half_file);
    return _cmocka_run_group_tests("stress", tests, chosen, NULL, NULL);
}
