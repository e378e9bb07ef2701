/* SPDX-License-Identifier: Apache-2.0 */
/* A picture of several bands, put together from those of each. */
#include "murk/bands.h"

#include "context.h"
#include "image.h"

#include <stdio.h>
#include <string.h>

/* What a band's layer may hold, and which channel of its own picture that is; those marked # are
   three, of which it takes one. */
static const struct {
    const char *name, *from;
} LAYER[] = {
    {"radiance", "#"},
    {"transmittance", "transmittance.Y"},
    {"scattered", "scattered.Y"},
    {"emitted", "emitted.Y"},
    {"surface", "surface.#"},
    {"inherent", "inherent.#"},
};
/* And the picture's own channels. */
static const char *const COLOR[] = {
    "R",         "G",         "B",         "path.R", "path.G",          "path.B",
    "surface.R", "surface.G", "surface.B", "A",      "transmittance.Y", "Z"};

enum {
    LAYERS = sizeof LAYER / sizeof *LAYER,
    COLORS = sizeof COLOR / sizeof *COLOR,
    FIRST_PLAIN = 9, /* of the colour channels: shared by all three colours */
    NAME_SIZE = 80
};

typedef struct channels {
    char (*name)[NAME_SIZE];
    int count;
} channels;

static void add_channel(channels *to, const char *band, const char *name)
{
    snprintf(to->name[to->count++], NAME_SIZE, "%s%s%s", band, *band ? "." : "", name);
}

static bool has_temperature(const murk_band_view *view)
{
    return murk_band_valid(&view->band);
}

static const murk_band_view *massive(const murk_band_view *views, size_t count)
{
    for (size_t n = 0; n < count; n++)
        if (views[n].mass_extinction > 0)
            return &views[n];
    return NULL;
}

static murk_status check_names(murk_context *context, const murk_band_view *views, size_t count)
{
    for (size_t n = 0; n < count; n++) {
        if (!views[n].name || !murk_band_name_valid(views[n].name))
            return murk_fail(context, MURK_ERROR_INPUT,
                             "band \"%s\": a name has letters, digits, _ and -, %d at most",
                             views[n].name ? views[n].name : "", MURK_BAND_NAME_MAX);
        for (size_t m = 0; m < n; m++)
            if (!strcmp(views[m].name, views[n].name))
                return murk_fail(context, MURK_ERROR_INPUT, "band %s: there are two of that name",
                                 views[n].name);
    }
    return MURK_OK;
}

static murk_status create(murk_context *context, const murk_band_view *views, size_t count,
                          const int size[2], murk_image **out)
{
    const size_t most = COLORS + 1 + count * (LAYERS + 1);
    channels made = {.name = murk_alloc(most, NAME_SIZE)};
    const char **names = murk_alloc(most, sizeof *names);
    murk_status status = MURK_ERROR_MEMORY;
    if (made.name && names) {
        for (int i = 0; i < COLORS; i++)
            add_channel(&made, "", COLOR[i]);
        for (size_t n = 0; n < count; n++) {
            for (int i = 0; i < LAYERS; i++)
                add_channel(&made, views[n].name, LAYER[i].name);
            if (has_temperature(&views[n]))
                add_channel(&made, views[n].name, "temperature");
        }
        if (massive(views, count))
            add_channel(&made, "CL", "Y");
        for (int i = 0; i < made.count; i++)
            names[i] = made.name[i];
        status = murk_image_create(context, size[0], size[1], made.count, names, out);
    } else {
        murk_fail(context, status, "out of memory for a picture");
    }
    murk_free(names);
    murk_free(made.name);
    return status;
}

/* Which of R, G, B a band is: 0 for one that is none of them. */
static int color_of(const char *name)
{
    return !strcmp(name, "G") ? 1 : !strcmp(name, "B") ? 2 : 0;
}

/* Adds scale times a channel of one picture to that of another. */
static void add(const murk_image *from, const char *source, double scale, murk_image *to,
                const char *target)
{
    const int i = murk_image_channel(from, source), o = murk_image_channel(to, target);
    const size_t pixels = (size_t)to->width * (size_t)to->height;
    for (size_t p = 0; p < pixels; p++) {
        float more = from->pixels[p * (size_t)from->channels + (size_t)i];
        to->pixels[p * (size_t)to->channels + (size_t)o] += (float)scale * more;
    }
}

