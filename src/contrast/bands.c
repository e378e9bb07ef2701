/* SPDX-License-Identifier: Apache-2.0 */
/* The list of bands that a picture carries. */
#include "murk/contrast.h"

#include "context.h"

#include <stdlib.h>
#include <string.h>

/* A wavelength behind a colon at *text, which is moved behind it. */
static bool wavelength_at(const char **text, double *out)
{
    char *end;
    if (**text != ':')
        return false;
    *out = strtod(*text + 1, &end);
    if (end == *text + 1)
        return false;
    *text = end;
    return true;
}

/* "NAME:LOW:HIGH" at *text, which is moved behind it. */
static bool band_at(const char **text, murk_picture_band *out)
{
    static const char letters[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    size_t length = strspn(*text, letters);
    *out = (murk_picture_band){0};
    if (length == 0 || length >= sizeof out->name)
        return false;
    memcpy(out->name, *text, length);
    *text += length;
    double *wavelength = out->band.wavelength;
    return wavelength_at(text, &wavelength[0]) && wavelength_at(text, &wavelength[1]) &&
           (murk_band_valid(&out->band) || (wavelength[0] == 0 && wavelength[1] == 0));
}

murk_status murk_picture_bands(murk_context *context, const murk_image *picture, size_t capacity,
                               murk_picture_band *bands, size_t *count)
{
    const char *list = murk_image_attribute(picture, "murk:bands"), *text = list;
    size_t found = 0;
    if (!list)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "the picture has no bands; render a scene with \"bands\" to an .exr file");
    for (const char *end = ","; *end == ','; text = end + 1) {
        murk_picture_band band;
        end = text;
        if (!band_at(&end, &band) || (*end && *end != ','))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "the picture's attribute murk:bands is \"%s\", not a list such as "
                             "R:6e-07:7e-07,LWIR:8e-06:1.2e-05; render it again",
                             list);
        if (found < capacity)
            bands[found] = band;
        found++;
    }
    *count = found;
    return MURK_OK;
}
