#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace terratact {

/// Reads numbers and texts from bytes. A read beyond the end returns 0 or an empty text, and from then
/// on isValid() is false.
class ByteCursor {
public:
    explicit ByteCursor(std::string_view bytes, bool bigEndian = false)
        : bytes_(bytes), swap_(bigEndian == (std::endian::native == std::endian::little))
    {
    }

    bool isValid() const { return valid_; }
    bool atEnd() const { return at_ == bytes_.size(); }
    std::size_t at() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }

    template <class T>
    T number()
    {
        static_assert(std::is_arithmetic_v<T>);
        std::array<char, sizeof(T)> raw{};
        const std::string_view part = bytes(sizeof(T));
        if (part.empty()) return T{};
        std::copy(part.begin(), part.end(), raw.begin());
        if (swap_) std::reverse(raw.begin(), raw.end());
        T value{};
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }

    /// Returns the next `count` bytes.
    std::string_view bytes(std::uint64_t count)
    {
        if (count > left()) {
            valid_ = false;
            at_ = bytes_.size();
            return {};
        }
        const std::string_view part = bytes_.substr(at_, static_cast<std::size_t>(count));
        at_ += part.size();
        return part;
    }

    /// Returns a text behind its length of 32 bits.
    std::string_view text() { return bytes(number<std::uint32_t>()); }

private:
    std::string_view bytes_;
    bool swap_ = false;
    std::size_t at_ = 0;
    bool valid_ = true;
};

}  // namespace terratact
