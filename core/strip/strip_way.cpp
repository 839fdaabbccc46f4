#include "core/strip/strip_way.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

TiltRange grown(const TiltRange& tilt, const ReckonedState& from, const ReckonedState& to)
{
    return {std::max(tilt.pitch, std::abs(to.line.pitch - from.line.pitch)),
            std::max(tilt.roll, std::abs(to.line.roll - from.line.roll))};
}

}  // namespace

StripWay::StripWay(const RobotModel& robot, const WayLimits& limits)
    : robot_(robot), limits_(limits), model_(robot, {}), turns_(limits.turn, limits.turnWay)
{
}

void StripWay::end(SectionStart why)
{
    ++segment_;
    why_ = why;
    turns_ = TurnWatch(limits_.turn, limits_.turnWay);
    odometry_.reset();
}

void StripWay::endWithoutOdometry()
{
    if (odometry_ || why_ == SectionStart::First || why_ == SectionStart::Suspected)
        end(SectionStart::NoOdometry);
}

void StripWay::begin(const OdometryLine& line)
{
    odometry_.emplace(robot_, line);
    chain_ = {.from = odometry_->now()};
    turns_.add(odometry_->now().way, odometry_->now().heading);
}

void StripWay::add(const Measurement& line)
{
    const double silence = std::abs(line.time - newest_.value_or(line.time));
    newest_ = line.time;
    if (!line.travelled) {
        endWithoutOdometry();
        return;
    }
    const OdometryLine odometry = odometryOf(line);
    if (odometry_ && silence > limits_.silence) end(SectionStart::TelemetryGap);
    const double way = odometry_ ? odometry.travelled - odometry_->now().line.travelled : 0.0;
    if (std::abs(way) > limits_.wayWithin(silence)) end(SectionStart::OdometryJump);
    if (odometry_) {
        odometry_->add(odometry);
        if (turns_.add(odometry_->now().way, odometry_->now().heading)) end(SectionStart::Turned);
    }
    if (!odometry_) {
        begin(odometry);
        return;
    }
    chain_.tilt = grown(chain_.tilt, chain_.from, odometry_->now());
    if (scene_ && scene_->segment == segment_)
        scene_->since = grown(scene_->since, scene_->at, odometry_->now());
}

void StripWay::beginScene(const Measurement& scene)
{
    scene_.reset();
    if (!scene.travelled) {
        endWithoutOdometry();
        return;
    }
    if (!odometry_ && why_ == SectionStart::Suspected) return;  // so is the scene
    const OdometryLine line = odometryOf(scene);
    if (!odometry_) begin(line);
    const ReckonedState at = odometry_->after(line);
    Chain chain = chain_;
    chain.tilt = grown(chain.tilt, chain.from, at);
    scene_ = ScenePose{scene.time, segment_, why_, at, chain, {}};
}

PoseCovariance StripWay::prior() const
{
    const Chain& chain = scene_->chain;
    return covarianceOf(model_.motion(chain.from, scene_->at, chain.tilt));
}

WayPose StripWay::settle(const PoseOffset& offset)
{
    Chain next = scene_->chain;
    next.from = scene_->at;
    next.tilt = scene_->since;
    next.shift = {next.shift.x + offset.mean.x, next.shift.z + offset.mean.z};
    next.planX += offset.mean.x * std::cos(scene_->at.heading);
    next.planY += offset.mean.x * std::sin(scene_->at.heading);
    next.drift = next.drift + offset.covariance;
    if (scene_->segment == segment_) chain_ = next;
    return poseAt(scene_->at, next, {});
}

void StripWay::unsettle()
{
    if (scene_->segment != segment_ || !odometry_) return;
    chain_ = scene_->chain;
    chain_.tilt = grown(chain_.tilt, chain_.from, odometry_->now());
}

std::optional<WayPose> StripWay::now() const
{
    if (!odometry_) return std::nullopt;
    const ReckonedState& state = odometry_->now();
    return poseAt(state, chain_, covarianceOf(model_.motion(chain_.from, state, chain_.tilt)));
}

WayPose StripWay::poseAt(const ReckonedState& state, const Chain& chain,
                         const PoseCovariance& link) const
{
    const double lever = state.imu.x - state.rolled.x;
    return {.imu = {state.imu.x + chain.shift.x, state.imu.z + chain.shift.z},
            .planX = state.planX + chain.planX + lever * std::cos(state.heading),
            .planY = state.planY + chain.planY + lever * std::sin(state.heading),
            .heading = state.heading,
            .way = state.way,
            .drift = chain.drift + link};
}

}  // namespace terratact
