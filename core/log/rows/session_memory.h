#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/trail/trail_history.h"

namespace terratact {

// The memory of a scene as a session stores it in `scene.memory`: 202 doubles of 8 bytes, least
// significant byte first. They are the way, the number of presses, 10 pitches, 10 rolls, and per
// plane (middle, left, right): 9 lowest heights, 9 loads, 9 pressed heights. Of each plane follow
// 11 felt cells, 11 heights of the arm, and their 11 sd. Older memories end before these: nothing
// was felt.

/// Returns the bytes of a memory.
std::string bytesOfMemory(const TrailHistory& memory);

/// Returns the memory; empty for another number of bytes, or for numbers that no memory has. All
/// numbers are finite but for `lowest`, which may be +infinity.
std::optional<TrailHistory> memoryFrom(std::string_view bytes);

}  // namespace terratact
