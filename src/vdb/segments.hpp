/* SPDX-License-Identifier: Apache-2.0 */
/* Pieces of memory that read as one stream and end where the last one ends. */
#ifndef MURK_VDB_SEGMENTS_HPP
#define MURK_VDB_SEGMENTS_HPP

#include <cstdint>
#include <streambuf>
#include <vector>

class murk_segments : public std::streambuf
{
  public:
    void add(const void *bytes, uint64_t size)
    {
        char *begin = const_cast<char *>(static_cast<const char *>(bytes));
        if (size)
            pieces_.push_back({begin, begin + size, size_});
        size_ += size;
        open(0);
    }

  protected:
    int_type underflow() override
    {
        while (gptr() == egptr() && next_ < pieces_.size())
            open(next_);
        return gptr() == egptr() ? traits_type::eof() : traits_type::to_int_type(*gptr());
    }

    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
    {
        off_type base = from == std::ios_base::beg   ? 0
                        : from == std::ios_base::cur ? off_type(position())
                                                     : off_type(size_);
        if (offset < -base || uint64_t(base + offset) > size_)
            return pos_type(off_type(-1));
        const uint64_t target = uint64_t(base + offset);
        for (size_t i = pieces_.size(); i-- > 0;)
            if (target >= pieces_[i].offset) {
                open(i);
                gbump_far(target - pieces_[i].offset);
                break;
            }
        return pos_type(off_type(target));
    }

    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
    {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }

  private:
    uint64_t position() const
    {
        return next_ ? pieces_[next_ - 1].offset + uint64_t(gptr() - eback()) : 0;
    }

    struct piece {
        char *begin, *end;
        uint64_t offset;
    };

    void open(size_t index)
    {
        if (index >= pieces_.size())
            return;
        setg(pieces_[index].begin, pieces_[index].begin, pieces_[index].end);
        next_ = index + 1;
    }

    /* gbump() takes an int only. */
    void gbump_far(uint64_t distance)
    {
        setg(eback(), gptr() + distance, egptr());
    }

    std::vector<piece> pieces_;
    size_t next_ = 0;
    uint64_t size_ = 0;
};

#endif
