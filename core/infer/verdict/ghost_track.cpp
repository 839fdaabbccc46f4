#include "core/infer/verdict/ghost_track.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terratact {
namespace {

double leastSd(const Ghost& ghost)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& bin : ghost.bin)
        if (bin) least = std::min(least, bin->sd);
    return least;
}

}  // namespace

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
