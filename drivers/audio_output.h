#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.h"

namespace terratact {

/// Plays mono samples, `rate` per second, on an ALSA device ("default": the system's). Returns once
/// they were played, or a second later if the device hangs. Error: the device does not exist, is in
/// use, or accepted no samples.
Status playAudio(const std::string& device, std::span<const std::int16_t> samples, unsigned rate);

}  // namespace terratact
