// SPDX-License-Identifier: Apache-2.0
// Reading flat images through OpenImageIO. Unlike VDBs in this process: its threads and those of
// OpenEXR do not survive a fork, and what makes OpenImageIO 2.4 crash or take gigabytes shows in
// the header.
#include "context.h"
#include "image.h"
#include "memory.h"
#include "oiio.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <sys/stat.h>
#include <vector>

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

// Headers claim what they like: nothing is allocated for more than such a file can hold. Of stored
// pixels deflate makes a thousandth; a display window around them takes no bytes at all.
constexpr uint64_t stored_per_byte = 4096, stored_free = uint64_t(64) << 20;
constexpr uint64_t shown_free = uint64_t(1) << 30;

// UINT64_MAX where that is too many.
uint64_t float_bytes(int64_t width, int64_t height, int64_t depth, int channels)
{
    uint64_t bytes = sizeof(float);
    for (int64_t factor : {width, height, depth, int64_t(channels)})
        if (factor < 1 || __builtin_mul_overflow(bytes, uint64_t(factor), &bytes))
            return UINT64_MAX;
    return bytes;
}

murk_status check_size(murk_context *context, const char *path, const OIIO::ImageSpec &spec)
{
    struct stat info = {};
    if (spec.deep)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: is a deep image; flatten it first, as with oiiotool --flatten", path);
    if (stat(path, &info))
        return murk_fail(context, MURK_ERROR_INPUT, "%s: cannot read: %s", path,
                         std::strerror(errno));
    const uint64_t sound = stored_per_byte * uint64_t(info.st_size);
    const uint64_t stored = float_bytes(spec.width, spec.height, spec.depth, spec.nchannels);
    const uint64_t shown = float_bytes(spec.full_width, spec.full_height, 1, spec.nchannels);
    if (stored > stored_free + sound || shown > shown_free + sound)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: claims %d x %d pixels of %d channels in %lld bytes; the file is "
                         "damaged: write or copy it again",
                         path, std::max(spec.width, spec.full_width),
                         std::max(spec.height, spec.full_height), spec.nchannels,
                         static_cast<long long>(info.st_size));
    // The image and OpenImageIO's pixels.
    const std::string what = std::string(path) + ": reading";
    return murk_memory_check(context, what.c_str(), stored + shown);
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
    murk_status status = check_size(context, path, spec);
    if (status != MURK_OK)
        return status;
    murk_image *image = nullptr;
    status = murk_image_create(context, spec.full_width, spec.full_height, spec.nchannels,
                               names.data(), &image);
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
