/* SPDX-License-Identifier: Apache-2.0 */
/* Bands by their names. */
#include "nearest.h"
#include "parse.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bands whose names say where they are [m]. */
static const struct {
    const char *name;
    murk_band band;
} KNOWN[] = {
    {"R", {{0.6e-6, 0.7e-6}}},    {"G", {{0.5e-6, 0.6e-6}}},  {"B", {{0.4e-6, 0.5e-6}}},
    {"NIR", {{0.75e-6, 1.4e-6}}}, {"SWIR", {{1.4e-6, 3e-6}}}, {"MWIR", {{3e-6, 5e-6}}},
    {"LWIR", {{8e-6, 12e-6}}},
};

bool scene_known_band(const char *name, murk_band *out)
{
    for (size_t i = 0; i < COUNT(KNOWN); i++)
        if (!strcmp(name, KNOWN[i].name)) {
            *out = KNOWN[i].band;
            return true;
        }
    return false;
}

static murk_status unknown(const struct scene_description *description, const char *name,
                           char *message)
{
    struct murk_nearest nearest = {0};
    for (size_t n = 0; n < description->band_count; n++)
        murk_nearest_offer(&nearest, name, description->band[n].name);
    for (size_t i = 0; !description->band_count && i < COUNT(KNOWN); i++)
        murk_nearest_offer(&nearest, name, KNOWN[i].name);
    snprintf(message, SCENE_MESSAGE_SIZE, "--bands: no band %s; the nearest known one is %s", name,
             nearest.word ? nearest.word : "none");
    return MURK_ERROR_INPUT;
}

/* The band of a name, from those of the scene or of the known ones. */
static bool find(const struct scene_description *description, const char *name,
                 struct scene_description *out)
{
    for (size_t n = 0; n < description->band_count; n++)
        if (!strcmp(description->band[n].name, name)) {
            *out = description->band[n];
            return true;
        }
    murk_band band;
    if (description->band_count || !scene_known_band(name, &band))
        return false;
    *out = *description;
    out->root = NULL;
    for (size_t i = 0; i < COUNT(KNOWN); i++)
        if (!strcmp(KNOWN[i].name, name))
            out->name = KNOWN[i].name;
    out->wavelength = out->medium.band = band;
    return true;
}

murk_status scene_choose_bands(struct scene_description *description, const char *list,
                               char message[SCENE_MESSAGE_SIZE])
{
    struct scene_description *chosen = malloc(SCENE_BANDS_MAX * sizeof *chosen);
    char *names = strdup(list), *rest = NULL;
    murk_status status = chosen && names ? MURK_OK : MURK_ERROR_MEMORY;
    size_t count = 0;
    if (status != MURK_OK)
        snprintf(message, SCENE_MESSAGE_SIZE, "out of memory");
    for (char *name = names ? strtok_r(names, ",", &rest) : NULL; name && status == MURK_OK;
         name = strtok_r(NULL, ",", &rest)) {
        if (count == SCENE_BANDS_MAX || !find(description, name, &chosen[count]))
            status = unknown(description, name, message);
        else
            count++;
    }
    if (status == MURK_OK && !count) {
        snprintf(message, SCENE_MESSAGE_SIZE, "--bands \"%s\": names no band", list);
        status = MURK_ERROR_INPUT;
    }
    free(names);
    if (status != MURK_OK) {
        free(chosen);
        return status;
    }
    free(description->band);
    description->band = chosen;
    description->band_count = count;
    return MURK_OK;
}
