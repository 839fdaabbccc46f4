#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace terratact {

/// Bytes for hashing that do not depend on the machine. A number is 8 bytes, least significant
/// first. A text follows its length.
class CanonicalBytes {
public:
    void add(std::uint64_t value)
    {
        for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 becomes 0
    void add(std::string_view text)
    {
        add(std::uint64_t{text.size()});
        bytes_ += text;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

}  // namespace terratact
