/* SPDX-License-Identifier: Apache-2.0 */
/* What stands behind murk_vdb. */
#ifndef MURK_VDB_HANDLE_HPP
#define MURK_VDB_HANDLE_HPP

#include "vdb.h"

#include <deque>
#include <map>
#include <openvdb/openvdb.h>
#include <string>

struct murk_vdb_item {
    murk_grid_info info{};
    std::string name, type, grid_class, unreadable; /* info points to these */
    int components = 0;                             /* of its values that can be taken */
    openvdb::GridBase::Ptr grid;                    /* null where there are none */
};

struct murk_vdb {
    std::string path, band;
    std::map<std::string, double> asymmetry; /* by the key of the file metadata */
    std::deque<murk_vdb_item> items;         /* a deque: infos must not move */
};

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
