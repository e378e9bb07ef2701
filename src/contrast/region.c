/* SPDX-License-Identifier: Apache-2.0 */
#include "region.h"

#include "context.h"

murk_status murk_region_check(murk_context *context, const murk_region *region,
                              const murk_image *picture, const char *name)
{
    int width = murk_image_width(picture), height = murk_image_height(picture);
    const murk_image *mask = region->mask;
    if (mask && (murk_image_width(mask) != width || murk_image_height(mask) != height))
        return murk_fail(
            context, MURK_ERROR_INPUT,
            "the mask of the %s has %d x %d pixels; it takes the %d x %d of the picture", name,
            murk_image_width(mask), murk_image_height(mask), width, height);
    if (mask)
        return MURK_OK;
    if (region->width < 1 || region->height < 1)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the %s is %d x %d pixels; it takes at least one", name, region->width,
                         region->height);
    if (region->x < 0 || region->y < 0 || region->width > width - region->x ||
        region->height > height - region->y)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the %s, %d x %d pixels from %d,%d, reaches outside of the picture's "
                         "%d x %d pixels",
                         name, region->width, region->height, region->x, region->y, width, height);
    return MURK_OK;
}

bool murk_region_holds(const murk_region *region, int x, int y)
{
    const murk_image *mask = region->mask;
    if (!mask)
        return x >= region->x && x - region->x < region->width && y >= region->y &&
               y - region->y < region->height;
    size_t pixel = (size_t)y * (size_t)murk_image_width(mask) + (size_t)x;
    return murk_image_pixels_const(mask)[pixel * (size_t)murk_image_channels(mask)] > 0.5f;
}
