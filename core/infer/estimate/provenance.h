#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// What speaks for a bin's height, the strongest first.
enum class Provenance : std::uint8_t {
    Arm,      ///< the arm touched it
    Contact,  ///< a force element feels it
    Constrained,  ///< sampled, and the robot's lower edge lies on it: the ceiling is within kTouching of q90
    Sampled,   ///< sampled with part of the robot above it
    PriorOnly  ///< nothing but the training set, see TerrainEstimate::priorOnly
};
inline constexpr std::array kProvenances{Provenance::Arm, Provenance::Contact,
                                         Provenance::Constrained, Provenance::Sampled,
                                         Provenance::PriorOnly};

inline constexpr double kTouching = 0.010;  ///< [m]

/// bin: 0 … 10.
Provenance provenance(const TerrainEstimate& estimate, int bin);

/// "arm", "contact", "constrained", "sampled", "prior only".
std::string_view name(Provenance provenance);

/// How the bar of its band is drawn, on screens as in figures: no two alike, so that they are told apart without colours.
struct BarPattern {
    double width = 0.0;            ///< [px] at 100 %
    std::vector<double> dashes{};  ///< on, off, … in widths; empty: solid
};
/// Wide, solid, dash and dot, dashed, dotted.
BarPattern barPattern(Provenance provenance);

}  // namespace terratact
