/* SPDX-License-Identifier: Apache-2.0 */
/* The one place where exceptions end: a status and a message come out instead. */
#ifndef MURK_VDB_GUARD_HPP
#define MURK_VDB_GUARD_HPP

#include "context.h"

#include <exception>
#include <new>
#include <openvdb/openvdb.h>
#include <string>

/* What an exception says, on one line and without OpenVDB's "IoError: " in front. */
inline std::string murk_reason(const std::exception &error)
{
    std::string text = error.what();
    const size_t colon = text.find("Error: ");
    if (colon != std::string::npos && text.find(' ') == colon + 6)
        text.erase(0, colon + 7);
    for (char &c : text)
        if (static_cast<unsigned char>(c) < ' ')
            c = ' ';
    return text;
}

/* Runs body, which returns a murk_status. `what` heads the message of an exception. */
template <class Body>
murk_status murk_guard(murk_context *context, const char *what, Body &&body) noexcept
{
    try {
        openvdb::initialize();
        return body();
    } catch (const std::bad_alloc &) {
        return murk_fail(context, MURK_ERROR_MEMORY, "%s: out of memory", what);
    } catch (const std::exception &error) {
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: %.500s", what, error.what());
    } catch (...) {
        return murk_fail(context, MURK_ERROR_INTERNAL, "%s: unknown failure in OpenVDB", what);
    }
}

#endif