/* One of R, G, B in the place of the #. */
static const char *colored(const char *text, int color, char name[NAME_SIZE])
{
    snprintf(name, NAME_SIZE, "%s", text);
    char *mark = strchr(name, '#');
    if (mark)
        *mark = "RGB"[color];
    return name;
}

static void take_temperature(murk_context *context, const murk_band_view *view, murk_image *image)
{
    char name[NAME_SIZE];
    snprintf(name, sizeof name, "%s.radiance", view->name);
    const int from = murk_image_channel(image, name);
    snprintf(name, sizeof name, "%s.temperature", view->name);
    const int to = murk_image_channel(image, name);
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (int j = 0; j < image->height; j++)
        for (int i = 0; i < image->width; i++) {
            float *pixel = image->pixels +
                           ((size_t)j * (size_t)image->width + (size_t)i) * (size_t)image->channels;
            pixel[to] = (float)murk_planck_temperature(&view->band, pixel[from]);
        }
}

static void take_layer(const murk_image *from, const murk_band_view *view, murk_image *image)
{
    const int color = color_of(view->name);
    for (int i = 0; i < LAYERS; i++) {
        char source[NAME_SIZE], target[NAME_SIZE];
        snprintf(target, sizeof target, "%s.%s", view->name, LAYER[i].name);
        add(from, colored(LAYER[i].from, color, source), 1, image, target);
    }
}

/* The colours that a band stands for in the picture: its own, or all of them. */
static void take_colors(const murk_image *from, bool rgb, int color, murk_image *image)
{
    for (int i = 0; i < FIRST_PLAIN; i++)
        if (!rgb || i % 3 == color)
            add(from, COLOR[i], 1, image, COLOR[i]);
    for (int i = FIRST_PLAIN; i < COLORS; i++)
        if (strcmp(COLOR[i], "Z"))
            add(from, COLOR[i], rgb ? 1 / 3. : 1, image, COLOR[i]);
        else if (color == 0)
            add(from, COLOR[i], 1, image, COLOR[i]);
}

static bool has_band(const murk_band_view *views, size_t count, const char *name)
{
    for (size_t n = 0; n < count; n++)
        if (!strcmp(views[n].name, name))
            return true;
    return false;
}

/* "R:6e-07:7e-07,LWIR:8e-06:1.2e-05" */
static murk_status name_bands(murk_context *context, const murk_band_view *views, size_t count,
                              murk_image *image)
{
    size_t size = count * (NAME_SIZE + 64), used = 0;
    char *text = murk_alloc(size, 1);
    if (!text)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for a picture");
    for (size_t n = 0; n < count; n++)
        used += (size_t)snprintf(text + used, size - used, "%s%s:%.9g:%.9g", n ? "," : "",
                                 views[n].name, views[n].band.wavelength[0],
                                 views[n].band.wavelength[1]);
    murk_status status = murk_image_set_attribute(image, "murk:bands", text);
    murk_free(text);
    return status ? murk_fail(context, status, "out of memory for a picture") : MURK_OK;
}

murk_status murk_render_bands(murk_context *context, const murk_band_view *views, size_t count,
                              const murk_camera *camera, const murk_render_options *options,
                              murk_image **out)
{
    const murk_render_options defaults = MURK_RENDER_DEFAULT;
    murk_render_options all = options ? *options : defaults;
    all.parts = true;
    murk_image *image = NULL;
    murk_status status = check_names(context, views, count);
    if (!status)
        status = murk_camera_check(context, views[0].scene, camera);
    if (!status)
        status = create(context, views, count, camera->size, &image);
    if (!status)
        status = name_bands(context, views, count, image);
    const murk_band_view *mass = massive(views, count);
    bool rgb =
        has_band(views, count, "R") && has_band(views, count, "G") && has_band(views, count, "B");
    for (size_t n = 0; !status && n < count; n++) {
        murk_image *one = NULL;
        const murk_band_view *view = &views[n];
        status = murk_render(context, view->scene, view->solution, camera, &all, &one);
        if (status)
            break;
        const int color = color_of(view->name);
        bool shown = rgb ? !strcmp(view->name, "R") || color > 0 : n == 0;
        take_layer(one, view, image);
        if (has_temperature(view))
            take_temperature(context, view, image);
        if (shown)
            take_colors(one, rgb, rgb ? color : 0, image);
        if (view == mass)
            add(one, "depth.Y", 1 / view->mass_extinction, image, "CL.Y");
        murk_image_release(one);
    }
    if (status)
        murk_image_release(image);
    else
        *out = image;
    return status;
}
