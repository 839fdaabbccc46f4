#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace terratact {

/// Number in the bytes of a cloud.
struct CloudNumber {
    enum class Kind : std::uint8_t { Signed, Unsigned, Float };
    Kind kind = Kind::Float;
    std::size_t size = 4;  ///< [bytes] 1, 2, 4 or 8; a Float has 4 or 8
    bool operator==(const CloudNumber&) const = default;
};

/// Returns the number of a kind and size; empty if there is none: a float of 2 bytes, 3 bytes.
std::optional<CloudNumber> cloudNumber(CloudNumber::Kind kind, std::size_t size);

/// Returns the value of the first bytes. Throws std::invalid_argument if there are fewer than its size.
double cloudValue(const CloudNumber& number, std::string_view bytes, bool bigEndian = false);

}  // namespace terratact
