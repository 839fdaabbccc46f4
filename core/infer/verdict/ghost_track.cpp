#include "core/infer/verdict/ghost_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

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

void DeadReckoning::add(double travelled, double pitch)
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

GhostTrack::GhostTrack(const RobotModel& robot, const TerrainEstimate& estimate,
                       const Measurement& scene, const GhostLimits& limits)
    : estimate_(estimate), limits_(limits), scene_(scene)
{
    if (!scene.travelled) {
        end(NoGhost::NoOdometry);
        return;
    }
    reckoning_.emplace(robot, *scene.travelled, scene.pitch);
    ghost_ = ghostOf(estimate_, reckoning_->motion());
}

void GhostTrack::add(const Measurement& measurement)
{
    if (why_) return;
    if (!measurement.travelled) return end(NoGhost::NoOdometry);
    const double silence = std::abs(measurement.time - newestTelemetry_.value_or(measurement.time));
    newestTelemetry_ = measurement.time;
    if (silence > limits_.silence) return end(NoGhost::TelemetryGap);
    reckoning_->add(*measurement.travelled, measurement.pitch);
    ghost_ = ghostOf(estimate_, reckoning_->motion());
    if (const auto why = judge(measurement)) end(*why);
}

void GhostTrack::addSilence()
{
    if (!why_) end(NoGhost::TelemetryGap);
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
