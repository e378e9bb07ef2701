/* SPDX-License-Identifier: Apache-2.0 */
/* Trees to bricks. */
#include "handle.hpp"

#include <algorithm>
#include <vector>

using openvdb::Coord;
using openvdb::CoordBBox;

namespace
{

/* A brick's place and where its values come from: a leaf, or a tile's value where that is null. */
template <class Leaf> struct origin {
    Coord brick;
    const Leaf *leaf;
    float tile;
};

Coord brick_of(const Coord &voxel)
{
    return Coord(voxel[0] >> 3, voxel[1] >> 3, voxel[2] >> 3);
}

float pick(double value, int)
{
    return float(value);
}

float pick(const openvdb::Vec3s &value, int component)
{
    return value[component];
}

template <class Grid> auto find_origins(const Grid &grid, int component)
{
    using Leaf = typename Grid::TreeType::LeafNodeType;
    std::vector<origin<Leaf>> found;
    for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
        if (!leaf->getValueMask().isOff())
            found.push_back({brick_of(leaf->origin()), &*leaf, 0});
    murk_vdb_each_tile(grid, [&](const CoordBBox &box, const auto &value) {
        const CoordBBox bricks(brick_of(box.min()), brick_of(box.max()));
        for (auto at = bricks.begin(); at; ++at)
            found.push_back({*at, nullptr, pick(value, component)});
    });
    std::sort(found.begin(), found.end(),
              [](const auto &a, const auto &b) { return a.brick < b.brick; });
    return found;
}

template <class Leaf>
void fill(const origin<Leaf> &from, int component, uint64_t mask[8], float *values)
{
    if (!from.leaf) {
        std::fill_n(mask, 8, ~uint64_t(0));
        std::fill_n(values, MURK_BRICK_SLOTS, from.tile);
        return;
    }
    for (auto voxel = from.leaf->cbeginValueOn(); voxel; ++voxel) {
        const unsigned slot = voxel.pos();
        mask[slot >> 6] |= uint64_t(1) << (slot & 63);
        values[slot] = pick(*voxel, component);
    }
}

template <class Grid>
murk_status copy(const Grid &grid, int component, const murk_vdb_allocate &allocate,
                 murk_bricks &bricks)
{
    const auto found = find_origins(grid, component);
    bricks.count = found.size();
    bricks.background = pick(grid.background(), component);
    if (const murk_status status = allocate(bricks))
        return status;
    for (size_t b = 0; b < found.size(); b++) {
        for (int a = 0; a < 3; a++)
            bricks.brick[b][a] = found[b].brick[a];
        fill(found[b], component, bricks.mask[b], bricks.values + b * MURK_BRICK_SLOTS);
    }
    return MURK_OK;
}

} // namespace

murk_status murk_vdb_copy(const murk_vdb_item &item, int component,
                          const murk_vdb_allocate &allocate, murk_bricks &bricks)
{
    murk_status status = MURK_OK;
    const auto take = [&](const auto &grid) { status = copy(grid, component, allocate, bricks); };
    if (murk_vdb_is_level_set(*item.grid))
        take(*murk_vdb_inside(*item.grid));
    else
        murk_vdb_typed(*item.grid, take);
    return status;
}
