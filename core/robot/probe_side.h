#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace terratact {

/// Ground that the arm touches at a bin: the line of one side (sideHeights(),
/// core/terrain/ground_lines.h), or the middle between both sides.
enum class ProbeSide : std::uint8_t { Middle, Left, Right };

/// Returns "middle", "left" or "right".
std::string_view name(ProbeSide side);
std::optional<ProbeSide> probeSideFromName(std::string_view text);

/// Place that the arm may touch. bin: 0 … 10, see core/terrain/bins.h.
struct ProbePlace {
    int bin = 0;
    ProbeSide side = ProbeSide::Middle;
    bool operator==(const ProbePlace&) const = default;
};

}  // namespace terratact
