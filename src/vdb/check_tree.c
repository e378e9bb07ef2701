/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Layout of a tree of 8^3 leaves under nodes of 16^3 under nodes of 32^3 under the root:
 *   int32 1; background; uint32 number of tiles, of children; each tile: int32 x, y, z, value,
 *   uint8 active; each child: int32 x, y, z, then the node:
 *     node: mask of its children, mask of its active values, values, its children;
 *     leaf: mask of its active values;
 *   then, for each leaf in the same order: mask, values.
 *   values: [format 222 on: uint8 kind, up to two inactive values, up to one mask], and then all
 *   values, or the active ones, as int64 n and n compressed bytes, or -n plain ones.
 */
#include "check.h"

#include "cursor.h"

enum { NODE_MASKS = 222, ZIP = 1, ACTIVE_MASK = 2, BLOSC = 4, ALL_VALUES = 6, BLOSC_HEADER = 16 };
enum { LEAF_MASK = 64, SMALL_MASK = 512, LARGE_MASK = 4096, INDEX_MAX = 1 << 30, ROOT_EDGE = 4096 };

/* How leaves keep their values. */
typedef enum leaf_kind { LEAF_VALUES, LEAF_BITS, LEAF_MASK_ONLY } leaf_kind;

typedef struct tree_type {
    const char *name;
    uint32_t size, half_size; /* of a value, and of one that is saved as half float */
    leaf_kind leaf;
} tree_type;

static const tree_type types[] = {
    {"Tree_float_5_4_3", 4, 2, LEAF_VALUES},   {"Tree_double_5_4_3", 8, 2, LEAF_VALUES},
    {"Tree_int32_5_4_3", 4, 4, LEAF_VALUES},   {"Tree_int64_5_4_3", 8, 8, LEAF_VALUES},
    {"Tree_vec3i_5_4_3", 12, 12, LEAF_VALUES}, {"Tree_vec3s_5_4_3", 12, 6, LEAF_VALUES},
    {"Tree_vec3d_5_4_3", 24, 6, LEAF_VALUES},  {"Tree_bool_5_4_3", 1, 1, LEAF_BITS},
    {"Tree_mask_5_4_3", 1, 1, LEAF_MASK_ONLY}};

typedef struct walk {
    murk_cursor c;
    const tree_type *type;
    bool is_half;
    uint32_t version, compression;
    uint64_t leaves;
} walk;

static const tree_type *find_type(const char *name, bool *is_half)
{
    static const char suffix[] = "_HalfFloat";
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        size_t length = strlen(types[i].name);
        if (strncmp(name, types[i].name, length))
            continue;
        *is_half = !strcmp(name + length, suffix);
        if (*is_half || !name[length])
            return &types[i];
    }
    return NULL;
}

static size_t count_bits(const unsigned char *mask, size_t bytes)
{
    size_t count = 0;
    for (size_t i = 0; i < bytes; i += 8) {
        uint64_t word;
        memcpy(&word, mask + i, sizeof word);
        count += (size_t)__builtin_popcountll(word);
    }
    return count;
}

/* OpenVDB trusts these numbers: plain bytes go straight into the values, and Blosc's header says
   how much is read and written. */
static void skip_block(walk *w, uint64_t bytes)
{
    murk_cursor *c = &w->c;
    if (!(w->compression & (ZIP | BLOSC))) {
        murk_skip(c, bytes);
        return;
    }
    int64_t n = (int64_t)murk_take_number(c, 8);
    if (n <= 0) {
        if (-(uint64_t)n != bytes)
            murk_cursor_fail(c, "a block of values has a wrong size");
        murk_skip(c, bytes);
        return;
    }
    uint64_t start = c->at;
    murk_skip(c, (uint64_t)n);
    if (!(w->compression & BLOSC) || c->trouble)
        return;
    murk_cursor header = *c;
    header.at = start;
    murk_skip(&header, 4);
    uint64_t plain = murk_take_number(&header, 4);
    murk_skip(&header, 4);
    uint64_t packed = murk_take_number(&header, 4);
    if (n < BLOSC_HEADER || header.trouble || plain != bytes || packed != (uint64_t)n)
        murk_cursor_fail(c, "a compressed block has a wrong size");
}

/* The values of a node or leaf with 8 * mask_bytes places, of which mask are active; stored is
   their number in formats that keep all. */
