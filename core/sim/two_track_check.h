#pragma once

#include <array>

#include "core/base/poll.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"

namespace terratact {

/// Rule of the posterior check of both sides, as PosteriorCheckRule of one plane. The tolerances
/// refuse 0.51 % of 2768 fault-free scenes over generated ground that differs left and right. They
/// refuse 1.30 % of 1998 scenes over real ground. The check finds estimates on which no robot could
/// rest so. It finds few sensor faults, because the estimate follows the faulty reading. Refused are
/// 4.4 % of the scenes with a flipped pitch and 2.2 % with a flipped front flipper. With 10° too much
/// roll they are 1.4 %, and with most other faults no more than without one. `terratact-bench-check 2
/// 250` prints these numbers, and `terratact-bench-check 2 480 PAIRS.csv` those of real ground, with
/// 1.9 and 2.2 poses for a scene. A pose takes about 0.6 ms.
struct TwoTrackCheckRule {
    int draws = 24;       ///< most joint draws of the estimate, besides its heights
    double pitch = 0.08;  ///< [rad]
    double roll = 0.06;   ///< [rad]
    double front = 0.40;  ///< for each pressed front flipper [rad]; others are not compared
};

/// Readings of the robot on the ground of both sides' estimate.
struct TwoTrackCheck {
    int rested = 0;  ///< number of draws with a rest pose; 0: nothing was compared
    /// True if one draw gives the measured readings, within the rule; also if rested is 0.
    bool agrees = true;
    /// On the draw that agrees best [rad].
    double pitch = 0.0, roll = 0.0;
    std::array<double, 2> front{};  ///< left, right
    /// Largest difference on that draw, as a share of its tolerance.
    double largest = 0.0;
    bool operator==(const TwoTrackCheck&) const = default;
};

/// Puts the robot on the heights of both sides. It then takes their joint draws, one after another,
/// until the readings agree. Each side's ground is its bins' heights at their centres, joined by
/// straight lines, under its track and its flippers. Front flippers with a positive current are
/// pressed by it; one whose current was not measured by that of the other. Other flippers are held
/// at their angles (restPose of two tracks). The search begins
/// at the measured pitch and roll. A draw agrees if every difference is within the rule. The draws are
/// spread evenly over the estimate's draws: the same estimate gives the same result. s: with a
/// differential that has not turned. poll: called before every pose. Throws Cancelled.
TwoTrackCheck checkPosterior(const TwoTrackEstimate& estimate, const TwoTrackReadings& s,
                             const RobotModel& robot, const TwoTrackCheckRule& rule = {},
                             const Poll& poll = {});

/// Runs the check of the estimate's kind: of one plane (core/sim/posterior_check.h), or of both sides.
/// If it does not agree, sets `contradicts` of both sides and adds a warning with both readings.
void writePosteriorCheck(TwoTrackEstimate& estimate, const Measurement& line,
                         const RobotModel& robot, const Poll& poll = {});

}  // namespace terratact
