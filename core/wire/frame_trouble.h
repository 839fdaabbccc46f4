#pragma once

#include <cstddef>
#include <cstdint>

#include "core/wire/can_frame.h"

namespace terratact {

/// What is wrong with a frame, for counting.
enum class FrameTrouble : std::uint8_t {
    None,
    Gap,            ///< sound, but others are missing before it
    WrongChecksum,  ///< damaged
    WrongSequence,  ///< repeated, or an old one
    Other,          ///< no data frame, or bits that mean nothing
    Unknown,        ///< not of this protocol
};
inline constexpr std::size_t kFrameTroubles = 6;

/// One of the newest frames of a bus.
struct TracedFrame {
    std::uint64_t number = 0;  ///< 1 for the first since the bus was opened
    double time = 0.0;         ///< [s] on the bus's clock
    CanFrame frame{};
    bool echo = false;  ///< left from here
    FrameTrouble trouble = FrameTrouble::None;
};

}  // namespace terratact