static void skip_values(walk *w, const unsigned char *mask, size_t mask_bytes, size_t stored)
{
    murk_cursor *c = &w->c;
    uint64_t kind = ALL_VALUES, count = stored;
    if (w->version >= NODE_MASKS)
        kind = murk_take_number(c, 1);
    if (kind > ALL_VALUES)
        murk_cursor_fail(c, "values of an unknown kind");
    if (kind == 2 || kind == 4 || kind == 5)
        murk_skip(c, w->type->size * (kind == 5 ? 2u : 1u));
    if (kind >= 3 && kind <= 5)
        murk_skip(c, mask_bytes);
    if ((w->compression & ACTIVE_MASK) && kind != ALL_VALUES)
        count = count_bits(mask, mask_bytes);
    /* No block is written for no half floats. */
    if (!w->is_half || count || w->type->half_size == w->type->size)
        skip_block(w, count * (w->is_half ? w->type->half_size : w->type->size));
}

static void skip_node(walk *w, size_t mask_bytes)
{
    unsigned char children[LARGE_MASK], values[LARGE_MASK];
    murk_cursor *c = &w->c;
    murk_take(c, children, mask_bytes);
    murk_take(c, values, mask_bytes);
    for (size_t i = 0; i < mask_bytes; i++)
        if (children[i] & values[i])
            murk_cursor_fail(c, "a place that is both a value and a node");
    size_t count = count_bits(children, mask_bytes), places = 8 * mask_bytes;
    skip_values(w, values, mask_bytes, w->version < NODE_MASKS ? places - count : places);
    if (mask_bytes == SMALL_MASK) {
        w->leaves += count;
        murk_skip(c, (uint64_t)count * LEAF_MASK);
    } else
        for (; count > 0 && !c->trouble; count--)
            skip_node(w, SMALL_MASK);
}

static void skip_leaf(walk *w)
{
    unsigned char mask[LEAF_MASK];
    murk_cursor *c = &w->c;
    murk_take(c, mask, sizeof mask);
    if (w->type->leaf != LEAF_VALUES || w->version < NODE_MASKS)
        murk_skip(c, 12); /* where the leaf is */
    if (w->type->leaf == LEAF_VALUES) {
        if (w->version < NODE_MASKS && murk_take_number(c, 1) != 1)
            murk_cursor_fail(c, "a leaf with several buffers");
        skip_values(w, mask, LEAF_MASK, 8 * LEAF_MASK);
    } else if (w->type->leaf == LEAF_BITS)
        murk_skip(c, LEAF_MASK);
}

/* Takes a root place; gives false where it does not come after the one before. */
static bool take_place(murk_cursor *c, int32_t place[3])
{
    int order = 0;
    for (int a = 0; a < 3; a++) {
        int32_t next = (int32_t)(uint32_t)murk_take_number(c, 4);
        if (next < -INDEX_MAX || next >= INDEX_MAX || next % ROOT_EDGE)
            murk_cursor_fail(c, "a node at an impossible place");
        if (!order)
            order = next < place[a] ? -1 : next > place[a];
        place[a] = next;
    }
    return order > 0;
}

static void skip_tree(walk *w)
{
    murk_cursor *c = &w->c;
    if (murk_take_number(c, 4) != 1)
        murk_cursor_fail(c, "a tree with several buffers");
    murk_skip(c, w->type->size);
    uint64_t tiles = murk_take_number(c, 4), children = murk_take_number(c, 4);
    int32_t place[3] = {0};
    for (; tiles > 0 && !c->trouble; tiles--) {
        take_place(c, place);
        murk_skip(c, w->type->size);
        if (murk_take_number(c, 1) > 1)
            murk_cursor_fail(c, "a flag that is neither 0 nor 1");
    }
    /* Two children at one place would leave OpenVDB with fewer leaves than the file has. */
    for (int a = 0; a < 3; a++)
        place[a] = INT32_MIN;
    for (; children > 0 && !c->trouble; children--) {
        if (!take_place(c, place))
            murk_cursor_fail(c, "nodes out of order");
        skip_node(w, LARGE_MASK);
    }
    for (; w->leaves > 0 && !c->trouble; w->leaves--)
        skip_leaf(w);
}

bool murk_vdb_knows_tree(const char *type)
{
    bool is_half;
    return find_type(type, &is_half) != NULL;
}

const char *murk_vdb_check_tree(const void *bytes, uint64_t size, const murk_vdb_header *header,
                                murk_vdb_entry *entry)
{
    if (entry->parent[0])
        return NULL; /* the parent's is checked */
    const murk_source memory = {.file = -1, .memory = (unsigned char *)bytes, .size = size};
    walk w = {.c = {.source = &memory, .at = entry->tree - entry->start, .end = size},
              .version = header->version,
              .compression = entry->compression};
    w.type = find_type(entry->type, &w.is_half);
    if (!w.type)
        return "murk does not know its type";
    if (w.is_half != entry->is_half)
        return "its type and its metadata differ about 16-bit floats";
    skip_tree(&w);
    if (!w.c.trouble && !entry->end)
        entry->end = entry->start + w.c.at;
    return w.c.trouble;
}
