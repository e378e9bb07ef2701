/* SPDX-License-Identifier: Apache-2.0 */
/* What murk says about a grid, and whether it takes it for a scalar field. */
#include "handle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

using openvdb::Coord;
using openvdb::CoordBBox;

namespace
{

/* Leaves room for margins in 32-bit indices. */
constexpr int32_t index_limit = 1 << 30;

/* Sums of the values along one index axis, for the columns of voxels that hold something. */
class columns
{
  public:
    explicit columns(int axis) : u_((axis + 1) % 3), v_((axis + 2) % 3), axis_(axis)
    {
    }

    void add_voxel(const Coord &at, double value)
    {
        brick(at[u_] >> 3, at[v_] >> 3)[size_t((at[u_] & 7) << 3 | (at[v_] & 7))] += value;
    }

    void add_tile(const CoordBBox &box, double value)
    {
        const double sum = value * box.dim()[axis_];
        for (int u = box.min()[u_] >> 3; u <= box.max()[u_] >> 3; u++)
            for (int v = box.min()[v_] >> 3; v <= box.max()[v_] >> 3; v++)
                for (double &column : brick(u, v))
                    column += sum;
    }

    void finish(double edge, double &mean, double &maximum) const
    {
        double sum = 0, largest = 0;
        size_t used = 0;
        for (const auto &entry : bricks_)
            for (double column : entry.second) {
                sum += column;
                used += column > 0;
                largest = std::max(largest, column);
            }
        mean = used ? sum / double(used) * edge : 0;
        maximum = largest * edge;
    }

  private:
    std::array<double, 64> &brick(int u, int v)
    {
        return bricks_[uint64_t(uint32_t(u)) << 32 | uint32_t(v)];
    }

    int u_, v_, axis_;
    std::unordered_map<uint64_t, std::array<double, 64>> bricks_;
};

class tally
{
  public:
    tally(murk_grid_info &info, int axis) : info_(info), columns_(axis)
    {
    }

    /* Counts a value that n voxels have, as the float that it will be; returns what it adds to a
       column. */
    double add(double exact, uint64_t n)
    {
        const double value = float(exact);
        info_.nonzero_voxels += value != 0 ? n : 0;
        if (!(value >= 0 && std::isfinite(value)))
            info_.invalid_voxels += n;
        if (!std::isfinite(value))
            return 0;
        info_.value_min = any_ ? std::min(info_.value_min, value) : value;
        info_.value_max = any_ ? std::max(info_.value_max, value) : value;
        any_ = true;
        return std::max(value, 0.0);
    }

    template <class Grid> void count(const Grid &grid, double edge)
    {
        for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
            for (auto voxel = leaf->cbeginValueOn(); voxel; ++voxel)
                if (const double value = add(double(*voxel), 1); value > 0)
                    columns_.add_voxel(voxel.getCoord(), value);
        murk_vdb_each_tile(grid, [&](const CoordBBox &box, double tile) {
            if (const double value = add(tile, box.volume()); value > 0)
                columns_.add_tile(box, value);
        });
        columns_.finish(edge, info_.mean_depth, info_.max_depth);
    }

