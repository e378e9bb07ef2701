// SPDX-License-Identifier: Apache-2.0
// Writing flat images, and text, through OpenImageIO, which no other folder sees.
#include "oiio.hpp"
#include "context.h"
#include "image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

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
