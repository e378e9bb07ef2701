/* SPDX-License-Identifier: Apache-2.0 */
/* Trees to bricks and back. */
#include "guard.hpp"
#include "handle.hpp"
#include "memory.h"
#include "vdb.h"

#include <algorithm>
#include <cstring>
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

/* Tiles are small in a file and large as bricks: what they come to, before any is made. */
template <class Grid> double count_bytes(const Grid &grid)
{
    double bricks = double(grid.tree().leafCount());
    murk_vdb_each_tile(grid, [&](const CoordBBox &box, const auto &) {
        const CoordBBox tile(brick_of(box.min()), brick_of(box.max()));
        const Coord size = tile.dim();
        bricks += double(size[0]) * double(size[1]) * double(size[2]);
    });
    const double each = sizeof(origin<typename Grid::TreeType::LeafNodeType>) + sizeof(int32_t[3]) +
                        sizeof(uint64_t[8]) + MURK_BRICK_SLOTS * sizeof(float);
    return bricks * each;
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

template <class Grid> bool copy(const Grid &grid, int component, murk_bricks &bricks)
{
    const auto found = find_origins(grid, component);
    bricks.count = found.size();
    bricks.background = pick(grid.background(), component);
    bricks.brick = static_cast<int32_t(*)[3]>(murk_alloc(found.size(), sizeof *bricks.brick));
    bricks.mask = static_cast<uint64_t(*)[8]>(murk_alloc(found.size(), sizeof *bricks.mask));
    bricks.values =
        static_cast<float *>(murk_alloc(found.size() * MURK_BRICK_SLOTS, sizeof(float)));
    if (!bricks.brick || !bricks.mask || !bricks.values)
        return false;
    for (size_t b = 0; b < found.size(); b++) {
        for (int a = 0; a < 3; a++)
            bricks.brick[b][a] = found[b].brick[a];
        fill(found[b], component, bricks.mask[b], bricks.values + b * MURK_BRICK_SLOTS);
    }
    return true;
}

} // namespace

murk_status murk_vdb_bricks(murk_context *context, const murk_vdb *vdb, size_t index, int component,
                            murk_bricks *out) noexcept
{
    return murk_guard(context, vdb->path.c_str(), [&]() -> murk_status {
        const murk_vdb_item &item = vdb->items[index];
        if (!item.grid)
            return murk_fail(context, MURK_ERROR_INPUT, "%s, grid %s: cannot be used: %s",
                             vdb->path.c_str(), item.name.c_str(), item.unreadable.c_str());
        murk_bricks bricks{};
        bool complete = false;
        double bytes = 0;
        const auto take = [&](const auto &grid) {
            bytes = count_bytes(grid);
            if (bytes <= double(murk_memory_left()))
                complete = copy(grid, component, bricks);
        };
        if (!complete) {
            murk_bricks_clear(&bricks);
            throw std::bad_alloc();
        }
        std::memcpy(bricks.index_to_world, item.info.index_to_world, sizeof bricks.index_to_world);
        *out = bricks;
        return MURK_OK;
    });
}
