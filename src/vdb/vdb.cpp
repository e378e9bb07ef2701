/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Reads the grids of a file or stream one by one, in the process that serve.cpp keeps for that.
 * Each is given to OpenVDB as a stream of its own, made of the file's checked header and that
 * grid's bytes alone, which throws at its end: a damaged grid can neither read nor seek beyond
 * itself, and the others stay readable.
 */
#include "vdb.h"

#include "check.h"
#include "guard.hpp"
#include "handle.hpp"
#include "segments.hpp"

#include <cmath>
#include <istream>
#include <memory>
#include <openvdb/io/Stream.h>
#include <set>
#include <vector>

namespace
{

struct failure {
    murk_status status;
};

void check(murk_status status)
{
    if (status)
        throw failure{status};
}

/* Bytes of a source; copied where they are not in memory. */
class bytes
{
  public:
    bytes(murk_context *context, const murk_source &from, uint64_t start, uint64_t end)
        : data_(from.memory ? from.memory + start : nullptr), size_(end - start)
    {
        if (from.memory)
            return;
        copy_.reset(new unsigned char[size_]);
        check(murk_source_read(context, &from, start, copy_.get(), size_));
        data_ = copy_.get();
    }
    void add_to(murk_segments &stream) const
    {
        stream.add(data_, size_);
    }
    const unsigned char *data() const
    {
        return data_;
    }
    uint64_t size() const
    {
        return size_;
    }

  private:
    std::unique_ptr<unsigned char[]> copy_;
    const unsigned char *data_;
    uint64_t size_;
};

/* A descriptor and its grid, checked. The metadata that help to load a file later are left out:
   nothing is loaded later. */
class part
{
  public:
    part(murk_context *context, const murk_source &from, const murk_vdb_header &header,
         const murk_vdb_entry &entry)
        : entry_(entry), bytes_(context, from, entry.start, entry.end ? entry.end : from.size)
    {
        if (const char *trouble =
                murk_vdb_check_tree(bytes_.data(), bytes_.size(), &header, &entry_))
            throw std::runtime_error(std::string("damaged: ") + trouble);
        const uint32_t count = entry.metadata_count - (entry.delayed != entry.delayed_end);
        for (int i = 0; i < 4; i++)
            count_[i] = static_cast<unsigned char>(count >> 8 * i);
    }
    const murk_vdb_entry &entry() const
    {
        return entry_;
    }
    void add_to(murk_segments &stream) const
    {
        const uint64_t metadata = entry_.metadata + 4;
        const bool delayed = entry_.delayed != entry_.delayed_end;
        add(stream, entry_.start, entry_.metadata);
        stream.add(count_, 4);
        add(stream, metadata, delayed ? entry_.delayed : metadata);
        add(stream, delayed ? entry_.delayed_end : metadata, entry_.end);
    }

  private:
    void add(murk_segments &stream, uint64_t from, uint64_t to) const
    {
        stream.add(bytes_.data() + (from - entry_.start), to - from);
    }

    murk_vdb_entry entry_;
    bytes bytes_;
    unsigned char count_[4];
};

class reader
{
  public:
    reader(murk_context *context, const murk_source &from, murk_vdb &vdb)
        : context_(context), source_(from), vdb_(vdb)
    {
        check(murk_vdb_check(context, &from, &header_));
        vdb.band = header_.band;
        for (int i = 0; i < header_.asymmetries; i++)
            vdb.asymmetry[header_.asymmetry[i].key] = header_.asymmetry[i].value;
        /* A file's offsets are checked to the last before anything is read. */
        uint64_t start = header_.first;
        for (uint32_t i = 0; header_.has_offsets && i < header_.grid_count; i++) {
            entries_.emplace_back();
            check(murk_vdb_check_entry(context, &from, &header_, start, &entries_.back()));
            start = entries_.back().end;
        }
    }

    /* The grid of a stream of one. */
    openvdb::GridBase::Ptr read_only_grid()
    {
        entries_.emplace_back();
        check(murk_vdb_check_entry(context_, &source_, &header_, header_.first, &entries_.back()));
        return load(entries_.back());
    }

    void read()
    {
        uint64_t start = header_.first;
        for (uint32_t i = 0; i < header_.grid_count; i++) {
            if (!header_.has_offsets) {
                entries_.emplace_back();
                check(murk_vdb_check_entry(context_, &source_, &header_, start, &entries_.back()));
            }
            read_grid(entries_[i]);
            start = entries_[i].end;
            if (!start && i + 1 < header_.grid_count) {
                lose_rest();
                return;
            }
        }
    }

  private:
    murk_vdb_item &add_item(const std::string &label)
    {
        murk_vdb_item &item = vdb_.items.emplace_back();
        item.name = label;
        for (int n = 1; !names_.insert(item.name).second; n++)
            item.name = label + "[" + std::to_string(n) + "]";
        return item;
    }

    void read_grid(murk_vdb_entry &entry)
    {
        murk_vdb_item &item = add_item(entry.label);
        openvdb::GridBase::Ptr grid;
        try {
            if (!murk_vdb_knows_tree(entry.type))
                throw std::runtime_error("of type " + type_of(entry) + ", not a scalar field");
            grid = load(entry);
            murk_vdb_describe(*grid, item);
        } catch (const failure &) {
            throw;
        } catch (const std::bad_alloc &) {
            throw;
        } catch (const std::ios_base::failure &) {
            refuse(entry, item, "its data end too early or are damaged");
        } catch (const std::exception &error) {
            refuse(entry, item, murk_reason(error));
        }
        item.point();
        if (item.components == 3 && !is_radiosity(entry))
            item.components = 0; /* a velocity would take memory for nothing */
        if (item.components)
            item.grid = grid;
    }

