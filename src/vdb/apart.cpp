/* SPDX-License-Identifier: Apache-2.0 */
/* A volume in this process: what is known of its grids, and a child that has them. */
#include "guard.hpp"
#include "handle.hpp"
#include "memory.h"

#include <algorithm>
#include <cstring>
#include <unistd.h>

namespace
{

/* A kilobyte of file is at most 8 leaves, or of the widest values 100 kilobytes of memory; tiles
   that are counted by columns may take more. */
constexpr uint64_t memory_per_byte = 100, memory_of_tiles = uint64_t(4) << 30;

/* What OpenVDB and its threads have by themselves: it does not count as the work's. */
constexpr uint64_t memory_of_library = uint64_t(256) << 20;

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

struct answer : murk_apart_answer {
    answer() : murk_apart_answer{-1, 0, 0}
    {
    }
    ~answer()
    {
        if (file >= 0)
            murk_apart_close(this);
    }
    answer(const answer &) = delete;
    answer &operator=(const answer &) = delete;
};

/* What a sound file can take, where the machine has that much and the memory limit allows it. */
murk_apart_limits find_limits(uint64_t size, bool &is_memory_ours)
{
    const uint64_t machine = uint64_t(sysconf(_SC_PHYS_PAGES)) * uint64_t(sysconf(_SC_PAGESIZE));
    const uint64_t left = murk_memory_left();
    const uint64_t there = left < machine ? std::min(machine, left + memory_of_library) : machine;
    const uint64_t sound = memory_of_tiles + memory_per_byte * size;
    is_memory_ours = sound <= there;
    return {std::min(sound, there), 120 + size / 1000000, 600};
}

murk_status ask(murk_context *context, const murk_vdb &vdb, murk_vdb_question what, size_t index,
                int component, answer &out)
{
    const murk_apart_question question = {{uint64_t(what), index, uint64_t(component)}};
    return murk_apart_ask(context, vdb.child, &question, &out);
}

/* Memory is damaged there, or this is a bug. */
murk_status refuse(murk_context *context, const murk_vdb &vdb)
{
    return murk_fail(context, MURK_ERROR_INPUT,
                     "%s: OpenVDB went astray on it; the file is damaged: write or copy it again",
                     vdb.path.c_str());
}

bool take_bricks(murk_apart_answer &from, murk_bricks &bricks)
{
    constexpr size_t each =
        sizeof *bricks.brick + sizeof *bricks.mask + MURK_BRICK_SLOTS * sizeof *bricks.values;
    murk_vdb_brick_header header;
    if (!murk_apart_take(&from, &header, sizeof header) ||
        header.count != (from.size - from.taken) / each)
        return false;
    const size_t count = bricks.count = header.count;
    bricks.background = float(header.background);
    bricks.values =
        static_cast<float *>(murk_alloc_unset(count * MURK_BRICK_SLOTS, sizeof *bricks.values));
    bricks.mask = static_cast<uint64_t(*)[8]>(murk_alloc_unset(count, sizeof *bricks.mask));
    bricks.brick = static_cast<int32_t(*)[3]>(murk_alloc_unset(count, sizeof *bricks.brick));
    if (!bricks.values || !bricks.mask || !bricks.brick)
        throw std::bad_alloc();
    return murk_apart_take(&from, bricks.values,
                           count * MURK_BRICK_SLOTS * sizeof *bricks.values) &&
           murk_apart_take(&from, bricks.mask, count * sizeof *bricks.mask) &&
           murk_apart_take(&from, bricks.brick, count * sizeof *bricks.brick);
}

/* Others search them by their order and count with their indices. */
bool are_sound(const murk_bricks &bricks)
{
    constexpr int32_t limit = 1 << 28;
    for (size_t b = 0; b < bricks.count; b++) {
        for (int32_t index : bricks.brick[b])
            if (index < -limit || index > limit)
                return false;
        if (b && murk_brick_compare(bricks.brick[b - 1], bricks.brick[b]) >= 0)
            return false;
    }
    return true;
}

} // namespace

murk_status murk_vdb_read(murk_context *context, const char *path, murk_vdb **out) noexcept
{
    return murk_guard(context, murk_source_name(path), [&]() -> murk_status {
        source from;
        answer infos;
        if (const murk_status status = murk_source_open(context, path, &from))
            return status;
        std::unique_ptr<murk_vdb> vdb(new murk_vdb);
        vdb->path = from.where;
        murk_vdb_job job = {&from, vdb.get(), false};
        const murk_apart_work work = {"OpenVDB",      vdb->path.c_str(),
                                      murk_vdb_serve, &job,
                                      from.file,      find_limits(from.size, job.is_memory_ours)};
        murk_status status = murk_apart_start(context, &work, &vdb->child);
        if (!status)
            status = ask(context, *vdb, MURK_VDB_READ, 0, 0, infos);
        if (status)
            return status;
        std::string bytes(infos.size, 0);
        if (!murk_apart_take(&infos, &bytes[0], bytes.size()) || !murk_vdb_unpack(bytes, *vdb))
            return refuse(context, *vdb);
        *out = vdb.release();
        return MURK_OK;
    });
}

murk_status murk_vdb_bricks(murk_context *context, const murk_vdb *vdb, size_t index, int component,
                            murk_bricks *out) noexcept
{
    murk_bricks bricks{};
    const murk_status status = murk_guard(context, vdb->path.c_str(), [&]() -> murk_status {
        const murk_vdb_item &item = vdb->items[index];
        answer from;
        if (!item.components)
            return murk_fail(context, MURK_ERROR_INPUT, "%s, grid %s: cannot be used: %s",
                             vdb->path.c_str(), item.name.c_str(), item.unreadable.c_str());
        if (const murk_status failed = ask(context, *vdb, MURK_VDB_BRICKS, index, component, from))
            return failed;
        if (!take_bricks(from, bricks) || !are_sound(bricks))
            return refuse(context, *vdb);
        std::memcpy(bricks.index_to_world, item.info.index_to_world, sizeof bricks.index_to_world);
        return MURK_OK;
    });
    if (status)
        murk_bricks_clear(&bricks);
    else
        *out = bricks;
    return status;
}

murk_status murk_vdb_fetch(murk_context *context, const murk_vdb &vdb, size_t index,
                           openvdb::GridBase::Ptr &out)
{
    answer from;
    if (const murk_status status = ask(context, vdb, MURK_VDB_GRID, index, 0, from))
        return status;
    return murk_vdb_load_grid(context, {vdb.path.c_str(), from.file, nullptr, from.size}, out);
}
