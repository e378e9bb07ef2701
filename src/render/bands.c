/* SPDX-License-Identifier: Apache-2.0 */
/* A picture of several bands, put together from those of each. */
#include "band_colors.h"

#include "apparent.h"
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

murk_status murk_bands_picture(murk_context *context, const murk_band_view *views, size_t count,
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

/* Channels of one picture to be added to those of another. */
typedef struct moves {
    const murk_image *from;
    murk_image *to;
    int count;
    struct {
        int from, to;
        float scale;
    } move[LAYERS + COLORS + 1];
} moves;

static void add(moves *list, const char *source, double scale, const char *target)
{
    list->move[list->count].from = murk_image_channel(list->from, source);
    list->move[list->count].to = murk_image_channel(list->to, target);
    list->move[list->count++].scale = (float)scale;
}

/* Pixel by pixel, since many channels lie together. */
static void carry_out(const murk_context *context, const moves *list)
{
    const size_t pixels = (size_t)list->to->width * (size_t)list->to->height;
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t p = 0; p < pixels; p++) {
        const float *from = list->from->pixels + p * (size_t)list->from->channels;
        float *to = list->to->pixels + p * (size_t)list->to->channels;
        for (int n = 0; n < list->count; n++)
            to[list->move[n].to] += list->move[n].scale * from[list->move[n].from];
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
    const int to = murk_image_channel(image, name), stride = image->channels;
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    double low = INFINITY, high = 0;
    murk_apparent apparent;
    for (size_t p = 0; p < pixels; p++) {
        double radiance = image->pixels[p * (size_t)stride + (size_t)from];
        low = radiance > 0 ? fmin(low, radiance) : low;
        high = isfinite(radiance) ? fmax(high, radiance) : high;
    }
    if (!(high > 0))
        return;
    murk_apparent_init(&view->band, low, high, &apparent);
#pragma omp parallel for num_threads(context->threads) schedule(static)
    for (size_t p = 0; p < pixels; p++) {
        float *pixel = image->pixels + p * (size_t)stride;
        pixel[to] = (float)murk_apparent_temperature(&apparent, pixel[from]);
    }
}

static void take_layer(const murk_band_view *view, moves *list)
{
    const int color = color_of(view->name);
    for (int i = 0; i < LAYERS; i++) {
        char source[NAME_SIZE], target[NAME_SIZE];
        snprintf(target, sizeof target, "%s.%s", view->name, LAYER[i].name);
        add(list, colored(LAYER[i].from, color, source), 1, target);
    }
}

/* The colours that a band stands for in the picture: its own, or all of them. */
static void take_colors(bool rgb, int color, moves *list)
{
    for (int i = 0; i < FIRST_PLAIN; i++)
        if (!rgb || i % 3 == color)
            add(list, COLOR[i], 1, COLOR[i]);
    for (int i = FIRST_PLAIN; i < COLORS; i++)
        if (strcmp(COLOR[i], "Z"))
            add(list, COLOR[i], rgb ? 1 / 3. : 1, COLOR[i]);
        else if (color == 0)
            add(list, COLOR[i], 1, COLOR[i]);
}

static const murk_band_view *find_band(const murk_band_view *views, size_t count, const char *name)
{
    for (size_t n = 0; n < count; n++)
        if (views[n].name && !strcmp(views[n].name, name))
            return &views[n];
    return NULL;
}

bool murk_band_colors(const murk_band_view *views, size_t count, const murk_band_view *color[3])
{
    static const char *const NAMES[3] = {"R", "G", "B"};
    bool all = true;
    for (int c = 0; c < 3; c++)
        all &= (color[c] = find_band(views, count, NAMES[c])) != NULL;
    for (int c = 0; c < 3 && !all; c++)
        color[c] = &views[0];
    return all;
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
        status = murk_bands_picture(context, views, count, camera->size, &image);
    if (!status)
        status = name_bands(context, views, count, image);
    const murk_band_view *mass = massive(views, count);
    const murk_band_view *shown[3];
    bool rgb = murk_band_colors(views, count, shown);
    for (size_t n = 0; !status && n < count; n++) {
        murk_image *one = NULL;
        const murk_band_view *view = &views[n];
        status = murk_render(context, view->scene, view->solution, camera, &all, &one);
        if (status)
            break;
        const int color = color_of(view->name);
        moves list = {.from = one, .to = image};
        take_layer(view, &list);
        if (view == shown[rgb ? color : 0])
            take_colors(rgb, rgb ? color : 0, &list);
        if (view == mass)
            add(&list, "depth.Y", 1 / view->mass_extinction, "CL.Y");
        carry_out(context, &list);
        if (has_temperature(view))
            take_temperature(context, view, image);
        murk_image_release(one);
    }
    if (status)
        murk_image_release(image);
    else
        *out = image;
    return status;
}
