#pragma once

#include <cstdint>

namespace terratact {

enum class Weight : std::uint8_t { Note, Doubt, Bad };  ///< severity of an event

}  // namespace terratact
