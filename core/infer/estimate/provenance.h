#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/infer/estimate/estimate.h"

namespace terratact {

/// Evidence for a bin's height, the strongest first.
enum class Provenance : std::uint8_t {
    Arm,      ///< the arm touched it
    Contact,  ///< a force element feels it
    /// sampled; the robot's lower edge touches it: the ceiling is within kTouching of q90
    Constrained,
    Sampled,   ///< sampled, with part of the robot above it
    PriorOnly  ///< only the training set, see TerrainEstimate::priorOnly
};
inline constexpr std::array kProvenances{Provenance::Arm, Provenance::Contact,
                                         Provenance::Constrained, Provenance::Sampled,
                                         Provenance::PriorOnly};

/// Largest distance of ceiling and q90 for Constrained [m].
inline constexpr double kTouching = 0.010;

/// Returns the evidence for one bin. bin: 0 … 10.
Provenance provenance(const TerrainEstimate& estimate, int bin);

/// Returns "arm", "contact", "constrained", "sampled" or "prior only".
std::string_view name(Provenance provenance);

/// Line pattern of an uncertainty bar, on screens and in figures. No two are alike, so that they
/// differ without colours.
struct BarPattern {
    double width = 0.0;            ///< width [px] at 100 %
    std::vector<double> dashes{};  ///< lengths on, off, … in widths; empty: solid
};
/// Returns wide, solid, dash-dot, dashed or dotted for the five values, in their order.
BarPattern barPattern(Provenance provenance);

/// Fill of a bin's mark, on screens and in figures.
enum class MarkFill : std::uint8_t { Open, LowerHalf, Full };
/// Returns how much of a bin was felt: Full if felt or remembered, LowerHalf if felt in part, else Open. Full where a
/// recording does not state it. A bin that is PriorOnly is always Open.
MarkFill markFill(const TerrainEstimate& estimate, int bin);

}  // namespace terratact
