#pragma once

#include <cstddef>
#include <cstdint>

#include "core/wire/can_frame.h"

namespace terratact {

/// Fault of a frame, for counters.
enum class FrameTrouble : std::uint8_t {
    None,
    Gap,            ///< valid, but others are missing before it
    WrongChecksum,  ///< damaged
    WrongSequence,  ///< repeated, or an old one
    Other,          ///< no data frame, or meaningless bits
    Unknown,        ///< not a frame of this protocol
};
inline constexpr std::size_t kFrameTroubles = 6;

/// One of the latest frames of a bus.
struct TracedFrame {
    std::uint64_t number = 0;  ///< 1 for the first since the bus was opened
    double time = 0.0;         ///< on the bus's clock [s]
    CanFrame frame{};
    bool echo = false;  ///< this console sent it
    FrameTrouble trouble = FrameTrouble::None;
};

}  // namespace terratact
