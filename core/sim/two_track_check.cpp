#include "core/sim/two_track_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/infer/estimate/contradiction.h"
#include "core/robot/side_plane.h"
#include "core/sim/posterior_check.h"
#include "core/sim/rest/two_track_rest.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {
namespace {

constexpr std::array kCheckedSides{Side::Left, Side::Right};

GroundLines groundOf(const Heights& left, const Heights& right, const RobotModel& robot)
{
    const double y = robot.lateral.trackY;
    return GroundLines({{y, throughBins(left)}, {-y, throughBins(right)}});
}

/// Returns the current [A] of a side's front flipper: that of the other side if it was not measured, because both
/// are pressed alike. 0: not pressed.
double pressCurrent(const TwoTrackReadings& s, Side side)
{
    const auto& own = s.currents[indexOf(frontFlipper(side))];
    const auto& other = s.currents[indexOf(frontFlipper(opposite(side)))];
    return std::max(own.value_or(other.value_or(0.0)), 0.0);
}

PerFlipper<FlipperDrive> drivesOf(const TwoTrackReadings& s, const RobotModel& robot)
{
    PerFlipper<FlipperDrive> drives;
    for (std::size_t i = 0; i < kFlippers; ++i) drives[i] = HoldAngle{s.flippers[i]};
    for (const Side side : kCheckedSides) {
        const double current = pressCurrent(s, side);
        if (current > 0.0)
            drives[indexOf(frontFlipper(side))] = PressTorque{robot.torquePerAmpere * current};
    }
    return drives;
}

/// Differences as shares of the tolerances: the largest one, and the sum of all.
struct SideDifference {
    double most = HUGE_VAL, sum = HUGE_VAL;
};

SideDifference differenceOf(const TwoTrackPose& pose, const TwoTrackReadings& s,
                            const TwoTrackCheckRule& rule)
{
    SideDifference difference{0.0, 0.0};
    const auto add = [&difference](double distance, double tolerance) {
        difference.most = std::max(difference.most, std::abs(distance) / tolerance);
        difference.sum += std::abs(distance) / tolerance;
    };
    add(pose.pitch - s.pitch, rule.pitch);
    add(pose.roll - s.roll, rule.roll);
    for (const Side side : kCheckedSides) {
        const std::size_t i = indexOf(frontFlipper(side));
        if (pressCurrent(s, side) > 0.0) add(pose.flippers[i] - s.flippers[i], rule.front);
    }
    return difference;
}

Message contradictionOf(const TwoTrackCheck& check, const TwoTrackReadings& s)
{
    const auto degrees = [](double angle) {
        return signedFixed(std::round(angle * 180.0 / std::numbers::pi) + 0.0, 0);
    };
    return {TR_NOOP("core", "the estimate contradicts the readings: pitch %1°, roll %2°, front "
                            "flippers %3° left, %4° right measured; %5°, %6°, %7°, %8° on its "
                            "ground"),
            degrees(s.pitch),
            degrees(s.roll),
            degrees(s.flippers[indexOf(Flipper::FrontLeft)]),
            degrees(s.flippers[indexOf(Flipper::FrontRight)]),
            degrees(check.pitch),
            degrees(check.roll),
            degrees(check.front[0]),
            degrees(check.front[1])};
}

}  // namespace

TwoTrackCheck checkPosterior(const TwoTrackEstimate& estimate, const TwoTrackReadings& s,
                             const RobotModel& robot, const TwoTrackCheckRule& rule,
                             const Poll& poll)
{
    TwoTrackCheck check;
    const auto& [left, right] = estimate.side;
    const double x = -imuPosition(robot, {{}, s.pitch, s.roll, {}, 0.0}).x;
    const PerFlipper<FlipperDrive> drives = drivesOf(s, robot);
    SideDifference least;
    const std::size_t all = std::min(left.draws.size(), right.draws.size());
    const std::size_t draws = std::min(all, static_cast<std::size_t>(rule.draws));
    for (std::size_t k = 0; k <= draws; ++k) {
        callPoll(poll);
        const std::size_t d = k == 0 ? 0 : (k - 1) * all / draws;
        const GroundLines ground = k == 0 ? groundOf(left.height, right.height, robot)
                                          : groundOf(left.draws[d], right.draws[d], robot);
        const auto rest = restPose(robot, ground, x, drives, {s.pitch, s.roll});
        if (!rest) continue;
        ++check.rested;
        const SideDifference difference = differenceOf(rest->pose, s, rule);
        if (difference.sum < least.sum || difference.most <= 1.0) {
            least = difference;
            check.pitch = rest->pose.pitch;
            check.roll = rest->pose.roll;
            check.front = {rest->pose.flippers[indexOf(Flipper::FrontLeft)],
                           rest->pose.flippers[indexOf(Flipper::FrontRight)]};
            check.largest = difference.most;
        }
        check.agrees = difference.most <= 1.0;
        if (check.agrees) break;
    }
    return check;
}

void writePosteriorCheck(TwoTrackEstimate& estimate, const Measurement& line,
                         const RobotModel& robot, const Poll& poll)
{
    if (estimate.onePlane) {
        writePosteriorCheck(estimate.side[0], proprioception(line), robot, poll);
        estimate.side[1] = estimate.side[0];
        return;
    }
    const TwoTrackReadings s = twoTrackReadings(line);
    const TwoTrackCheck check = checkPosterior(estimate, s, robot, {}, poll);
    for (TerrainEstimate& side : estimate.side) {
        side.contradicts = !check.agrees;
        if (!check.agrees) side.warnings.push_back(contradictionOf(check, s));
    }
}

}  // namespace terratact
