#include "core/robot/watch/spike_watch.h"

#include <algorithm>
#include <cmath>

#include "core/limits.h"

namespace terratact {
namespace {

constexpr double kTilt = 1.5;       // [rad]
constexpr double kSideShare = 0.4;  // of a force of one side, whose noise no mean reduces
constexpr double kJump = 0.3;       // [m] a robot that tips over an edge rolls less at once
constexpr double kMaxGap = 0.2;     // [s] between lines that are neighbours
constexpr double kAnew = 0.05;      // [m] odometry of a robot that restarted

double spikeLimit(SensorKind kind)
{
    switch (kind) {
    case SensorKind::Attitude:
    case SensorKind::Angle: return 0.1;
    case SensorKind::Current: return 1.5;
    case SensorKind::Force: return 6.0;
    case SensorKind::Way: return 0.1;
    }
    return 0.0;
}

bool stays(const Measurement& a, const Measurement& b)
{
    return a.activity == b.activity
        && (a.activity == RobotActivity::Halted || a.activity == RobotActivity::Pressed
            || a.activity == RobotActivity::Probing);
}

double difference(Sensor sensor, double from, double to)
{
    return kindOf(sensor) == SensorKind::Angle ? turnBetween(from, to) : to - from;
}

}  // namespace

SpikeWatch::SpikeWatch(const RobotModel& robot)
    : currentLimit_(2.0 * robot.maxFlipperTorque / robot.torquePerAmpere)
{
}

void SpikeWatch::reset()
{
    before_.reset();
    beforeThat_.reset();
    for (auto& times : spikes_) times.clear();
    found_.clear();
}

void SpikeWatch::suspect(Sensor sensor, SensorTrouble trouble, double now, double amount)
{
    found_.push_back(suspicionFor(kHold, sensor, trouble, now, amount));
}

void SpikeWatch::detectSpike(std::size_t i, const Line& line)
{
    const Sensor sensor = sensorAt(i);
    const SensorKind kind = kindOf(sensor);
    const auto &first = beforeThat_->readings[i], &middle = before_->readings[i];
    const auto& last = line.readings[i];
    if (!first || !middle || !last) return;
    if ((kind == SensorKind::Current || kind == SensorKind::Force)
        && !(stays(beforeThat_->measurement, before_->measurement)
             && stays(before_->measurement, line.measurement)))
        return;
    const double up = difference(sensor, *first, *middle);
    const double down = difference(sensor, *last, *middle);
    const double least = std::min(std::abs(up), std::abs(down));
    const double around = std::max(std::abs(*first), std::abs(*last));
    const double limit = spikeLimit(kind) + (isSideForce(sensor) ? kSideShare * around : 0.0);
    if (up * down <= 0.0 || least <= limit) return;
    auto& times = spikes_[i];
    const double now = line.measurement.time;
    times.push_back(now);
    while (times.front() < now - kWindow) times.pop_front();
    if (times.size() > kSpikes) times.pop_front();
    if (times.size() >= kSpikes) suspect(sensor, SensorTrouble::Spikes, now, least);
}

void SpikeWatch::checkRange(const Measurement& line, const SensorReadings& readings)
{
    for (std::size_t i = 0; i < kSensors; ++i) {
        if (!readings[i]) continue;
        const SensorKind kind = kindOf(sensorAt(i));
        const double size = std::abs(*readings[i]);
        if ((kind == SensorKind::Attitude && size > kTilt)
            || (kind == SensorKind::Current && size > currentLimit_))
            suspect(sensorAt(i), SensorTrouble::OutOfRange, line.time, *readings[i]);
    }
    if (!before_ || !line.travelled || !before_->measurement.travelled) return;
    const double way = *line.travelled - *before_->measurement.travelled;
    const bool isAnew = std::abs(*line.travelled) < kAnew;
    if (!isAnew && std::abs(way) > kJump
        && std::abs(way) > kFastestTracks * std::max(line.time - before_->measurement.time, 0.05))
        suspect(Sensor::Travelled, SensorTrouble::OutOfRange, line.time, *line.travelled);
}

void SpikeWatch::add(const Measurement& sensed)
{
    found_.clear();
    const Line line{sensed, judgedReadings(sensed)};
    checkRange(line.measurement, line.readings);
    const auto follows = [](const Line& first, const Line& second) {
        return second.measurement.time - first.measurement.time <= kMaxGap;
    };
    if (beforeThat_ && follows(*before_, line) && follows(*beforeThat_, *before_))
        for (std::size_t i = 0; i < kSensors; ++i) detectSpike(i, line);
    beforeThat_ = before_;
    before_ = line;
}

}  // namespace terratact
