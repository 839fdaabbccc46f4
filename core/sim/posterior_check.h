#pragma once

#include "core/base/poll.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Rule of the posterior check. The tolerances cover the sensors' noise and, mostly, the shape of
/// the ground within eleven bins. Together they refuse 0.44 % of 911 fault-free scenes over varied
/// ground; `terratact faults` prints the value for its own drives. A pose takes about 1 ms. A scene
/// that agrees mostly needs one to three poses. Currents are not compared. In 0.5 % of 2999
/// fault-free scenes, they differ by more than 5.4 A on every draw that agrees otherwise. At this
/// tolerance, one fault of ten contradicts more often than without it. It is a flipped sign of the
/// rear currents, in 4 % of 500 scenes. The sensor watch (core/robot/watch/sensor_watch.h) detects
/// this fault more often.
struct PosteriorCheckRule {
    int draws = 24;       ///< most draws of the estimate, besides its heights
    double pitch = 0.10;  ///< [rad]
    double front = 0.40;  ///< for pressed front flippers [rad]; others are not compared
};

/// Readings of the robot on the ground of the estimate.
struct PosteriorCheck {
    int rested = 0;  ///< number of draws with a rest pose; 0: nothing was compared
    /// True if one draw gives the measured readings, within the rule; also if rested is 0.
    bool agrees = true;
    double pitch = 0.0;  ///< on the draw that agrees best [rad]
    double front = 0.0;  ///< on the draw that agrees best [rad]
    bool operator==(const PosteriorCheck&) const = default;
};

/// Puts the robot on the estimate's heights, and then on its draws one after another, until the
/// readings agree. The ground is the bins' heights at their centres, joined by straight lines, and
/// level beyond them. Front flippers with a current are pressed by it; other flippers are held at
/// their angles (restPose).
/// A draw agrees if |pitch − s.pitch| ≤ rule.pitch, and |front − s.front| ≤ rule.front for pressed
/// flippers. The result shows the draw with the smallest sum of both, each as a share of its
/// tolerance. The draws are spread evenly over estimate.draws: the same estimate gives the same
/// result.
/// poll: called before every pose. Throws Cancelled.
PosteriorCheck checkPosterior(const TerrainEstimate& estimate, const Proprioception& s,
                              const RobotModel& robot, const PosteriorCheckRule& rule = {},
                              const Poll& poll = {});

/// Runs checkPosterior. If it does not agree, sets estimate.contradicts and adds a warning with
/// both readings:
///   "the estimate contradicts the readings: pitch +3° measured, -1° on its ground; front flippers …"
void writePosteriorCheck(TerrainEstimate& estimate, const Proprioception& s,
                         const RobotModel& robot, const Poll& poll = {});

}  // namespace terratact
