#include "core/clouds/cloud_value.h"

#include <stdexcept>

#include "core/bags/byte_cursor.h"

namespace terratact {

std::optional<CloudNumber> cloudNumber(CloudNumber::Kind kind, std::size_t size)
{
    const bool isWhole = kind != CloudNumber::Kind::Float && (size == 1 || size == 2);
    if (!isWhole && size != 4 && size != 8) return std::nullopt;
    return CloudNumber{kind, size};
}

double cloudValue(const CloudNumber& number, std::string_view bytes, bool bigEndian)
{
    if (bytes.size() < number.size) throw std::invalid_argument("cloudValue: too few bytes");
    ByteCursor cursor(bytes.substr(0, number.size), bigEndian);
    using Kind = CloudNumber::Kind;
    const auto chosen = [&](auto one, auto two, auto four, auto eight) {
        switch (number.size) {
        case 1: return static_cast<double>(cursor.number<decltype(one)>());
        case 2: return static_cast<double>(cursor.number<decltype(two)>());
        case 4: return static_cast<double>(cursor.number<decltype(four)>());
        default: return static_cast<double>(cursor.number<decltype(eight)>());
        }
    };
    switch (number.kind) {
    case Kind::Signed: return chosen(std::int8_t{}, std::int16_t{}, std::int32_t{}, std::int64_t{});
    case Kind::Unsigned:
        return chosen(std::uint8_t{}, std::uint16_t{}, std::uint32_t{}, std::uint64_t{});
    case Kind::Float: break;
    }
    return number.size == 4 ? static_cast<double>(cursor.number<float>()) : cursor.number<double>();
}

}  // namespace terratact
