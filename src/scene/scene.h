/* SPDX-License-Identifier: Apache-2.0 */
/* The scene file: from JSON to a description, from a description to murk's objects. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "murk/bands.h"

struct json_t;

enum { SCENE_MESSAGE_SIZE = 1024, SCENE_BANDS_MAX = 16 };

/*
 * What a scene names, before anything is read: a caller may change it between scene_parse() and
 * scene_build(). Numbers that the scene leaves open are NaN, image sizes 0, texts NULL. Texts live
 * as long as the description.
 */
struct scene_description {
    const char *path;    /* of the scene file, for messages; NULL: a bare volume */
    char *folder;        /* that relative paths start from: "" or ending in '/' */
    struct json_t *root; /* owns the texts */
    const char *medium_file;
    murk_medium_options medium;
    murk_quantity concentration; /* of the obscurant [g/m^3] */
    bool has_concentration;
    double mass_extinction; /* [m^2/g]; open: kappa_t is medium.extinction */
    const char *obscurant;  /* a file of such values, of albedo and asymmetry, or NULL */
    bool albedo_named, asymmetry_named; /* go before those of the obscurant */
    bool sun_named, sky_named, ground_named;
    murk_sun sun;
    double sky_radiance;
    double sun_temperature, sky_temperature; /* [K] */
    murk_ground_options ground;              /* patches 0 and extent_min == extent_max are open */
    double ground_temperature;               /* [K] */
    const char *reflectance_image, *emission_image, *temperature_image;
    murk_up up;
    murk_camera camera;
    const char *background; /* an image path, or "none" */
    /* A scene with bands: each is described in full, by a copy with what it says itself. */
    struct scene_description *band;
    size_t band_count;
    const char *name;     /* of a band; NULL: a scene without bands */
    murk_band wavelength; /* likewise */
};

/* The murk objects of one band of a scene. */
struct scene_band {
    const char *name; /* NULL: of a scene without bands; lives as long as the description */
    murk_band band;
    double mass_extinction; /* [m^2/g], or 0 */
    murk_medium *medium;
    murk_ground *ground; /* NULL: none */
    murk_scene scene;
};

/* Those of a scene; without bands it has one, without a name. */
struct scene {
    murk_volume *volume;
    struct scene_band band[SCENE_BANDS_MAX];
    size_t band_count;
    murk_camera camera;
    murk_image *background; /* NULL: none */
    bool no_background;
};

/* A description of the volume alone. */
void scene_describe_volume(const char *medium_file, struct scene_description *out);

/*
 * Reads a scene file. On failure message holds one line that names the file, the key's path, what
 * is wrong and what would be right; there is nothing to release then.
 */
murk_status scene_parse(const char *path, struct scene_description *out,
                        char message[SCENE_MESSAGE_SIZE]);
void scene_description_release(struct scene_description *description);

/* Most files that one description names: the medium, the background, and images and obscurants of
   the scene and each band. */
enum { SCENE_FILE_MAX = 2 + 4 * (1 + SCENE_BANDS_MAX) };

/* Leaves the bands of a list "R,LWIR" alone, in its order. Where there are none, makes them, of the
   names that say where they are. With one line in message where a band is unknown. */
murk_status scene_choose_bands(struct scene_description *description, const char *list,
                               char message[SCENE_MESSAGE_SIZE]);

/* The descriptions of the bands, or of the scene that has none; gives their number. */
size_t scene_bands(struct scene_description *description, struct scene_description **bands);

/* The texts of a description that name files, the medium's first; gives their number. */
size_t scene_files(struct scene_description *description, const char **files[SCENE_FILE_MAX]);

/* file relative to the folder of the scene, from malloc; "-" and absolute paths stay. */
char *scene_path(const struct scene_description *description, const char *file);

/* Reads the volume of a description into scene->volume. */
murk_status scene_read_volume(murk_context *context, const struct scene_description *description,
                              struct scene *scene, char message[SCENE_MESSAGE_SIZE]);

/*
 * Builds everything else from scene->volume. What a description does not name is absent, except
 * that one without any light gets the sun, the sky and (unless it names one) the ground of
 * murk_scene_default(). On failure *scene is still to be released.
 */
murk_status scene_build(murk_context *context, struct scene_description *description,
                        struct scene *scene, char message[SCENE_MESSAGE_SIZE]);

/* Frees what a zero-initialised scene holds. */
void scene_release(struct scene *scene);

#endif
