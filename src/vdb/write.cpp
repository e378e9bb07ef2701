/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks and grids to a file or stream. */
#include "vdb.h"

#include "beside.h"
#include "descriptor.hpp"
#include "guard.hpp"
#include "handle.hpp"

#include <cmath>
#include <cstring>
#include <map>
#include <openvdb/io/Archive.h>
#include <ostream>
#include <utility>

namespace
{

/* OpenVDB's own files go by name only; this writes the same to any stream. */
class archive : public openvdb::io::Archive
{
  public:
    void put(std::ostream &output, const openvdb::GridCPtrVec &grids,
             const openvdb::MetaMap &metadata, bool seekable) const
    {
        Archive::write(output, grids, seekable, metadata);
    }
};

/* Removes what is half written, whichever way the writing ends. */
struct output : murk_beside {
    output() : murk_beside{nullptr, -1, nullptr, nullptr}
    {
    }
    ~output()
    {
        murk_beside_discard(this);
    }
    output(const output &) = delete;
    output &operator=(const output &) = delete;
};

constexpr float half_max = 65504.0f;

/* OpenVDB simplifies a new transform by way of transformed points, which loses the last bits far
   from the origin; so the translation comes afterwards. */
openvdb::math::Transform::Ptr make_transform(const double m[16])
{
    openvdb::Mat4d linear = openvdb::Mat4d::identity();
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            linear[column][row] = m[4 * row + column];
    auto transform = openvdb::math::Transform::createLinearTransform(linear);
    if (m[3] != 0 || m[7] != 0 || m[11] != 0)
        transform->postTranslate(openvdb::Vec3d(m[3], m[7], m[11]));
    return transform;
}

/* The grids that are passed on or lend their transform, each fetched once. */
class fetched
{
  public:
    explicit fetched(murk_context *context) : context_(context)
    {
    }
    murk_status get(const murk_vdb *vdb, size_t index, openvdb::GridBase::Ptr &out)
    {
        openvdb::GridBase::Ptr &grid = grids_[{vdb, index}];
        const murk_status status = grid ? MURK_OK : murk_vdb_fetch(context_, *vdb, index, grid);
        out = grid;
        return status;
    }

  private:
    murk_context *context_;
    std::map<std::pair<const murk_vdb *, size_t>, openvdb::GridBase::Ptr> grids_;
};

/* Transform::copy() would simplify; this shares what stands behind it. */
openvdb::math::Transform::Ptr share_transform(const openvdb::GridBase &grid)
{
    return openvdb::math::Transform::Ptr(new openvdb::math::Transform(grid.transform()));
}

/* value(i): of slot i of all bricks. */
template <class Grid, class Value> auto fill_grid(const murk_bricks &bricks, Value &&value)
{
    using Leaf = typename Grid::TreeType::LeafNodeType;
    const auto background = openvdb::zeroVal<typename Grid::ValueType>();
    auto grid = Grid::create(background);
    for (size_t b = 0; b < bricks.count; b++) {
        const int32_t *at = bricks.brick[b];
        Leaf *leaf = new Leaf(openvdb::Coord(8 * at[0], 8 * at[1], 8 * at[2]), background, false);
        grid->tree().addLeaf(leaf);
        for (unsigned slot = 0; slot < MURK_BRICK_SLOTS; slot++)
            if (bricks.mask[b][slot >> 6] >> (slot & 63) & 1)
                leaf->setValueOn(slot, value(b * MURK_BRICK_SLOTS + slot));
    }
    return grid;
}

openvdb::GridBase::Ptr make_grid(const murk_vdb_grid &from)
{
    const float *x = from.bricks->values, *y = from.y, *z = from.z;
    openvdb::GridBase::Ptr grid;
    if (y)
        grid = fill_grid<openvdb::Vec3SGrid>(
            *from.bricks, [=](size_t i) { return openvdb::Vec3s(x[i], y[i], z[i]); });
    else
        grid = fill_grid<openvdb::FloatGrid>(*from.bricks, [=](size_t i) { return x[i]; });
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    grid->setCreator("murk " MURK_VERSION);
    grid->setName(from.name);
    return grid;
}

/* The largest value, for 16-bit floats that end at 65504. */
float find_maximum(const murk_vdb_grid &from)
{
    const float *const components[] = {from.bricks->values, from.y, from.z};
    float maximum = 0;
    for (const float *values : components)
        for (size_t i = 0; values && i < from.bricks->count * MURK_BRICK_SLOTS; i++)
            maximum = std::fmax(maximum, std::fabs(values[i]));
    return maximum;
}

openvdb::MetaMap make_metadata(const murk_vdb_meta *meta, size_t count)
{
    openvdb::MetaMap metadata;
    for (size_t i = 0; i < count; i++)
        if (meta[i].text)
            metadata.insertMeta(meta[i].name, openvdb::StringMetadata(meta[i].text));
        else
            metadata.insertMeta(meta[i].name, openvdb::DoubleMetadata(meta[i].number));
    return metadata;
}

murk_status put(murk_context *context, const char *path, const openvdb::GridCPtrVec &grids,
                const openvdb::MetaMap &metadata)
{
    output beside;
    murk_status status = murk_beside_open(context, path, &beside);
    if (status)
        return status;
    murk_descriptor descriptor(beside.file);
    try {
        std::ostream stream(&descriptor);
        stream.exceptions(std::ios::failbit | std::ios::badbit);
        archive().put(stream, grids, metadata, beside.target != nullptr);
        stream.flush();
    } catch (const std::ios_base::failure &) {
        return murk_fail(context, MURK_ERROR_IO, "%s: cannot be written: %s", beside.where,
                         std::strerror(descriptor.error()));
    }
    return murk_beside_finish(context, &beside);
}

} // namespace

murk_status murk_vdb_write(murk_context *context, const char *path, const murk_vdb_grid *grids,
                           size_t grid_count, const murk_vdb_meta *meta, size_t meta_count,
                           const murk_vdb *transform_of, size_t transform_index,
                           bool as_half) noexcept
{
    const char *where = std::strcmp(path, "-") ? path : "standard output";
    return murk_guard(context, where, [&]() -> murk_status {
        openvdb::GridCPtrVec written;
        openvdb::GridBase::Ptr other;
        fetched passed(context);
        for (size_t i = 0; i < grid_count; i++) {
            const murk_vdb_grid &from = grids[i];
            if (from.pass) {
                const murk_status status = passed.get(from.pass, from.pass_index, other);
                if (status)
                    return status;
                written.push_back(other);
                continue;
            }
            const float maximum = as_half ? find_maximum(from) : 0;
            if (maximum > half_max)
                return murk_fail(context, MURK_ERROR_INPUT,
                                 "%s, grid %s: %g is more than 16-bit floats hold (65504); write "
                                 "32-bit floats",
                                 where, from.name, double(maximum));
            openvdb::GridBase::Ptr grid = make_grid(from);
            grid->setSaveFloatAsHalf(as_half);
            if (transform_of)
                if (const murk_status status = passed.get(transform_of, transform_index, other))
                    return status;
            grid->setTransform(transform_of ? share_transform(*other)
                                            : make_transform(from.bricks->index_to_world));
            written.push_back(grid);
        }
        return put(context, path, written, make_metadata(meta, meta_count));
    });
}
