/* SPDX-License-Identifier: Apache-2.0 */
/* What of each voxel lies inside a surface. */
#include "handle.hpp"

#include <algorithm>
#include <cmath>

using openvdb::Coord;
using openvdb::CoordBBox;

namespace
{

/* The part of a voxel that is inside, d from the surface in units of its edge: exact for planes
   along its faces. The errors of other planes cancel across them, so that volumes are right. */
float part_inside(double d)
{
    return float(std::isnan(d) ? d : std::min(std::max(0.5 - d, 0.0), 1.0));
}

/* Calls body(level, box, value) for each tile, active or not: the inside is not. */
template <class Grid, class Body> void each_tile(const Grid &grid, Body &&body)
{
    auto tile = grid.tree().cbeginValueAll();
    tile.setMaxDepth(tile.getLeafDepth() - 1);
    for (; tile; ++tile) {
        CoordBBox box;
        tile.getBoundingBox(box);
        body(openvdb::Index(tile.getLevel()), box, double(*tile));
    }
}

template <class Grid> double edge_of(const Grid &grid)
{
    const openvdb::Vec3d size = grid.voxelSize();
    return std::cbrt(size[0] * size[1] * size[2]);
}

template <class Grid> uint64_t count_tile_bricks(const Grid &grid)
{
    const double edge = edge_of(grid);
    uint64_t bricks = 0;
    each_tile(grid, [&](openvdb::Index, const CoordBBox &box, double value) {
        bricks += part_inside(value / edge) > 0 ? murk_vdb_bricks_of(box) : 0;
    });
    return bricks;
}

template <class Grid> openvdb::FloatGrid::Ptr fill(const Grid &grid)
{
    const double edge = edge_of(grid);
    auto filled = openvdb::FloatGrid::create(0);
    filled->setTransform(grid.transform().copy());
    openvdb::FloatTree &tree = filled->tree();
    each_tile(grid, [&](openvdb::Index level, const CoordBBox &box, double value) {
        if (const float part = part_inside(value / edge); !(part <= 0))
            tree.addTile(level, box.min(), part, true);
    });
    for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
        openvdb::FloatTree::LeafNodeType *to = nullptr;
        for (auto voxel = leaf->cbeginValueAll(); voxel; ++voxel) {
            const float part = part_inside(double(*voxel) / edge);
            if (part <= 0)
                continue;
            if (!to)
                to = tree.touchLeaf(leaf->origin());
            to->setValueOn(voxel.pos(), part);
        }
    }
    return filled;
}

} // namespace

bool murk_vdb_is_level_set(const openvdb::GridBase &grid)
{
    return grid.getGridClass() == openvdb::GRID_LEVEL_SET &&
           (grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>());
}

uint64_t murk_vdb_inside_bricks(const openvdb::GridBase &grid)
{
    return grid.isType<openvdb::FloatGrid>()
               ? count_tile_bricks(static_cast<const openvdb::FloatGrid &>(grid))
               : count_tile_bricks(static_cast<const openvdb::DoubleGrid &>(grid));
}

openvdb::FloatGrid::Ptr murk_vdb_inside(const openvdb::GridBase &grid)
{
    return grid.isType<openvdb::FloatGrid>() ? fill(static_cast<const openvdb::FloatGrid &>(grid))
                                             : fill(static_cast<const openvdb::DoubleGrid &>(grid));
}