  private:
    murk_grid_info &info_;
    columns columns_;
    bool any_ = false;
};

/* The grid's own counts are made by TBB, whose locks a thread of the parent may have held at the
   moment of the fork. */
void count_active(const openvdb::GridBase &grid, murk_grid_info &info)
{
    using known = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                                    openvdb::Int64Grid, openvdb::Vec3IGrid, openvdb::Vec3SGrid,
                                    openvdb::Vec3DGrid, openvdb::BoolGrid, openvdb::MaskGrid>;
    grid.apply<known>([&](const auto &typed) {
        info.active_voxels = typed.tree().root().onVoxelCount();
        info.active_tiles = typed.tree().root().onTileCount();
    });
}

void describe_place(const openvdb::GridBase &grid, murk_grid_info &info)
{
    CoordBBox box; /* inverted until something is found */
    if (info.active_voxels)
        box = grid.evalActiveVoxelBoundingBox();
    const openvdb::Vec3d voxel = grid.voxelSize();
    openvdb::Mat4d matrix = openvdb::Mat4d::identity();
    if (grid.transform().isLinear())
        matrix = grid.transform().baseMap()->getAffineMap()->getMat4();
    for (int a = 0; a < 3; a++) {
        info.box_min[a] = box.min()[a];
        info.box_max[a] = box.max()[a];
        info.voxel_size[a] = voxel[a];
    }
    for (int row = 0; row < 4; row++) /* OpenVDB multiplies rows from the left */
        for (int column = 0; column < 4; column++)
            info.index_to_world[4 * row + column] = matrix[column][row];
}

int shortest_axis(const murk_grid_info &info)
{
    auto length = [&](int a) {
        return (double(info.box_max[a]) - info.box_min[a] + 1) * info.voxel_size[a];
    };
    int axis = 0;
    for (int a = 1; a < 3; a++)
        if (length(a) < length(axis))
            axis = a;
    return axis;
}

std::string not_scalar(const murk_vdb_item &item)
{
    return "of type " + item.type + ", not a scalar field";
}

/* Why murk cannot take a linear transform, or "". */
std::string find_transform_obstacle(const murk_grid_info &info)
{
    const double *m = info.index_to_world;
    double length[3];
    for (int i = 0; i < 12; i++)
        if (!std::isfinite(m[i]))
            return "on a transform that is not finite";
    for (int a = 0; a < 3; a++) {
        length[a] = std::hypot(m[a], m[4 + a], m[8 + a]);
        if (!(length[a] > 0 && std::isfinite(length[a])))
            return "on a transform that gives its voxels no size";
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3;
        const double dot = m[a] * m[b] + m[4 + a] * m[4 + b] + m[8 + a] * m[8 + b];
        if (std::fabs(dot) > 1e-6 * length[a] * length[b])
            return "on a sheared transform; resample it to voxels with right angles";
    }
    return "";
}

/* Why murk cannot take a grid's values, or "". */
std::string find_obstacle(const openvdb::GridBase &grid, const murk_vdb_item &item)
{
    const murk_grid_info &info = item.info;
    const bool level_set = murk_vdb_is_level_set(grid);
    uint64_t bricks = level_set ? murk_vdb_inside_bricks(grid) : 0;
    const bool known = level_set || murk_vdb_typed(grid, [&](const auto &typed) {
                           murk_vdb_each_tile(typed, [&](const CoordBBox &box, const auto &) {
                               bricks += murk_vdb_bricks_of(box);
                           });
                       });
    if (!known)
        return not_scalar(item);
    if (!grid.transform().isLinear())
        return "on a frustum (nonlinear) transform; resample it to a box of even voxels";
    for (int a = 0; a < 3 && info.active_voxels; a++)
        if (info.box_min[a] < -index_limit || info.box_max[a] > index_limit)
            return "its voxels lie beyond index " + std::to_string(index_limit) + "; clip the grid";
    if (bricks > murk_vdb_tile_bricks)
        return std::string(level_set ? "its inside" : "its active tiles") + " would fill " +
               std::to_string(bricks) +
               " bricks of 8^3 voxels, "
               "more than the " +
               std::to_string(murk_vdb_tile_bricks) +
               " that murk expands; "
               "clip the grid";
    return find_transform_obstacle(info);
}

} // namespace

void murk_vdb_describe(const openvdb::GridBase &grid, murk_vdb_item &item)
{
    murk_grid_info &info = item.info;
    const bool is_half = grid.isType<openvdb::FloatGrid>() && grid.saveFloatAsHalf();
    item.type = is_half ? "half" : grid.valueType();
    item.grid_class = openvdb::GridBase::gridClassToString(grid.getGridClass());
    count_active(grid, info);
    describe_place(grid, info);
    item.unreadable = find_obstacle(grid, item);
    if (item.unreadable.empty())
        item.components = grid.isType<openvdb::Vec3SGrid>() ? 3 : 1;
    if (item.components == 3)
        item.unreadable = not_scalar(item);
    info.readable = item.unreadable.empty();
    if (!info.readable)
        return;
    const int axis = shortest_axis(info);
    const auto count = [&](const auto &typed) {
        tally(info, axis).count(typed, info.voxel_size[axis]);
    };
    if (murk_vdb_is_level_set(grid))
        count(*murk_vdb_inside(grid));
    else
        murk_vdb_scalar(grid, count);
}
