/* SPDX-License-Identifier: Apache-2.0 */
/* What stands behind murk_vdb. */
#ifndef MURK_VDB_HANDLE_HPP
#define MURK_VDB_HANDLE_HPP

#include "apart.h"
#include "source.h"
#include "vdb.h"

#include <deque>
#include <functional>
#include <openvdb/openvdb.h>
#include <string>

struct murk_vdb_item {
    murk_grid_info info{};
    std::string name, type, grid_class, unreadable; /* info points to these */
    int components = 0;                             /* of its values that can be taken */
    openvdb::GridBase::Ptr grid;                    /* in the child; null where there are none */

    /* Lets info point to the strings. */
    void point()
    {
        info.name = name.c_str();
        info.type = type.c_str();
        info.grid_class = grid_class.c_str();
        info.unreadable = info.readable ? nullptr : unreadable.c_str();
    }
};

struct murk_vdb {
    std::string path, band;
    std::deque<murk_vdb_item> items; /* a deque: infos must not move */
    murk_apart *child = nullptr;     /* has the grids; null in itself */

    murk_vdb() = default;
    ~murk_vdb()
    {
        murk_apart_stop(child);
    }
    murk_vdb(const murk_vdb &) = delete;
    murk_vdb &operator=(const murk_vdb &) = delete;
};

#pragma GCC visibility push(hidden)

/* Reads all grids of a source into vdb, or the one of a stream, in this process: where the bytes
   are foreign, that must be the child. */
murk_status murk_vdb_load(murk_context *context, const murk_source &from, murk_vdb &vdb) noexcept;
murk_status murk_vdb_load_grid(murk_context *context, const murk_source &from,
                               openvdb::GridBase::Ptr &out) noexcept;

/* Where that is: answers the questions of apart.cpp. data is a murk_vdb_job. */
enum murk_vdb_question { MURK_VDB_READ, MURK_VDB_BRICKS, MURK_VDB_GRID };
murk_status murk_vdb_serve(murk_context *context, void *data, const murk_apart_question *question,
                           int file);

struct murk_vdb_job {
    murk_source *from;
    murk_vdb *vdb;
    bool is_memory_ours; /* what is more than the limit is more than any sound file takes */
};

/* What heads the arrays of bricks in an answer. */
struct murk_vdb_brick_header {
    uint64_t count;
    double background;
};

/* Copies a component of a grid into arrays that allocate() makes, zeroed, for the count it finds.
 */
void murk_vdb_copy(const murk_vdb_item &item, int component,
                   const std::function<void(murk_bricks &)> &allocate, murk_bricks &bricks);

/* Names, numbers and texts of all grids as bytes, and back; false where they make no sense. */
std::string murk_vdb_pack(const murk_vdb &vdb);
bool murk_vdb_unpack(const std::string &bytes, murk_vdb &vdb);

/* The grid itself, from the child, as it was read. */
murk_status murk_vdb_fetch(murk_context *context, const murk_vdb &vdb, size_t index,
                           openvdb::GridBase::Ptr &out);

#pragma GCC visibility pop

/* Bricks that the active tiles of a grid would become at most; beyond that a grid is refused. */
constexpr uint64_t murk_vdb_tile_bricks = uint64_t(1) << 22;

/* Fills info (numbers, readable), the strings and the components from the grid. */
void murk_vdb_describe(const openvdb::GridBase &grid, murk_vdb_item &item);

/* Bricks of 8^3 voxels that a tile covers. */
inline uint64_t murk_vdb_bricks_of(const openvdb::CoordBBox &tile)
{
    return tile.volume() / 512;
}

/* Calls body with the grid as FloatGrid or DoubleGrid; false for any other type. */
template <class Body> bool murk_vdb_scalar(const openvdb::GridBase &grid, Body &&body)
{
    if (grid.isType<openvdb::FloatGrid>())
        body(static_cast<const openvdb::FloatGrid &>(grid));
    else if (grid.isType<openvdb::DoubleGrid>())
        body(static_cast<const openvdb::DoubleGrid &>(grid));
    else
        return false;
    return true;
}

/* Calls body with the grid as one of those or Vec3SGrid; false for any other type. */
template <class Body> bool murk_vdb_typed(const openvdb::GridBase &grid, Body &&body)
{
    if (!grid.isType<openvdb::Vec3SGrid>())
        return murk_vdb_scalar(grid, body);
    body(static_cast<const openvdb::Vec3SGrid &>(grid));
    return true;
}

/* Calls body(box, value) for each active tile. */
template <class Grid, class Body> void murk_vdb_each_tile(const Grid &grid, Body &&body)
{
    auto tile = grid.tree().cbeginValueOn();
    tile.setMaxDepth(tile.getLeafDepth() - 1);
    for (; tile; ++tile) {
        openvdb::CoordBBox box;
        tile.getBoundingBox(box);
        body(box, *tile);
    }
}

#endif
