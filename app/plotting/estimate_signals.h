#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/plotting/plot_signal.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/terrain/bins.h"

namespace terratact {

/// An estimate with what is known about it. The references must outlive the object.
struct EstimateFacts {
    const TwoTrackEstimate& estimate;
    std::optional<TwoTrackVerdict> verdict{};       ///< empty: it has no draws
    std::array<std::optional<Heights>, 2> truth{};  ///< left, right; empty: not known
    double seconds = 0.0;                           ///< [s] computing time
};

/// Returns the true heights of both sides for an estimate. plane: of the scene's one plane. sides: of both sides.
std::array<std::optional<Heights>, 2> truthOf(bool onePlane, const std::optional<Heights>& plane,
                                              const std::optional<std::array<Heights, 2>>& sides);

/// Returns the signals of an estimate: P(step), standard deviations, errors where the truth is known, the height of
/// each bin. Their order is fixed.
std::span<const PlotSignal> estimateSignals();

/// Returns the values of estimateSignals(); empty ones are not known.
std::vector<std::optional<double>> estimateValues(const EstimateFacts& facts);

}  // namespace terratact
