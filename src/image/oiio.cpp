// SPDX-License-Identifier: Apache-2.0
// Flat images and text through OpenImageIO, which no other folder sees.
#include "oiio.hpp"
#include "context.h"
#include "image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

using murk::describe;
using murk::guard;
using murk::one_line;

namespace
{

// Whole numbers are on a display's curve, whether the file says so or not. They come unassociated,
// so that the curve acts on the colour itself.
void make_linear(const OIIO::ImageSpec &spec, murk_image &image)
{
    if (spec.format.is_floating_point() ||
        spec.get_string_attribute("oiio:ColorSpace", "sRGB") == "Linear")
        return;
    size_t count = size_t(image.width) * image.height;
    for (size_t p = 0; p < count; p++) {
        float *pixel = image.pixels + p * image.channels;
        float alpha = spec.alpha_channel >= 0 ? pixel[spec.alpha_channel] : 1.0f;
        for (int c = 0; c < image.channels; c++)
            if (c != spec.alpha_channel)
                pixel[c] = alpha * float(murk_display_linear(pixel[c]));
    }
}

// Names with "oiio:" tell how OpenImageIO read the file and are none of its attributes.
murk_status take_attributes(murk_context *context, const char *path, const OIIO::ImageSpec &spec,
                            murk_image &image)
{
    for (const OIIO::ParamValue &attribute : spec.extra_attribs) {
        std::string name = attribute.name().string();
        if (attribute.type() != OIIO::TypeString || name.empty() ||
            name.compare(0, 5, "oiio:") == 0)
            continue;
        if (murk_image_set_attribute(&image, name.c_str(), attribute.get_string().c_str()))
            return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    }
    return MURK_OK;
}

murk_status read_image(murk_context *context, const char *path, murk_image **out)
{
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf file(path, 0, 0, nullptr, &config);
    if (!file.init_spec(path, 0, 0))
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: not an image that OpenImageIO reads, such as EXR, PNG or TIFF", path);
    const OIIO::ImageSpec &spec = file.spec();
    std::vector<const char *> names;
    for (const std::string &name : spec.channelnames)
        names.push_back(name.c_str());
    murk_image *image = nullptr;
    murk_status status = murk_image_create(context, spec.full_width, spec.full_height,
                                           spec.nchannels, names.data(), &image);
    if (status != MURK_OK)
        return status;
    OIIO::ROI window = file.roi_full();
    window.chbegin = 0;
    window.chend = spec.nchannels;
    if (!file.read(0, 0, true, OIIO::TypeFloat) ||
        !file.get_pixels(window, OIIO::TypeFloat, image->pixels)) {
        murk_image_release(image);
        return murk_fail(context, MURK_ERROR_INPUT, "%s: damaged image: %s", path,
                         one_line(file.geterror()).c_str());
    }
    make_linear(file.nativespec(), *image);
    status = take_attributes(context, path, file.nativespec(), *image);
    if (status != MURK_OK)
        murk_image_release(image);
    else
        *out = image;
    return status;
}

murk_status read_command(murk_context *context, const char *path, char *text, size_t size)
{
    std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::open(path);
    if (!file)
        return murk_fail(context, MURK_ERROR_INPUT, "%s: %s", path,
                         one_line(OIIO::geterror()).c_str());
    std::string command = file->spec().get_string_attribute("murk:command");
    std::snprintf(text, size, "%s", command.size() < size ? command.c_str() : "");
    return MURK_OK;
}

OIIO::ImageSpec output_spec(const murk_oiio_pixels &pixels)
{
    OIIO::ImageSpec spec(pixels.width, pixels.height, pixels.channels,
                         pixels.floats ? OIIO::TypeFloat : OIIO::TypeUInt8);
    spec.channelnames.assign(pixels.names, pixels.names + pixels.channels);
    spec.alpha_channel = spec.z_channel = -1;
    for (int c = 0; c < pixels.channels; c++) {
        if (spec.channelnames[c] == "A")
            spec.alpha_channel = c;
        if (spec.channelnames[c] == "Z")
            spec.z_channel = c;
    }
    for (const murk_attribute *a = pixels.attributes; a; a = a->next)
        spec.attribute(a->name, a->text);
    spec.attribute("oiio:ColorSpace", pixels.floats ? "Linear" : pixels.data ? "data" : "sRGB");
    if (pixels.data)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    if (pixels.floats) // Level 4, the usual one, takes a third longer for a tenth fewer bytes.
        spec.attribute("compression", "zip:2");
    describe(spec, pixels.command, pixels.units);
    return spec;
}

// Encoded in memory: OpenImageIO does not notice every failure to write.
murk_status encode_image(murk_context *context, const char *path, const murk_oiio_pixels &pixels,
                         void **bytes, size_t *size)
{
    OIIO::Filesystem::IOVecOutput memory;
    std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path);
    if (!file || !file->set_ioproxy(&memory))
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: OpenImageIO cannot write this format",
                         path);
    file->threads(context->threads);
    OIIO::ImageSpec spec = output_spec(pixels);
    if (pixels.command && !std::strcmp(file->format_name(), "tiff")) // It has no names of ours.
        spec.attribute("ImageDescription",
                       pixels.command + (pixels.units ? std::string("; ") + pixels.units : ""));
    bool encoded = file->open(path, spec) &&
                   (pixels.floats ? file->write_image(OIIO::TypeFloat, pixels.floats)
                                  : file->write_image(OIIO::TypeUInt8, pixels.bytes)) &&
                   file->close();
    if (!encoded)
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: %s", path,
                         one_line(file->geterror()).c_str());
    *bytes = std::malloc(memory.buffer().size());
    if (!*bytes)
        throw std::bad_alloc();
    *size = memory.buffer().size();
    std::memcpy(*bytes, memory.buffer().data(), *size);
    return MURK_OK;
}

