/* SPDX-License-Identifier: Apache-2.0 */
/* Images cut short, with bits and bytes changed, and with headers that claim too much: each is
   read, or refused in one line. */
#include "vdb_bytes.h"

#include "context.h"
#include "deep.h"
#include "murk/memory.h"

static const char *const NAMES[] = {"R", "G", "B", "A"};

/* Numbers below a bound, the same in every run. */
static size_t draw(uint32_t *random, size_t bound)
{
    *random = *random * 1664525u + 1013904223u;
    return (size_t)(((uint64_t)*random * bound) >> 32);
}

/* Gives whether the bytes pass as an image. */
static bool try_reading(murk_context *context, const char *name, const void *bytes, size_t size)
{
    const char *path = odd(name);
    murk_image *image = NULL;
    save(path, bytes, size);
    murk_status status = murk_image_read(context, path, &image);
    if (status) {
        assert_int_equal(status, MURK_ERROR_INPUT);
        assert_message(context, path);
    }
    murk_image_release(image);
    return !status;
}

static content write_image(murk_context *context, const char *name)
{
    murk_image *image = NULL;
    uint32_t random = 7;
    assert_int_equal(murk_image_create(context, 24, 40, 4, NAMES, &image), MURK_OK);
    for (size_t i = 0; i < 24 * 40 * 4; i++)
        murk_image_pixels(image)[i] = (float)draw(&random, 1000) / 1000;
    if (murk_image_write(context, image, odd(name), NULL))
        fail_msg("%s", murk_context_message(context));
    murk_image_release(image);
    return load(odd(name));
}

/* The image as it is passes, and what is made of it passes or fails. */
static void mutate(murk_context *context, const char *name)
{
    content whole = write_image(context, name);
    uint32_t random = 1;
    assert_true(try_reading(context, name, whole.bytes, whole.size));
    for (size_t i = 0; i < 4; i++)
        try_reading(context, name, whole.bytes, whole.size * i / 4);
    assert_false(try_reading(context, name, whole.bytes, 10));
    for (int i = 0; i < 16; i++) {
        size_t at = draw(&random, i % 2 && whole.size > 400 ? 400 : whole.size);
        unsigned char before = whole.bytes[at];
        whole.bytes[at] ^= (unsigned char)(1 + draw(&random, 255));
        try_reading(context, name, whole.bytes, whole.size);
        whole.bytes[at] = before;
    }
    free(whole.bytes);
}

static void test_mutated(void **state)
{
    mutate(*state, "mutated.exr");
    mutate(*state, "mutated.tif");
#ifndef MURK_SANITIZED /* libpng jumps over the ends of OpenImageIO's strings, which leak */
    mutate(*state, "mutated.png");
#endif
    mutate(*state, "mutated.jpg");
}

/* OpenImageIO 2.4 crashes on it, sound as it is. */
static void test_deep(void **state)
{
    murk_context *context = *state;
    murk_deep *deep = NULL;
    const murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    void *bytes = NULL;
    size_t size = 0;
    assert_int_equal(murk_deep_create(context, 4, 4, 4, &deep), MURK_OK);
    assert_int_equal(murk_oiio_encode_deep(context, "deep.exr", deep, &options, &bytes, &size),
                     MURK_OK);
    assert_false(try_reading(context, "deep.exr", bytes, size));
    assert_message(context, "is a deep image");
    free(bytes);
    murk_deep_release(deep);
}

/* A few bytes that claim gigabytes take none. */
static void test_claims(void **state)
{
    static const char radiance[] =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 20000\nabcdef";
    static const char pixmap[] = "P6\n20000 20000\n255\nabcdef";
    assert_false(try_reading(*state, "claims.hdr", radiance, sizeof radiance));
    assert_message(*state, "claims 20000 x 20000 pixels of 3 channels in");
    assert_false(try_reading(*state, "claims.ppm", pixmap, sizeof pixmap));
    assert_message(*state, "claims 20000 x 20000 pixels of 3 channels in");
}

static void test_limit(void **state)
{
    static const char pixmap[] = "P6\n1000 1000\n255\nabcdef";
    murk_image *image = NULL;
    save(odd("limit.ppm"), (const unsigned char *)pixmap, sizeof pixmap);
    murk_memory_limit(murk_memory_used() + 1000000);
    assert_int_equal(murk_image_read(*state, odd("limit.ppm"), &image), MURK_ERROR_MEMORY);
    murk_memory_limit(0);
    assert_message(*state, "limit.ppm: reading needs about");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mutated), cmocka_unit_test(test_deep),
                                       cmocka_unit_test(test_claims), cmocka_unit_test(test_limit)};
    return cmocka_run_group_tests(tests, make_context, drop_context);
}
