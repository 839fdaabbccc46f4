#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace terratact {

inline constexpr std::size_t kClassicBytes = 8;  ///< of data at most, in a classic frame
inline constexpr std::size_t kFdBytes = 64;      ///< and in one of CAN FD

/// What a CAN controller delivers, as plain values; the socket's own layout belongs to drivers.
struct CanFrame {
    std::uint32_t id = 0;  ///< without flags: 11 bits, or 29 where `extended`
    bool extended = false;
    bool remote = false;
    bool error = false;       ///< an error frame of the controller: `id` is then its error class
    bool fd = false;          ///< CAN FD; `length` may be up to 64
    std::uint8_t length = 0;  ///< bytes of data
    std::array<std::uint8_t, kFdBytes> data{};
    /// Of more than eight bytes only the first eight are known: older sessions kept no more.
    bool isCut = false;
    bool operator==(const CanFrame&) const = default;
};

/// The bytes of data that are known; none of a remote frame.
inline std::span<const std::uint8_t> bytesOf(const CanFrame& frame)
{
    if (frame.remote) return {};
    const std::size_t most = frame.isCut ? kClassicBytes : kFdBytes;
    return std::span(frame.data).first(std::min<std::size_t>(frame.length, most));
}

}  // namespace terratact
