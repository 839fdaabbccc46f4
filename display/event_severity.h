#pragma once

#include <cstdint>

namespace terratact {

enum class EventSeverity : std::uint8_t { Note, Warning, Bad };  ///< severity of an event

}  // namespace terratact
