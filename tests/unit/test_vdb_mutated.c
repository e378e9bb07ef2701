/* SPDX-License-Identifier: Apache-2.0 */
/* The shipped volumes cut short everywhere and with single bits and bytes changed: each is read, or
   refused in one line. */
#include "vdb_bytes.h"

#include "vdb.h"

/* Numbers below a bound, the same in every run. */
static size_t draw(uint32_t *random, size_t bound)
{
    *random = *random * 1664525u + 1013904223u;
    return (size_t)(((uint64_t)*random * bound) >> 32);
}

/* Reads bytes that may be damaged, as far as to the bricks of all grids; gives whether they pass.
 */
static bool try_reading(murk_context *context, const unsigned char *bytes, size_t size)
{
    const char *path = odd("mutated.vdb");
    murk_vdb *vdb = NULL;
    save(path, bytes, size);
    murk_status status = murk_vdb_read(context, path, &vdb);
    for (size_t i = 0; !status && i < murk_vdb_count(vdb); i++) {
        murk_bricks bricks = {0};
        if (murk_vdb_info(vdb, i)->readable)
            status = murk_vdb_bricks(context, vdb, i, 0, &bricks);
        murk_bricks_clear(&bricks);
    }
    if (status) {
        assert_int_equal(status, MURK_ERROR_INPUT);
        assert_message(context, path);
        assert_null(strstr(murk_context_message(context), "took more than"));
    }
    murk_vdb_release(vdb);
    return !status;
}

/* Every 1/64 of the length, and a flipped bit or another byte: half of them in the header, the rest
   anywhere. */
static void mutate(murk_context *context, const char *file, int times)
{
    content whole = load(file);
    uint32_t random = 1;
    int passed = 0;
    for (size_t i = 0; i < 64; i++)
        assert_false(try_reading(context, whole.bytes, whole.size * i / 64));
    for (int i = 0; i < times; i++) {
        size_t at = draw(&random, i % 2 ? 800 : whole.size);
        unsigned char before = whole.bytes[at];
        whole.bytes[at] ^=
            (unsigned char)(draw(&random, 4) ? 1u << draw(&random, 8) : 1 + draw(&random, 255));
        passed += try_reading(context, whole.bytes, whole.size);
        whole.bytes[at] = before;
    }
    assert_true(passed > 0 && passed < times);
    assert_true(try_reading(context, whole.bytes, whole.size));
    free(whole.bytes);
}

static void test_mutated(void **state)
{
    mutate(*state, shipped("box.vdb"), 300);
    mutate(*state, shipped("plume64_f045.vdb"), 100);
    mutate(*state, shipped("screen128_f060.vdb"), 60);
    mutate(*state, shipped("fire80_f032.vdb"), 60);
    mutate(*state, shipped("plume128_f038.vdb"), 60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mutated)};
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
