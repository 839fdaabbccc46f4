#pragma once

#include <cstdint>

namespace terratact {

/// Sides of a two-track estimate that a picture shows.
enum class ShownSides : std::uint8_t { Both, Left, Right };

}  // namespace terratact
