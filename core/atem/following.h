#pragma once

#include <optional>

#include "core/atem/atem_machine.h"
#include "core/base/message.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Events since the last tick, as a receive-only console receives them.
struct FollowInput {
    double now = 0.0;                                ///< [s] any monotonic clock
    RobotActivity activity = RobotActivity::Halted;  ///< from the newest telemetry
    bool linkLost = false;  ///< telemetry is missing, except after the end of a log
    bool aborted = false;   ///< the operator removes the result from the screen
    /// The flippers are pressed, and no scene of this press is captured yet.
    bool newPress = false;
    bool newReading = false;   ///< the arm has measured at the captured pose
    bool poseChanged = false;  ///< the robot moved since the scene was captured
    bool estimateReady = false;
    bool estimateFailed = false;
};

/// Algorithm 1 as another console commands it, observed through telemetry alone. The phases are the
/// same, with AtemState::followed. This console asks nothing, approves nothing, and does not wait
/// for the robot.
///
///   Idle ─▶ Pressing ─▶ Estimating ─▶ Presenting ◀──▶ Probing
///    ▲    pressing  newPress    estimateReady ▲ │ newReading  │ newReading
///    │ poseChanged                            │ ▼             ▼
///                                         EstimatingAgain ◀───┘
///   any state: stopped ▶ Stopped, stop released ▶ Idle; aborted ▶ Idle; pressing ▶ Pressing,
///   newPress ▶ Estimating.  A lost link, an error or a time limit after a captured scene ▶ Failed.
///
/// A reading that comes during the first estimate waits for its end. One tick has no clock and no
/// I/O. Throws std::invalid_argument unless in.now is finite.
AtemState nextFollowed(const AtemState& now, const FollowInput& in, const AtemLimits& limits);

/// Returns a text for the operator: "following: flippers pressed, estimating the terrain".
SourceText describeFollowed(AtemPhase phase);

}  // namespace terratact
