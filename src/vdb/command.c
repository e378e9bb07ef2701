/* SPDX-License-Identifier: Apache-2.0 */
/* The command that a VDB records, found without reading its grids. */
#include "cursor.h"
#include "murk/murk.h"

/* Looks through the file metadata at the cursor. */
static void find_command(murk_cursor *c, char *text, size_t size)
{
    for (uint64_t count = murk_take_number(c, 4); count > 0 && !c->trouble; count--) {
        char name[MURK_VDB_NAME], type[MURK_VDB_NAME];
        murk_take_string(c, name);
        murk_take_string(c, type);
        uint64_t length = murk_take_number(c, 4);
        if (!c->trouble && !strcmp(name, "command") && !strcmp(type, "string") && length < size) {
            murk_take(c, text, (size_t)length);
            text[length] = '\0';
            return;
        }
        murk_skip(c, length);
    }
}

murk_status murk_volume_command(murk_context *context, const char *path, char *text, size_t size)
{
    murk_source source;
    murk_vdb_header header;
    murk_status status = murk_source_open(context, path, &source);
    if (status != MURK_OK)
        return status;
    status = murk_vdb_check(context, &source, &header);
    if (status == MURK_OK) {
        murk_cursor c = {
            .context = context, .source = &source, .at = header.prefix, .end = source.size};
        text[0] = '\0';
        find_command(&c, text, size);
        status = c.status;
    }
    murk_source_close(&source);
    return status;
}
