/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Reads the grids of a file or stream one by one. Each is given to OpenVDB as a stream of its own,
 * made of the file's checked header and that grid's bytes alone, which throws at its end: a damaged
 * grid can neither read nor seek beyond itself, and the others stay readable.
 */
#include "vdb.h"

#include "check.h"
#include "guard.hpp"
#include "handle.hpp"
#include "segments.hpp"

#include <istream>
#include <memory>
#include <openvdb/io/Stream.h>
#include <set>
#include <vector>

namespace
{

struct source : murk_source {
    source() : murk_source{nullptr, -1, nullptr, 0}
    {
    }
    ~source()
    {
        murk_source_close(this);
    }
    source(const source &) = delete;
    source &operator=(const source &) = delete;
};

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
    bytes(murk_context *context, const source &from, uint64_t start, uint64_t end)
        : data_(from.memory ? from.memory + start : nullptr), size_(end - start)
    {
        if (from.memory)
            return;
        copy_.reset(new char[size_]);
        check(murk_source_read(context, &from, start, copy_.get(), size_));
        data_ = copy_.get();
    }
    void add_to(murk_segments &stream) const
    {
        stream.add(data_, size_);
    }

  private:
    std::unique_ptr<char[]> copy_;
    const void *data_;
    uint64_t size_;
};

class reader
{
  public:
    reader(murk_context *context, source &from, murk_vdb &vdb)
        : context_(context), source_(from), vdb_(vdb)
    {
        check(murk_vdb_check(context, &from, &header_));
        /* A file's offsets are checked to the last before anything is read. */
        uint64_t start = header_.first;
        for (uint32_t i = 0; header_.has_offsets && i < header_.grid_count; i++) {
            entries_.emplace_back();
            check(murk_vdb_check_entry(context, &from, &header_, start, &entries_.back()));
            start = entries_.back().end;
        }
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
        }
    }

  private:
    void read_grid(murk_vdb_entry &entry)
    {
        murk_vdb_item &item = vdb_.items.emplace_back();
        item.name = entry.label;
        for (int n = 1; !names_.insert(item.name).second; n++)
            item.name = std::string(entry.label) + "[" + std::to_string(n) + "]";
        openvdb::GridBase::Ptr grid;
        try {
            grid = load(entry);
        } catch (const failure &) {
            throw;
        } catch (const std::bad_alloc &) {
            throw;
        } catch (const std::ios_base::failure &) {
            refuse(entry, item, "its data end too early or are damaged");
        } catch (const std::exception &error) {
            refuse(entry, item, murk_reason(error));
        }
        if (grid)
            murk_vdb_describe(*grid, item);
        item.info.name = item.name.c_str();
        item.info.type = item.type.c_str();
        item.info.grid_class = item.grid_class.c_str();
        item.info.unreadable = item.info.readable ? nullptr : item.unreadable.c_str();
        if (item.info.readable)
            item.grid = grid;
    }

    openvdb::GridBase::Ptr load(murk_vdb_entry &entry)
    {
        static const unsigned char no_metadata[4] = {0}, one[4] = {1}, two[4] = {2};
        const murk_vdb_entry *parent = find_parent(entry);
        const bytes prefix(context_, source_, 0, header_.prefix);
        murk_segments stream;
        prefix.add_to(stream);
        stream.add(no_metadata, 4);
        stream.add(parent ? two : one, 4);
        std::unique_ptr<bytes> shared;
        uint64_t before = header_.prefix + 8;
        if (parent) {
            shared.reset(new bytes(context_, source_, parent->start, parent->end));
            shared->add_to(stream);
            before += parent->end - parent->start;
        }
        const uint64_t end = entry.end ? entry.end : source_.size;
        const bytes own(context_, source_, entry.start, end);
        own.add_to(stream);

        std::istream input(&stream);
        input.exceptions(std::ios::failbit | std::ios::badbit);
        openvdb::io::Stream archive(input, false);
        if (!entry.end)
            entry.end = entry.start + (stream.position() - before);
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
        if (!entry.end) /* where the next grid starts is unknown, too */
            throw failure{murk_fail(context_, MURK_ERROR_INPUT,
                                    "%s, grid %s: cannot be read: %s; write the stream again",
                                    source_.where, item.name.c_str(), reason.c_str())};
        item.type = entry.type;
        item.grid_class = "unknown";
        item.unreadable = reason;
    }

    murk_context *context_;
    const source &source_;
    murk_vdb &vdb_;
    murk_vdb_header header_{};
    std::deque<murk_vdb_entry> entries_;
    std::set<std::string> names_;
};

} // namespace

murk_status murk_vdb_read(murk_context *context, const char *path, murk_vdb **out) noexcept
{
    return murk_guard(context, murk_source_name(path), [&]() -> murk_status {
        try {
            source from;
            check(murk_source_open(context, path, &from));
            std::unique_ptr<murk_vdb> vdb(new murk_vdb);
            vdb->path = from.where;
            reader(context, from, *vdb).read();
            *out = vdb.release();
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

const char *murk_vdb_path(const murk_vdb *vdb) noexcept
{
    return vdb->path.c_str();
}
