#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace terratact {

inline constexpr std::size_t kClassicBytes = 8;  ///< most data bytes of a classic frame
inline constexpr std::size_t kFdBytes = 64;      ///< most data bytes of a CAN FD frame

/// A frame as a CAN controller delivers it; drivers convert the socket's own layout.
struct CanFrame {
    std::uint32_t id = 0;  ///< without flags: 11 bits, or 29 if `extended`
    bool extended = false;
    bool remote = false;
    bool error = false;       ///< error frame of the controller: `id` is its error class
    bool fd = false;          ///< CAN FD; `length` may be up to 64
    std::uint8_t length = 0;  ///< number of data bytes
    std::array<std::uint8_t, kFdBytes> data{};
    /// True if only the first eight of more data bytes are known, as in older sessions.
    bool isCut = false;
    bool operator==(const CanFrame&) const = default;
};

/// Returns the known data bytes; none for a remote frame.
inline std::span<const std::uint8_t> bytesOf(const CanFrame& frame)
{
    if (frame.remote) return {};
    const std::size_t most = frame.isCut ? kClassicBytes : kFdBytes;
    return std::span(frame.data).first(std::min<std::size_t>(frame.length, most));
}

}  // namespace terratact
