#pragma once

#include <optional>

#include "core/atem/atem_machine.h"
#include "core/robot/measurement.h"

namespace terratact {

/// What a console that sends nothing saw since the last tick.
struct FollowInput {
    double now = 0.0;                                ///< [s] any monotonic clock
    RobotActivity activity = RobotActivity::Halted;  ///< of the newest telemetry
    bool linkLost = false;    ///< no telemetry, though there should be: not after the end of a log
    bool aborted = false;     ///< the operator takes the result off the screen
    bool newPress = false;    ///< the flippers are pressed, and no scene of this press was captured
    bool newReading = false;  ///< the arm has measured at the captured pose
    bool poseChanged = false;  ///< robot moved since the scene was captured
    bool estimateReady = false;
    bool estimateFailed = false;
};

/// Algorithm 1 as the robot does it for somebody else, told by its telemetry alone: the same phases, with
/// AtemState::followed, but nobody asks, approves or waits for the robot here.
///
///   Idle ─▶ Pressing ─▶ Estimating ─▶ Presenting ◀──▶ Probing
///    ▲    pressing  newPress    estimateReady ▲ │ newReading  │ newReading
///    │ poseChanged                            │ ▼             ▼
///                                         EstimatingAgain ◀───┘
///   any state: stopped ▶ Stopped, not stopped any more ▶ Idle; aborted ▶ Idle; pressing ▶ Pressing,
///   newPress ▶ Estimating.  A lost link, an error or a time limit of what rests on a scene ▶ Failed.
///
/// A reading that comes while the first estimate runs waits for it.  One tick, no clock, no I/O.
/// Throws std::invalid_argument unless in.now is finite.
AtemState nextFollowed(const AtemState& now, const FollowInput& in, const AtemLimits& limits);

/// In words for the operator: "following: flippers pressed, estimating the terrain".
std::string describeFollowed(AtemPhase phase);

}  // namespace terratact
