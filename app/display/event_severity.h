#pragma once

#include <cstdint>

namespace terratact {

enum class EventSeverity : std::uint8_t { Note, Warning, Bad };  ///< severity of an event

/// Place that shows the text of an event besides the event list.
enum class EventPlace : std::uint8_t { ListOnly, ExplorationPanel, LinkBanner };

}  // namespace terratact
