/* SPDX-License-Identifier: Apache-2.0 */
/* A stream buffer over a file descriptor that keeps the system's reason of a failed write. */
#ifndef MURK_VDB_DESCRIPTOR_HPP
#define MURK_VDB_DESCRIPTOR_HPP

#include <cerrno>
#include <streambuf>
#include <unistd.h>
#include <vector>

class murk_descriptor : public std::streambuf
{
  public:
    explicit murk_descriptor(int file) : file_(file), buffer_(1 << 16)
    {
        setp(buffer_.data(), buffer_.data() + buffer_.size());
    }

    int error() const
    {
        return error_;
    }

  protected:
    int_type overflow(int_type next) override
    {
        if (sync())
            return traits_type::eof();
        if (!traits_type::eq_int_type(next, traits_type::eof()))
            sputc(traits_type::to_char_type(next));
        return traits_type::not_eof(next);
    }

    int sync() override
    {
        for (const char *at = pbase(); at < pptr();) {
            const ssize_t written = ::write(file_, at, size_t(pptr() - at));
            if (written < 0 && errno == EINTR)
                continue;
            if (written < 0) {
                error_ = errno;
                return -1;
            }
            at += written;
        }
        setp(buffer_.data(), buffer_.data() + buffer_.size());
        return 0;
    }

    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
    {
        const bool asks = offset == 0 && from == std::ios_base::cur;
        const off_type pending = pptr() - pbase();
        if (!asks && sync())
            return pos_type(off_type(-1));
        const int whence = from == std::ios_base::beg   ? SEEK_SET
                           : from == std::ios_base::cur ? SEEK_CUR
                                                        : SEEK_END;
        const off_t at = ::lseek(file_, off_t(offset), whence);
        return pos_type(at < 0 ? off_type(-1) : off_type(at) + (asks ? pending : 0));
    }

    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
    {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }

  private:
    int file_;
    int error_ = 0;
    std::vector<char> buffer_;
};

#endif
