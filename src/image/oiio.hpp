// SPDX-License-Identifier: Apache-2.0
// What the sources that see OpenImageIO share. One guard keeps its exceptions inside.
#ifndef MURK_IMAGE_OIIO_HPP
#define MURK_IMAGE_OIIO_HPP

#include "context.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <new>
#include <string>

namespace murk
{

template <typename Body>
murk_status guard(murk_context *context, const char *path, Body body) noexcept
{
    try {
        return body();
    } catch (const std::bad_alloc &) {
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", path);
    } catch (const std::exception &error) {
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: %s", path, error.what());
    } catch (...) {
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: unknown exception in OpenImageIO",
                         path);
    }
}

// OpenImageIO's messages may span lines and end with one.
inline std::string one_line(std::string text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "unknown reason" : text;
}

// The metadata of all that murk writes; texts may be NULL.
inline void describe(OIIO::ImageSpec &spec, const char *command, const char *units)
{
    spec.attribute("Software", "murk " MURK_VERSION);
    if (command)
        spec.attribute("murk:command", command);
    if (units)
        spec.attribute("murk:units", units);
}

} // namespace murk

#endif
