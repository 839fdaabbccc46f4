#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Largest plausible current of a scene [A].
inline constexpr double kMaxSceneCurrent = 100.0;

/// Column of a scenes file: its name, and the range of plausible values.
struct Column {
    std::string_view name;
    std::string_view unit;
    double least, most;  ///< both ends belong to the range
    SourceText doubt;    ///< likely cause of a value beyond the range

    bool holds(double value) const { return value >= least && value <= most; }
    /// Returns why a value beyond the range is refused.
    Message refusal(double value) const;
};

/// Returns the features of s in order: pitch, flipper angles, currents, forces.
std::span<const Column, kFeatures> featureColumns();

/// Features of one s in that order. The first three, pitch and the flipper angles, are never empty.
using FeatureValues = std::array<std::optional<double>, kFeatures>;
FeatureValues featureValues(const Proprioception& s);

/// Returns s from its features. Throws std::invalid_argument if one of the first three is empty.
Proprioception proprioception(const FeatureValues& values);

/// Returns the columns of the heights, rear to front.
std::span<const Column, kBins> heightColumns();

/// Returns the columns of the heights' sd, rear to front.
std::span<const Column, kBins> heightSdColumns();

}  // namespace terratact
