/* SPDX-License-Identifier: Apache-2.0 */
/* The bands of a scene file. */
#include "parse.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool scene_skip(struct scene_reader *reader, const json_t *value, void *field,
                const struct scene_key *key)
{
    (void)reader;
    (void)value;
    (void)field;
    (void)key;
    return true;
}

static bool read_wavelength(struct scene_reader *reader, const json_t *value, void *field,
                            const struct scene_key *key)
{
    (void)key;
    murk_band *band = field;
    size_t count = json_is_array(value) ? json_array_size(value) : 0;
    for (size_t i = 0; i < 2; i++)
        band->wavelength[i] = json_is_number(value)
                                  ? json_number_value(value)
                                  : json_number_value(json_array_get(value, i < count ? i : 0));
    if ((!json_is_number(value) && (count < 1 || count > 2)) || !murk_band_valid(band))
        return scene_fail(reader, "not a wavelength, or [from, to], in metres: 0.55e-6");
    return true;
}

static bool read_band(struct scene_reader *reader, const json_t *value,
                      struct scene_description *band)
{
    static const struct scene_key KEYS[] = {
        {"name", scene_read_text, FIELD(name)},
        {"wavelength", read_wavelength, FIELD(wavelength)},
        {"extinction", scene_read_extinction, WHOLE, EXTINCTION_RANGE},
        {"mass_extinction", scene_read_mass_extinction, WHOLE, POSITIVE},
        {"albedo", scene_read_quantity, FIELD(medium.albedo), .min = 0.0, .max = 1.0,
         .range = "between 0 and 1"},
        {"asymmetry", scene_read_number, FIELD(medium.asymmetry), ASYMMETRY_RANGE},
        {"emission", scene_read_quantity, FIELD(medium.emission), NOT_NEGATIVE},
        {"sun", scene_read_sun, WHOLE},
        {"sky", scene_read_sky, WHOLE},
        {"ground", scene_read_ground, WHOLE},
    };
    if (json_object_get(value, "extinction") && json_object_get(value, "mass_extinction"))
        return scene_fail(reader, "takes one of \"extinction\" and \"mass_extinction\"");
    /* What the band gives goes in place of what the scene gives, whole. */
    if (json_object_get(value, "albedo")) {
        band->medium.albedo = (murk_quantity){NULL, 1.0, 0.0};
        band->albedo_named = true;
    }
    band->asymmetry_named |= json_object_get(value, "asymmetry") != NULL;
    if (json_object_get(value, "emission"))
        band->medium.emission = (murk_quantity){NULL, 1.0, 0.0};
    const json_t *ground = json_object_get(value, "ground");
    if (json_object_get(ground, "reflectance"))
        band->reflectance_image = NULL;
    if (json_object_get(ground, "emission"))
        band->emission_image = NULL;
    if (json_object_get(ground, "temperature")) {
        band->temperature_image = NULL;
        band->ground_temperature = NAN;
    }
    return scene_read_object(reader, value, KEYS, COUNT(KEYS), band);
}

/* The wavelengths that go without saying. */
static bool complete(struct scene_reader *reader, struct scene_description *band)
{
    if (!band->name)
        return scene_fail(reader, "has no \"name\": {\"name\": \"LWIR\"} is the least");
    if (!murk_band_name_valid(band->name))
        return scene_fail(reader, "\"%s\": a name has letters, digits, _ and -, %d at most",
                          band->name, MURK_BAND_NAME_MAX);
    if (!murk_band_valid(&band->wavelength))
        scene_known_band(band->name, &band->wavelength);
    if (!murk_band_valid(&band->wavelength))
        return scene_fail(
            reader, "needs a \"wavelength\": only R, G, B, NIR, SWIR, MWIR and LWIR are known "
                    "by name");
    band->medium.band = band->wavelength;
    return true;
}

bool scene_read_bands(struct scene_reader *reader, const json_t *root,
                      struct scene_description *description)
{
    const json_t *bands = json_object_get(root, "bands");
    if (!bands || json_is_null(bands))
        return true;
    size_t count = json_array_size(bands);
    snprintf(reader->path, sizeof reader->path, "bands");
    if (!json_is_array(bands) || count < 1 || count > SCENE_BANDS_MAX)
        return scene_fail(reader, "not an array of 1 to %d bands", SCENE_BANDS_MAX);
    description->band = malloc(count * sizeof *description->band);
    if (!description->band)
        return scene_fail(reader, "out of memory");
    struct scene_description base = *description;
    for (size_t n = 0; n < count; n++) {
        struct scene_description *band = &description->band[n];
        *band = base;
        band->root = NULL; /* lives with the scene, as the other texts do */
        band->band = NULL;
        snprintf(reader->path, sizeof reader->path, "bands[%zu]", n);
        if (!read_band(reader, json_array_get(bands, n), band) || !complete(reader, band))
            return false;
        for (size_t m = 0; m < n; m++)
            if (!strcmp(description->band[m].name, band->name))
                return scene_fail(reader, "%s is the name of another band, too", band->name);
    }
    *reader->path = '\0';
    description->band_count = count;
    return true;
}
