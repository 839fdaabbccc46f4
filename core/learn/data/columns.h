#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// A number of a scene as files call it, and the range in which it is believed.
struct Column {
    std::string_view name;
    std::string_view unit;
    double least, most;      ///< both belong to the range
    std::string_view doubt;  ///< what a value beyond the range suggests

    bool holds(double value) const { return value >= least && value <= most; }
    /// Why a value that it does not hold is refused.
    std::string refusal(double value) const;
};

/// The features of s in order: pitch, flipper angles, currents, forces.
std::span<const Column, kFeatures> featureColumns();

/// Features of one s in that order; the first three, pitch and the flipper angles, are never empty.
using FeatureValues = std::array<std::optional<double>, kFeatures>;
FeatureValues featureValues(const Proprioception& s);

/// The other way round.  Throws std::invalid_argument where one of the first three is empty.
Proprioception proprioception(const FeatureValues& values);

/// The heights, rear to front.
std::span<const Column, kBins> heightColumns();

}  // namespace terratact