    /* Stands for all grids of a stream behind one that murk does not know the end of. */
    void lose_rest()
    {
        const std::string behind = vdb_.items.back().name;
        murk_vdb_item &item = add_item("?");
        item.type = item.grid_class = "unknown";
        item.unreadable = "what comes behind grid " + behind +
                          " in a stream, which does not tell where that one ends; write a file, or "
                          "such grids last";
        item.point();
    }

    openvdb::GridBase::Ptr load(murk_vdb_entry &entry)
    {
        static const unsigned char no_metadata[4] = {0}, one[4] = {1}, two[4] = {2};
        const murk_vdb_entry *parent = find_parent(entry);
        const bytes prefix(context_, source_, 0, header_.prefix);
        std::unique_ptr<part> shared;
        if (parent)
            shared.reset(new part(context_, source_, header_, *parent));
        part own(context_, source_, header_, entry);
        entry = own.entry();

        murk_segments stream;
        prefix.add_to(stream);
        stream.add(no_metadata, 4);
        stream.add(parent ? two : one, 4);
        if (shared)
            shared->add_to(stream);
        own.add_to(stream);
        std::istream input(&stream);
        input.exceptions(std::ios::failbit | std::ios::badbit);
        openvdb::io::Stream archive(input, false);
        const openvdb::GridPtrVecPtr grids = archive.getGrids();
        if (!grids || grids->empty() || !grids->back())
            throw std::runtime_error("OpenVDB finds no grid");
        return grids->back();
    }

    /* The grid whose tree this one shares; it comes earlier in the file. */
    const murk_vdb_entry *find_parent(const murk_vdb_entry &entry) const
    {
        if (!entry.parent[0])
            return nullptr;
        for (const murk_vdb_entry &other : entries_)
            if (&other != &entry && !other.parent[0] &&
                !std::string(other.name).compare(entry.parent) && other.start < entry.start)
                return &other;
        throw std::runtime_error(std::string("it shares the voxels of a missing grid"));
    }

    void refuse(const murk_vdb_entry &entry, murk_vdb_item &item, const std::string &reason)
    {
        if (!entry.end && murk_vdb_knows_tree(entry.type)) /* damage, and the next grid is lost */
            throw failure{murk_fail(context_, MURK_ERROR_INPUT,
                                    "%s, grid %s: cannot be read: %s; write the stream again",
                                    source_.where, item.name.c_str(), reason.c_str())};
        item.info = murk_grid_info{};
        item.components = 0;
        item.type = type_of(entry);
        item.grid_class = "unknown";
        item.unreadable = reason;
    }

    static bool is_radiosity(const murk_vdb_entry &entry)
    {
        const std::string name = entry.name;
        return name.substr(0, name.find(char(MURK_VDB_SEPARATOR))) == "radiosity";
    }

    /* "Tree_float_5_4_3_HalfFloat" is "half". */
    static std::string type_of(const murk_vdb_entry &entry)
    {
        std::string type = entry.type;
        const bool is_half = type.size() > 10 && !type.compare(type.size() - 10, 10, "_HalfFloat");
        if (!type.compare(0, 5, "Tree_"))
            type = type.substr(5, type.find('_', 5) - 5);
        return is_half && type == "float" ? "half" : type;
    }

    murk_context *context_;
    const murk_source &source_;
    murk_vdb &vdb_;
    murk_vdb_header header_{};
    std::deque<murk_vdb_entry> entries_;
    std::set<std::string> names_;
};

} // namespace

murk_status murk_vdb_load(murk_context *context, const murk_source &from, murk_vdb &vdb) noexcept
{
    return murk_guard(context, from.where, [&]() -> murk_status {
        try {
            reader(context, from, vdb).read();
            return MURK_OK;
        } catch (const failure &failed) {
            return failed.status;
        }
    });
}

murk_status murk_vdb_load_grid(murk_context *context, const murk_source &from,
                               openvdb::GridBase::Ptr &out) noexcept
{
    return murk_guard(context, from.where, [&]() -> murk_status {
        try {
            murk_vdb unused;
            out = reader(context, from, unused).read_only_grid();
            return MURK_OK;
        } catch (const failure &failed) {
            return failed.status;
        }
    });
}

void murk_vdb_release(murk_vdb *vdb) noexcept
{
    delete vdb;
}

size_t murk_vdb_count(const murk_vdb *vdb) noexcept
{
    return vdb->items.size();
}

const murk_grid_info *murk_vdb_info(const murk_vdb *vdb, size_t index) noexcept
{
    return &vdb->items[index].info;
}

int murk_vdb_components(const murk_vdb *vdb, size_t index) noexcept
{
    return vdb->items[index].components;
}

const char *murk_vdb_band(const murk_vdb *vdb) noexcept
{
    return vdb->band.c_str();
}

double murk_vdb_asymmetry_of(const murk_vdb *vdb, const char *key) noexcept
{
    const auto found = vdb->asymmetry.find(key);
    return found == vdb->asymmetry.end() ? NAN : found->second;
}

const char *murk_vdb_path(const murk_vdb *vdb) noexcept
{
    return vdb->path.c_str();
}
