/* SPDX-License-Identifier: Apache-2.0 */
/* What stands behind murk_vdb. */
#ifndef MURK_VDB_HANDLE_HPP
#define MURK_VDB_HANDLE_HPP

#include "apart.h"
#include "source.h"
#include "vdb.h"

#include <deque>
#include <functional>
#include <map>
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
    std::map<std::string, double> asymmetry; /* by the key of the file metadata */
    std::deque<murk_vdb_item> items;         /* a deque: infos must not move */
    murk_apart *child = nullptr;             /* has the grids; null in itself */

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

/* Makes the arrays of bricks->count bricks, zeroed. */
using murk_vdb_allocate = std::function<murk_status(murk_bricks &)>;

/* Copies a component of a grid into arrays that allocate() makes for the count it finds; of a level
   set, of its inside. */
murk_status murk_vdb_copy(const murk_vdb_item &item, int component,
                          const murk_vdb_allocate &allocate, murk_bricks &bricks);

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

/* Whether a grid holds distances from a surface, negative inside. */
bool murk_vdb_is_level_set(const openvdb::GridBase &grid);

/* Of a level set: the part of each voxel that is inside, active where there is any; and the bricks
   that its tiles would become at most. */
openvdb::FloatGrid::Ptr murk_vdb_inside(const openvdb::GridBase &grid);
uint64_t murk_vdb_inside_bricks(const openvdb::GridBase &grid);

/* Calls body with the grid as the one of the types that it is; false for any other. */
template <class Grid, class... Others, class Body>
bool murk_vdb_as(const openvdb::GridBase &grid, Body &&body)
{
    if (grid.isType<Grid>())
        body(static_cast<const Grid &>(grid));
    else if constexpr (sizeof...(Others) > 0)
        return murk_vdb_as<Others...>(grid, body);
    else
        return false;
    return true;
}

/* The same for all types that are scalars to murk: of a mask, active voxels are 1. */
template <class Body> bool murk_vdb_scalar(const openvdb::GridBase &grid, Body &&body)
{
    return murk_vdb_as<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                       openvdb::Int64Grid, openvdb::BoolGrid, openvdb::MaskGrid>(grid, body);
}

/* And for these and Vec3SGrid. */
template <class Body> bool murk_vdb_typed(const openvdb::GridBase &grid, Body &&body)
{
    return murk_vdb_as<openvdb::Vec3SGrid>(grid, body) || murk_vdb_scalar(grid, body);
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
