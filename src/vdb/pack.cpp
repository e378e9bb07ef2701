/* SPDX-License-Identifier: Apache-2.0 */
/* What is known of the grids of a volume, as bytes between two processes of one program. */
#include "handle.hpp"

#include <cstring>
#include <type_traits>

namespace
{

template <class T> void put(std::string &bytes, const T &value)
{
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

void put_text(std::string &bytes, const std::string &text)
{
    put(bytes, uint64_t(text.size()));
    bytes += text;
}

/* Takes values off the front; all that is beyond the end makes it bad. */
class unpacker
{
  public:
    explicit unpacker(const std::string &bytes) : bytes_(bytes)
    {
    }
    template <class T> void take(T &value)
    {
        const char *from = skip(sizeof value);
        if (from)
            std::memcpy(&value, from, sizeof value);
    }
    void take_text(std::string &text)
    {
        uint64_t size = 0;
        take(size);
        if (const char *from = skip(size))
            text.assign(from, strnlen(from, size));
    }
    bool is_good() const
    {
        return good_;
    }

  private:
    const char *skip(uint64_t size)
    {
        good_ = good_ && size <= bytes_.size() - at_;
        const char *from = good_ ? bytes_.data() + at_ : nullptr;
        at_ += good_ ? size : 0;
        return from;
    }

    const std::string &bytes_;
    uint64_t at_ = 0;
    bool good_ = true;
};

} // namespace

std::string murk_vdb_pack(const murk_vdb &vdb)
{
    std::string bytes;
    put_text(bytes, vdb.band);
    put(bytes, uint64_t(vdb.asymmetry.size()));
    for (const auto &[key, number] : vdb.asymmetry) {
        put_text(bytes, key);
        put(bytes, number);
    }
    put(bytes, uint64_t(vdb.items.size()));
    for (const murk_vdb_item &item : vdb.items) {
        put(bytes, item.info);
        put(bytes, int32_t(item.info.readable));
        put(bytes, int32_t(item.components));
        for (const std::string *text : {&item.name, &item.type, &item.grid_class, &item.unreadable})
            put_text(bytes, *text);
    }
    return bytes;
}

bool murk_vdb_unpack(const std::string &bytes, murk_vdb &vdb)
{
    unpacker from(bytes);
    uint64_t count = 0;
    from.take_text(vdb.band);
    from.take(count);
    for (; count && from.is_good(); count--) {
        std::string key;
        double number = 0;
        from.take_text(key);
        from.take(number);
        vdb.asymmetry[key] = number;
    }
    from.take(count);
    for (; count && from.is_good(); count--) {
        murk_vdb_item &item = vdb.items.emplace_back();
        int32_t readable = 0, components = 0;
        from.take(item.info);
        from.take(readable);
        from.take(components);
        for (std::string *text : {&item.name, &item.type, &item.grid_class, &item.unreadable})
            from.take_text(*text);
        item.components = components == 1 || components == 3 ? components : 0;
        item.info.readable = readable && item.components;
        item.point();
    }
    return from.is_good();
}