bool text_box(const char *font, const char *text, int size, murk_oiio_box &out)
{
    OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, size, font);
    if (!box.defined())
        return false;
    out = {box.width(), box.height(), box.ybegin};
    return true;
}

murk_status text_cover(murk_context *context, const char *font, const char *text, int size,
                       const murk_oiio_box &box, float **out)
{
    size_t count = size_t(box.width) * size_t(box.height);
    float *part = static_cast<float *>(std::calloc(count ? count : 1, sizeof *part));
    if (!part)
        throw std::bad_alloc();
    OIIO::ImageSpec spec(box.width, box.height, 1, OIIO::TypeFloat);
    OIIO::ImageBuf pixels(spec, part);
    int left = OIIO::ImageBufAlgo::text_size(text, size, font).xbegin;
    if (!OIIO::ImageBufAlgo::render_text(pixels, -left, -box.top, text, size, font, 1.0f)) {
        std::free(part);
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: %s", font,
                         one_line(pixels.geterror()).c_str());
    }
    *out = part;
    return MURK_OK;
}

} // namespace

murk_status murk_oiio_read(murk_context *context, const char *path, murk_image **out) noexcept
{
    return guard(context, path, [&] { return read_image(context, path, out); });
}

murk_status murk_oiio_command(murk_context *context, const char *path, char *text,
                              size_t size) noexcept
{
    return guard(context, path, [&] { return read_command(context, path, text, size); });
}

murk_status murk_oiio_encode(murk_context *context, const char *path,
                             const murk_oiio_pixels *pixels, void **bytes, size_t *size) noexcept
{
    return guard(context, path, [&] { return encode_image(context, path, *pixels, bytes, size); });
}

bool murk_oiio_text_box(const char *font, const char *text, int size, murk_oiio_box *out) noexcept
{
    try {
        return text_box(font, text, size, *out);
    } catch (...) {
        return false;
    }
}

murk_status murk_oiio_text_cover(murk_context *context, const char *font, const char *text,
                                 int size, const murk_oiio_box *box, float **out) noexcept
{
    return guard(context, font, [&] { return text_cover(context, font, text, size, *box, out); });
}
