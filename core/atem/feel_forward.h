#pragma once

#include <optional>

#include "core/atem/loop_end.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/limits.h"
#include "core/robot/attitude.h"

namespace terratact {

/// Advance of feel forward [m]: the most that the gate passes and the simulated robot accepts.
inline constexpr double kAdvance = kMaxAdvance;

/// Way and time of one feel forward.
struct LoopPace {
    double began = 0.0;             ///< [s]
    std::optional<double> ended{};  ///< [s] empty: feel forward is running
    double way = 0.0;               ///< [m] way of the tracks, by odometry

    /// Returns the pace [m/min] up to its end, or up to `now` [s]; 0 in its first instant.
    double metresPerMinute(double now) const;
};

/// Conditions of an advance at a pose.
struct FeltAhead {
    std::optional<TwoTrackVerdict> verdict;  ///< of the scene at this pose; empty: none
    bool telemetryFresh = false;
    bool odometry = false;  ///< the robot reports the way of its tracks
    AttitudeLevel attitude = AttitudeLevel::Red;
};

/// Returns the ground ahead that CLEAR covers on both sides [m]. It is measured from the front
/// border of the tracks' bins, binBegin(kFirstAhead), to the nearer felt horizon. 0 unless the
/// robot's answer is CLEAR and the touch of both sides is recorded.
double clearWay(const TwoTrackVerdict& verdict);

/// Returns why the robot must not advance by `distance` [m]; None: it may. It may advance only with
/// fresh telemetry and odometry, at a level attitude, and CLEAR for more than the distance. Reasons
/// come in the order of LoopEnd, but attitude and odometry come before the verdict.
LoopEnd whyNotAdvancing(const FeltAhead& ahead, double distance = kAdvance);

}  // namespace terratact
