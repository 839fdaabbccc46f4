#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"

namespace terratact {

/// Plays samples, one channel, `rate` of them a second, on a device of ALSA ("default": the system's), and returns once
/// they were heard; which takes as long as they are, and a second longer where the device hangs.  Error: there is no
/// such device, it is taken, or it took no samples.
Status playAudio(const std::string& device, std::span<const std::int16_t> samples, unsigned rate);

}  // namespace terratact
