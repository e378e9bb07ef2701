/* SPDX-License-Identifier: Apache-2.0 */
/* Files whose bytes are made elsewhere. */
#include "beside.h"

murk_status murk_file_check(murk_context *context, const char *path)
{
    return murk_beside_check(context, path);
}

murk_status murk_file_write(murk_context *context, const char *path, const void *bytes, size_t size)
{
    murk_beside file;
    murk_status status = murk_beside_open(context, path, &file);
    if (status != MURK_OK)
        return status;
    status = murk_beside_write(context, &file, bytes, size);
    if (status == MURK_OK)
        return murk_beside_finish(context, &file);
    murk_beside_discard(&file);
    return status;
}
