/* SPDX-License-Identifier: Apache-2.0 */
/* Attributes of images, in memory and through files. */
#include "check.h"

#include <unistd.h>

static const char *const NAMES[] = {"R", "G", "B"};

static murk_image *create(murk_context *context)
{
    murk_image *image = NULL;
    assert_int_equal(murk_image_create(context, 3, 2, 3, NAMES, &image), MURK_OK);
    return image;
}

static void in_memory(void **state)
{
    murk_image *image = create(*state);
    char name[] = "murk:bands", text[] = "R:6e-07:7e-07";
    assert_null(murk_image_attribute(image, name));
    assert_int_equal(murk_image_set_attribute(image, name, text), MURK_OK);
    name[0] = text[0] = 'x'; /* both were copied */
    assert_string_equal(murk_image_attribute(image, "murk:bands"), "R:6e-07:7e-07");
    assert_int_equal(murk_image_set_attribute(image, "other", ""), MURK_OK);
    assert_int_equal(murk_image_set_attribute(image, "murk:bands", "G:0:0"), MURK_OK);
    assert_string_equal(murk_image_attribute(image, "murk:bands"), "G:0:0");
    assert_string_equal(murk_image_attribute(image, "other"), "");
    assert_null(murk_image_attribute(image, "murk"));
    assert_int_equal(murk_image_set_attribute(image, "", "text"), MURK_ERROR_INPUT);
    murk_image_release(image);
}

static murk_image *through_file(murk_context *context, const murk_image *image, const char *name)
{
    char folder[] = "/tmp/murk_image_XXXXXX", path[64];
    murk_image *read = NULL;
    murk_image_write_options options = MURK_IMAGE_WRITE_DEFAULT;
    options.command = "murk image a.json";
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (murk_image_write(context, image, path, &options) || murk_image_read(context, path, &read))
        fail_msg("%s", murk_context_message(context));
    unlink(path);
    rmdir(folder);
    return read;
}

/* An attribute in a file is what it was; what murk says about the file goes before it. */
static void in_files(void **state)
{
    murk_image *image = create(*state);
    assert_int_equal(murk_image_set_attribute(image, "murk:bands", "R:6e-07:7e-07,LWIR:8e-06:1e-5"),
                     MURK_OK);
    assert_int_equal(murk_image_set_attribute(image, "murk:command", "another"), MURK_OK);
    murk_image *once = through_file(*state, image, "a.exr");
    murk_image *twice = through_file(*state, once, "b.exr");
    murk_image *eight_bit = through_file(*state, once, "c.png");
    assert_string_equal(murk_image_attribute(once, "murk:bands"), "R:6e-07:7e-07,LWIR:8e-06:1e-5");
    assert_string_equal(murk_image_attribute(twice, "murk:bands"), "R:6e-07:7e-07,LWIR:8e-06:1e-5");
    assert_string_equal(murk_image_attribute(once, "murk:command"), "murk image a.json");
    assert_null(murk_image_attribute(eight_bit, "murk:bands"));
    murk_image_release(image);
    murk_image_release(once);
    murk_image_release(twice);
    murk_image_release(eight_bit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(in_memory), cmocka_unit_test(in_files)};
    return cmocka_run_group_tests(tests, open_context, close_context);
}
