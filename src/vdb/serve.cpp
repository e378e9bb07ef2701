/* SPDX-License-Identifier: Apache-2.0 */
/* The process that reads a volume and keeps its grids: the only one that gives foreign bytes to
   OpenVDB. Its threads stayed behind, so nothing here may call on TBB. */
#include "descriptor.hpp"
#include "guard.hpp"
#include "handle.hpp"
#include "memory.h"

#include <cinttypes>
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <ostream>
#include <sys/mman.h>
#include <unistd.h>

namespace
{

/* A file in memory, as memory. */
class mapping
{
  public:
    mapping(int file, size_t size) : size_(size)
    {
        if (ftruncate(file, off_t(size)))
            throw std::bad_alloc();
        bytes_ = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (bytes_ == MAP_FAILED)
            throw std::bad_alloc();
    }
    ~mapping()
    {
        munmap(bytes_, size_);
    }
    mapping(const mapping &) = delete;
    mapping &operator=(const mapping &) = delete;
    char *bytes() const
    {
        return static_cast<char *>(bytes_);
    }

  private:
    void *bytes_;
    size_t size_;
};

void put_bytes(int file, const std::string &bytes)
{
    murk_descriptor descriptor(file);
    std::ostream output(&descriptor);
    output.exceptions(std::ios::failbit | std::ios::badbit);
    output.write(bytes.data(), std::streamsize(bytes.size()));
    output.flush();
}

murk_status read(murk_context *context, const murk_vdb_job &job, int file)
{
    const murk_status status = murk_vdb_load(context, *job.from, *job.vdb);
    if (status == MURK_ERROR_MEMORY && job.is_memory_ours)
        return murk_fail(context, MURK_ERROR_INPUT,
                         "%s: takes more memory than a sound file of %" PRIu64
                         " bytes can; it is damaged: write or copy it again",
                         job.vdb->path.c_str(), job.from->size);
    murk_source_close(job.from);
    if (!status)
        put_bytes(file, murk_vdb_pack(*job.vdb));
    return status;
}

murk_status put_bricks(murk_context *context, const murk_vdb &vdb, const murk_vdb_item &item,
                       int component, int file)
{
    std::unique_ptr<mapping> memory;
    murk_bricks bricks{};
    const std::string what = vdb.path + ", grid " + item.name + ": reading";
    /* Values first: they are aligned by the header in front. */
    const auto allocate = [&](murk_bricks &b) {
        const size_t values = b.count * MURK_BRICK_SLOTS * sizeof *b.values;
        const size_t masks = b.count * sizeof *b.mask;
        const size_t size = values + masks + b.count * sizeof *b.brick;
        /* Here and once more in the process that asked. */
        if (const murk_status status = murk_memory_check(context, what.c_str(), 2 * size))
            return status;
        memory.reset(new mapping(file, sizeof(murk_vdb_brick_header) + size));
        char *at = memory->bytes() + sizeof(murk_vdb_brick_header);
        b.values = reinterpret_cast<float *>(at);
        b.mask = reinterpret_cast<uint64_t(*)[8]>(at += values);
        b.brick = reinterpret_cast<int32_t(*)[3]>(at + masks);
        return MURK_OK;
    };
    if (const murk_status status = murk_vdb_copy(item, component, allocate, bricks))
        return status;
    *reinterpret_cast<murk_vdb_brick_header *>(memory->bytes()) = {bricks.count, bricks.background};
    return MURK_OK;
}

/* A stream of one grid in plain bytes. Archive::write() would have TBB collect metadata first. */
class archive : public openvdb::io::Archive
{
  public:
    void put(std::ostream &output, const openvdb::GridBase &grid)
    {
        const int32_t count = 1;
        setCompression(openvdb::io::COMPRESS_NONE);
        writeHeader(output, false);
        openvdb::MetaMap().writeMeta(output);
        output.write(reinterpret_cast<const char *>(&count), sizeof count);
        const openvdb::io::GridDescriptor descriptor(grid.getName(), grid.type(),
                                                     grid.saveFloatAsHalf());
        descriptor.writeHeader(output);
        descriptor.writeStreamPos(output);
        setGridCompression(output, grid);
        grid.writeMeta(output);
        grid.writeTransform(output);
        grid.writeTopology(output);
        grid.writeBuffers(output);
    }
};

murk_status put_grid(const murk_vdb_item &item, int file)
{
    murk_descriptor descriptor(file);
    std::ostream output(&descriptor);
    output.exceptions(std::ios::failbit | std::ios::badbit);
    archive().put(output, *item.grid);
    output.flush();
    return MURK_OK;
}

murk_status answer(murk_context *context, const murk_vdb_job &job,
                   const murk_apart_question &question, int file)
{
    if (question.word[0] == MURK_VDB_READ)
        return read(context, job, file);
    const murk_vdb_item &item = job.vdb->items[question.word[1]];
    return question.word[0] == MURK_VDB_BRICKS
               ? put_bricks(context, *job.vdb, item, int(question.word[2]), file)
               : put_grid(item, file);
}

} // namespace

murk_status murk_vdb_serve(murk_context *context, void *data, const murk_apart_question *question,
                           int file)
{
    const murk_vdb_job &job = *static_cast<murk_vdb_job *>(data);
    return murk_guard(context, job.vdb->path.c_str(),
                      [&] { return answer(context, job, *question, file); });
}
