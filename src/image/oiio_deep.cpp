// SPDX-License-Identifier: Apache-2.0
// Deep pictures through OpenImageIO.
#include "deep.h"
#include "oiio.hpp"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

using murk::describe;
using murk::guard;
using murk::one_line;

namespace
{

// The channels of a sample, in the order of its fields.
OIIO::ImageSpec deep_spec(const murk_deep &deep, const murk_image_write_options &options)
{
    OIIO::ImageSpec spec(deep.width, deep.height, 6, OIIO::TypeFloat);
    spec.deep = true;
    spec.channelnames = {"R", "G", "B", "A", "Z", "ZBack"};
    spec.alpha_channel = 3;
    spec.z_channel = 4;
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zips");
    describe(spec, options.command, options.units);
    return spec;
}

// A file without a name, since deep pictures do not go through an IOProxy in OpenImageIO 2.4.
class MemoryFile
{
  public:
    MemoryFile() : file(memfd_create("murk", MFD_CLOEXEC))
    {
    }
    MemoryFile(const MemoryFile &) = delete;
    MemoryFile &operator=(const MemoryFile &) = delete;
    ~MemoryFile()
    {
        if (file >= 0)
            close(file);
    }
    std::string path() const
    {
        return "/proc/self/fd/" + std::to_string(file);
    }

    // What was written, from malloc.
    bool take(void **bytes, size_t *size) const
    {
        const off_t end = lseek(file, 0, SEEK_END);
        char *copy = end > 0 ? static_cast<char *>(std::malloc(size_t(end))) : nullptr;
        off_t done = 0;
        while (copy && done < end) {
            ssize_t got = pread(file, copy + done, size_t(end - done), done);
            if (got <= 0 && errno != EINTR)
                break;
            done += std::max(got, ssize_t(0));
        }
        if (!copy || done < end) {
            std::free(copy);
            return false;
        }
        *bytes = copy;
        *size = size_t(end);
        return true;
    }

  private:
    int file;
};

// Some rows at a time, so that the samples are not all there twice.
bool write_rows(OIIO::ImageOutput &file, const OIIO::ImageSpec &spec, const murk_deep &deep,
                int begin, int end)
{
    OIIO::DeepData rows;
    rows.init(int64_t(spec.width) * (end - begin), spec.nchannels, OIIO::TypeFloat,
              spec.channelnames);
    const size_t first = size_t(begin) * spec.width;
    rows.set_all_samples({deep.count + first, deep.count + size_t(end) * spec.width});
    for (int j = begin; j < end; j++)
        for (int i = 0; i < spec.width; i++) {
            const murk_deep_sample *sample = nullptr;
            const size_t count = murk_deep_samples(&deep, i, j, &sample);
            const int64_t pixel = int64_t(j - begin) * spec.width + i;
            if (count > 0) // Floats without gaps, as in the file.
                std::memcpy(rows.data_ptr(pixel, 0, 0), sample, count * sizeof *sample);
        }
    return file.write_deep_scanlines(begin, end, 0, rows);
}

murk_status encode_deep(murk_context *context, const char *path, const murk_deep &deep,
                        const murk_image_write_options &options, void **bytes, size_t *size)
{
    static_assert(sizeof(murk_deep_sample) == 6 * sizeof(float), "samples without gaps");
    const int ROWS = 64;
    MemoryFile memory;
    std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create("openexr");
    if (!file || !file->supports("deepdata"))
        return murk_fail(context, MURK_ERROR_INTERNAL,
                         "%s: OpenImageIO cannot write deep pictures of this format", path);
    file->threads(context->threads);
    OIIO::ImageSpec spec = deep_spec(deep, options);
    bool encoded = file->open(memory.path(), spec);
    for (int j = 0; encoded && j < spec.height; j += ROWS)
        encoded = write_rows(*file, spec, deep, j, std::min(j + ROWS, spec.height));
    if (!(encoded && file->close()))
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: %s", path,
                         one_line(file->geterror()).c_str());
    return memory.take(bytes, size)
               ? MURK_OK
               : murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
}

} // namespace

murk_status murk_oiio_encode_deep(murk_context *context, const char *path, const murk_deep *deep,
                                  const murk_image_write_options *options, void **bytes,
                                  size_t *size) noexcept
{
    return guard(context, path,
                 [&] { return encode_deep(context, path, *deep, *options, bytes, size); });
}
