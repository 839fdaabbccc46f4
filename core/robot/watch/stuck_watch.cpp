#include "core/robot/watch/stuck_watch.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kWay = 0.1;       // [m]
constexpr double kSwept = 0.2;     // [rad]
constexpr double kStanding = 3.0;  // [s]
constexpr int kStandingLines = 40;
constexpr double kPressing = 0.6;      // [s]
constexpr double kPitchChange = 0.1;   // [rad]
constexpr double kDriving = 3.0;       // [s]
constexpr double kLongDriving = 10.0;  // [s]
constexpr double kForceChange = 3.0;   // [N]
constexpr double kSmoothing = 0.2;     // share of the newest line
constexpr double kResting = 0.3;       // [rad/s]
constexpr double kRounding = 1e-9;

bool stands(RobotActivity a)
{
    return a == RobotActivity::Halted || a == RobotActivity::Pressed || a == RobotActivity::Probing
        || a == RobotActivity::Stopped;
}

bool isFrontAngle(Sensor s)
{
    return s == Sensor::FrontLeft || s == Sensor::FrontRight;
}

bool isFrontCurrent(Sensor s)
{
    return s == Sensor::FrontLeftCurrent || s == Sensor::FrontRightCurrent;
}

void widen(SensorReadings& low, SensorReadings& high, const SensorReadings& readings)
{
    for (std::size_t i = 0; i < kSensors; ++i) {
        if (!readings[i]) continue;
        low[i] = std::min(low[i].value_or(*readings[i]), *readings[i]);
        high[i] = std::max(high[i].value_or(*readings[i]), *readings[i]);
    }
}

}  // namespace

bool StuckWatch::likeIsNoisy(Sensor sensor, const Run& run) const
{
    if (run.standing < kStanding || run.standingLines < kStandingLines) return false;
    for (std::size_t i = 0; i < kSensors; ++i)
        if (kindOf(sensorAt(i)) == kindOf(sensor) && 2 * run.noisy[i] >= run.standingLines)
            return true;
    return false;
}

bool StuckWatch::otherForceMoved(Sensor sensor, const Run& run) const
{
    for (std::size_t i = 0; i < kSensors; ++i) {
        const bool isOther = kindOf(sensorAt(i)) == SensorKind::Force && i != indexOf(sensor);
        if (isOther && run.low[i] && *run.high[i] - *run.low[i] >= kForceChange) return true;
    }
    return false;
}

bool StuckWatch::isStuck(Sensor sensor, const Run& run) const
{
    if (run.lines < kMinLines) return false;
    switch (kindOf(sensor)) {
    case SensorKind::Attitude:
        if (sensor == Sensor::Roll && !rollMeasured_) return false;
        return run.way >= kWay || run.swept >= kSwept;
    case SensorKind::Angle:
        return likeIsNoisy(sensor, run) || (isFrontAngle(sensor) && run.pressing >= kPressing);
    case SensorKind::Current:
        return likeIsNoisy(sensor, run) || (isFrontCurrent(sensor) && run.drove && run.pressed);
    case SensorKind::Force:
        return run.value > 0.0 && run.value < forceEnd_ && run.drove && run.pressed
            && otherForceMoved(sensor, run);
    case SensorKind::Way:
        return (run.driving >= kDriving && run.most - run.least >= kPitchChange)
            || run.driving >= kLongDriving;
    }
    return false;
}

void StuckWatch::follow(Run& run, const Measurement& line, const SensorReadings& readings,
                        double dt)
{
    ++run.lines;
    const bool stood = stands(line.activity) && before_->activity == line.activity;
    if (stood) {
        run.standing += dt;
        ++run.standingLines;
        for (std::size_t i = 0; i < kSensors; ++i)
            if (readings[i] && last_[i] && *readings[i] != *last_[i]) ++run.noisy[i];
    }
    if (line.activity == RobotActivity::Pressing) run.pressing += dt;
    const bool frontRests = std::abs(line.frontLeft - before_->frontLeft) < kResting * dt;
    if (line.activity == RobotActivity::Driving && frontRests) run.driving += dt;
    run.drove = run.drove || line.activity == RobotActivity::Driving;
    run.pressed = run.pressed || (run.drove && line.activity == RobotActivity::Pressed);
    if (line.travelled && before_->travelled)
        run.way += std::abs(*line.travelled - *before_->travelled);
    run.least = std::min(run.least, smoothPitch_);
    run.most = std::max(run.most, smoothPitch_);
    widen(run.low, run.high, readings);
}

void StuckWatch::add(const Measurement& line)
{
    found_.clear();
    const SensorReadings readings = judgedReadings(line);
    const double front = (line.frontLeft + line.frontRight) / 2.0;
    const double rear = (line.rearLeft + line.rearRight) / 2.0;
    rollMeasured_ = rollMeasured_ || line.roll != 0.0;
    for (std::size_t i = 0; i < kSensors; ++i)
        if (readings[i] && kindOf(sensorAt(i)) == SensorKind::Force)
            forceEnd_ = std::max(forceEnd_, *readings[i]);
    const double dt = before_ ? line.time - before_->time : 0.0;
    const double wasFront = smoothFront_, wasRear = smoothRear_;
    const double share = before_ ? kSmoothing : 1.0;
    smoothPitch_ += share * (line.pitch - smoothPitch_);
    smoothFront_ += share * (front - smoothFront_);
    smoothRear_ += share * (rear - smoothRear_);
    const double swept = before_ && !stands(line.activity)
                           ? std::abs(smoothFront_ - wasFront) + std::abs(smoothRear_ - wasRear)
                           : 0.0;
    for (std::size_t i = 0; i < kSensors; ++i) {
        if (!readings[i]) continue;
        Run& run = runs_[i];
        const bool turns =
            kindOf(sensorAt(i)) == SensorKind::Way && before_ && line.turned != before_->turned;
        if (!before_ || !last_[i] || *readings[i] != run.value || turns) {
            run = {};
            run.value = *readings[i];
            run.since = line.time;
            run.least = run.most = smoothPitch_;
            continue;
        }
        follow(run, line, readings, dt);
        run.swept += swept;
        if (!isStuck(sensorAt(i), run)) continue;
        found_.push_back({.sensor = sensorAt(i),
                          .trouble = SensorTrouble::Stuck,
                          .since = run.since,
                          .until = line.time + kHold,
                          .amount = line.time - run.since + kRounding,
                          .way = run.way});
    }
    last_ = readings;
    before_ = line;
}

}  // namespace terratact
