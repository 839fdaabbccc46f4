#include "core/sim/posterior_check.h"

#include <algorithm>
#include <cmath>

#include "core/base/degree.h"
#include "core/infer/estimate/contradiction.h"
#include "core/sim/rest/rest_pose.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {
namespace {

bool wasPressed(const Proprioception& s)
{
    return s.frontCurrent && *s.frontCurrent > 0.0;
}

Result<RestPose> restOn(const Heights& heights, const Proprioception& s, const RobotModel& robot)
{
    const double x = poseInDem(robot, s.pitch, s.front, s.rear).base.x;
    const FlipperDrive front =
        wasPressed(s) ? FlipperDrive{PressTorque{2.0 * robot.torquePerAmpere * *s.frontCurrent}}
                      : FlipperDrive{HoldAngle{s.front}};
    return restPose(robot, throughBins(heights), x, front, HoldAngle{s.rear}, s.pitch);
}

/// Differences as shares of the tolerances: the larger one, and the sum of both.
struct Difference {
    double most = HUGE_VAL, sum = HUGE_VAL;
};

Difference differenceOf(const Pose& pose, const Proprioception& s, const PosteriorCheckRule& rule)
{
    const double pitch = std::abs(pose.pitch - s.pitch) / rule.pitch;
    const double front = wasPressed(s) ? std::abs(pose.front - s.front) / rule.front : 0.0;
    return {std::max(pitch, front), pitch + front};
}

}  // namespace

PosteriorCheck checkPosterior(const TerrainEstimate& estimate, const Proprioception& s,
                              const RobotModel& robot, const PosteriorCheckRule& rule,
                              const Poll& poll)
{
    PosteriorCheck check;
    Difference least;
    const std::size_t all = estimate.draws.size();
    const std::size_t draws = std::min(all, static_cast<std::size_t>(rule.draws));
    for (std::size_t k = 0; k <= draws; ++k) {
        callPoll(poll);
        const Heights& heights = k == 0 ? estimate.height : estimate.draws[(k - 1) * all / draws];
        const auto rest = restOn(heights, s, robot);
        if (!rest) continue;
        ++check.rested;
        const Difference difference = differenceOf(rest->pose, s, rule);
        if (difference.sum < least.sum || difference.most <= 1.0) {
            least = difference;
            check.pitch = rest->pose.pitch;
            check.front = rest->pose.front;
        }
        check.agrees = difference.most <= 1.0;
        if (check.agrees) break;
    }
    return check;
}

void writePosteriorCheck(TerrainEstimate& estimate, const Proprioception& s,
                         const RobotModel& robot, const Poll& poll)
{
    const PosteriorCheck check = checkPosterior(estimate, s, robot, {}, poll);
    estimate.contradicts = !check.agrees;
    if (check.agrees) return;
    const auto degrees = [](double angle) {
        return signedFixed(std::round(angle / kDegree) + 0.0, 0);
    };
    estimate.warnings.emplace_back(
        TR_NOOP("core", "the estimate contradicts the readings: pitch %1° measured, %2° on its "
                        "ground; front flippers %3° measured, %4° on its ground"),
        degrees(s.pitch), degrees(check.pitch), degrees(s.front), degrees(check.front));
}

}  // namespace terratact
