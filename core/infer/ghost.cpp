#include "core/infer/ghost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

constexpr double kTenth = 1.2815515655446004;  // Φ⁻¹(0.9)
constexpr double kOnABin = 1e-9;               // of a bin's width

/// Where a bin of now lies among those of then: between bin `rear` and the next, `share` of the way to that.
struct Place {
    int rear = 0;
    double share = 0.0;
};

std::optional<Place> placeOf(double x)
{
    const double position = (x - binCentre(0)) / kBinWidth;
    const double nearest = std::round(position);
    const double snapped = std::abs(position - nearest) < kOnABin ? nearest : position;
    if (!(snapped >= 0.0 && snapped <= kBins - 1)) return std::nullopt;
    const int rear = static_cast<int>(std::floor(snapped));
    return Place{rear, snapped - rear};
}

bool known(const TerrainEstimate& estimate, const Place& place)
{
    return !estimate.priorOnly(place.rear)
        && (place.share == 0.0 || !estimate.priorOnly(place.rear + 1));
}

double between(const Heights& values, const Place& place)
{
    const auto i = static_cast<std::size_t>(place.rear);
    return place.share == 0.0 ? values[i]
                              : (1.0 - place.share) * values[i] + place.share * values[i + 1];
}

/// sd of the height where the slip is a way along the ground: of the steepest slope to a neighbour.
double slipSd(const Heights& heights, const Place& place, const ImuMotion& motion)
{
    double worst = std::abs(motion.slipUp);
    const int last = place.share == 0.0 ? place.rear : place.rear + 1;
    for (int bin = std::max(1, place.rear); bin <= std::min(kBins - 1, last + 1); ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const double slope = (heights[i] - heights[i - 1]) / kBinWidth;
        worst = std::max(worst, std::abs(slope * motion.slipForward - motion.slipUp));
    }
    return worst;
}

GhostBin widened(const TerrainEstimate& estimate, const Place& place, const ImuMotion& motion)
{
    const double w = std::hypot(slipSd(estimate.height, place, motion), motion.upSd);
    const double height = between(estimate.height, place);
    const double below = std::hypot(height - between(estimate.q10, place), kTenth * w);
    const double above = std::hypot(between(estimate.q90, place) - height, kTenth * w);
    const double now = height - motion.up;
    return {now, std::hypot(between(estimate.sd, place), w), now - below, now + above};
}

/// Of the shortest way round.
double turnBetween(double from, double to)
{
    return std::remainder(to - from, 2.0 * std::numbers::pi);
}

double leastSd(const Ghost& ghost)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& bin : ghost.bin)
        if (bin) least = std::min(least, bin->sd);
    return least;
}

void requireFinite(double travelled, double pitch)
{
    if (!std::isfinite(travelled) || !std::isfinite(pitch))
        throw std::invalid_argument("DeadReckoning: way and pitch must be finite");
}

}  // namespace

DeadReckoning::DeadReckoning(const RobotModel& robot, double travelled, double pitch)
    : share_(robot.travelledSdShare), pitchSd_(robot.pitchSd),
      pivotSd_(robot.trackAxle / std::sqrt(12.0)), imu_{robot.imu.x,
                                                        robot.imu.z + robot.baseHeight},
      travelled_(travelled), startPitch_(pitch), pitch_(pitch)
{
    requireFinite(travelled, pitch);
}

void DeadReckoning::take(double travelled, double pitch)
{
    requireFinite(travelled, pitch);
    const double ds = travelled - travelled_;
    const Vec2 along = rotated({1.0, 0.0}, (pitch + pitch_) / 2.0);
    rolled_ = {rolled_.x + ds * along.x, rolled_.z + ds * along.z};
    way_ += std::abs(ds);
    wayAlong_ = {wayAlong_.x + std::abs(ds) * along.x, wayAlong_.z + std::abs(ds) * along.z};
    travelled_ = travelled;
    pitch_ = pitch;
    largestChange_ = std::max(largestChange_, std::abs(pitchChange()));
}

ImuMotion DeadReckoning::motion() const
{
    const Vec2 before = rotated(imu_, startPitch_);
    const Vec2 after = rotated(imu_, pitch_);
    return {.forward = rolled_.x + after.x - before.x,
            .up = rolled_.z + after.z - before.z,
            .way = way_,
            .slipForward = share_ * wayAlong_.x,
            .slipUp = share_ * wayAlong_.z,
            .upSd = std::hypot(pitchSd_ * way_, pivotSd_ * largestChange_)};
}

Ghost ghostOf(const TerrainEstimate& estimate, const ImuMotion& motion)
{
    Ghost ghost;
    ghost.motion = motion;
    for (int bin = 0; bin < kBins; ++bin) {
        const std::optional<Place> place = placeOf(binCentre(bin) + motion.forward);
        if (place && known(estimate, *place))
            ghost.bin[static_cast<std::size_t>(bin)] = widened(estimate, *place, motion);
    }
    return ghost;
}

std::string describe(NoGhost why)
{
    switch (why) {
    case NoGhost::NoOdometry: return "the robot reports no odometry";
    case NoGhost::TooFar: return "the robot has driven too far since the last estimate";
    case NoGhost::TooUncertain: return "the last estimate has become too uncertain";
    case NoGhost::Tilted: return "the robot has tilted too much since the last estimate";
    case NoGhost::Turned: return "the robot has turned since the last estimate";
    case NoGhost::Unheard: return "telemetry was missing while the robot drove";
    case NoGhost::NothingLeft: return "nothing of the last estimate is left in view";
    }
    throw std::invalid_argument("describe: no such NoGhost");
}

GhostTrack::GhostTrack(const RobotModel& robot, const TerrainEstimate& estimate,
                       const Measurement& scene, const GhostLimits& limits)
    : estimate_(estimate), limits_(limits), scene_(scene), last_(scene)
{
    if (!scene.travelled) {
        end(NoGhost::NoOdometry);
        return;
    }
    reckoning_.emplace(robot, *scene.travelled, scene.pitch);
    ghost_ = ghostOf(estimate_, reckoning_->motion());
}

void GhostTrack::take(const Measurement& measurement)
{
    if (why_) return;
    if (!measurement.travelled) return end(NoGhost::NoOdometry);
    const bool silent = std::abs(measurement.time - last_.time) > limits_.silence;
    last_ = measurement;
    if (silent) return end(NoGhost::Unheard);
    reckoning_->take(*measurement.travelled, measurement.pitch);
    ghost_ = ghostOf(estimate_, reckoning_->motion());
    if (const auto why = judge(measurement)) end(*why);
}

std::optional<NoGhost> GhostTrack::judge(const Measurement& m) const
{
    const double turned = turnBetween(scene_.turned.value_or(0.0), m.turned.value_or(0.0));
    if (std::abs(turned) > limits_.turn) return NoGhost::Turned;
    if (std::abs(reckoning_->pitchChange()) > limits_.tilt
        || std::abs(m.roll - scene_.roll) > limits_.tilt)
        return NoGhost::Tilted;
    if (ghost_->motion.way > limits_.way) return NoGhost::TooFar;
    const double sd = leastSd(*ghost_);
    if (std::isinf(sd)) return NoGhost::NothingLeft;
    if (sd > limits_.sd) return NoGhost::TooUncertain;
    return std::nullopt;
}

void GhostTrack::end(NoGhost why)
{
    why_ = why;
    ghost_.reset();
}

}  // namespace terratact
