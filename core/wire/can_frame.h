#pragma once

#include <array>
#include <cstdint>

namespace terratact {

/// What a CAN controller delivers, as plain values; the socket's own layout belongs to drivers.
struct CanFrame {
    std::uint32_t id = 0;  ///< without flags: 11 bits, or 29 where `extended`
    bool extended = false;
    bool remote = false;
    bool error = false;       ///< an error frame of the controller: `id` is then its error class
    bool fd = false;          ///< CAN FD; `length` may be up to 64, `data` keeps the first eight
    std::uint8_t length = 0;  ///< bytes of data
    std::array<std::uint8_t, 8> data{};
    bool operator==(const CanFrame&) const = default;
};

}  // namespace terratact
