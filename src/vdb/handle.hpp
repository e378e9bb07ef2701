/* SPDX-License-Identifier: Apache-2.0 */
/* What stands behind murk_vdb. */
#ifndef MURK_VDB_HANDLE_HPP
#define MURK_VDB_HANDLE_HPP

#include "vdb.h"

#include <deque>
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
    std::deque<murk_vdb_item> items; /* a deque: infos must not move */
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
