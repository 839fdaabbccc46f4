#include "core/robot/watch/return_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace terratact {
namespace {

constexpr std::size_t kSteps = 2000;
// [A] front flippers with more current lean on something and change the slope
constexpr double kFrontLoad = 0.5;
constexpr double kMaxWay = 0.5;  // [m] between two lines
constexpr double kHardly = 0.1;  // share of a step with loaded rear flippers

/// Returns true if the front flippers carry no load, and it is known whether the rear ones carry one.
bool isJudged(const Measurement& m)
{
    const Proprioception s = proprioception(m);
    return s.rearCurrent && s.frontCurrent && *s.frontCurrent <= kFrontLoad;
}

}  // namespace

void ReturnWatch::reset()
{
    const RobotModel robot = robot_;
    *this = ReturnWatch(robot);
}

void ReturnWatch::add(const Measurement& line)
{
    found_.clear();
    rear_.add(line);
    if (!line.travelled || !line.turned) return;
    const double ds = travelled_ ? *line.travelled - *travelled_ : 0.0;
    travelled_ = line.travelled;
    if (std::abs(ds) > kMaxWay) return reset();
    const double rear = (line.rearLeft + line.rearRight) / 2.0;
    const double support = rear_.isLoaded() ? supportAngle(robot_, rear) : 0.0;
    const double pitch = line.pitch + support;
    const Vec2 ahead = rotated({ds / std::cos(support) * std::cos(pitch), 0.0}, *line.turned);
    place_ = {place_.x + ahead.x, place_.z + ahead.z};
    if (line.activity != RobotActivity::Driving || !(ds > 0.0) || !isJudged(line)) return;
    way_ += ds;
    pitchWay_ += ds * pitch;
    loadedWay_ += rear_.isLoaded() ? ds : 0.0;
    if (way_ >= kStep) end(*line.turned, line.time);
}

void ReturnWatch::end(double heading, double now)
{
    const double loaded = loadedWay_ / way_;
    const Vec2 mass = rotated({centreOfMass(robot_), 0.0}, heading);
    const Step step{.place = {place_.x + mass.x, place_.z + mass.z},
                    .heading = heading,
                    .pitch = pitchWay_ / way_,
                    .load = loaded < kHardly       ? Load::None
                          : loaded > 1.0 - kHardly ? Load::All
                                                   : Load::Some};
    way_ = pitchWay_ = loadedWay_ = 0.0;
    if (const Step* there = opposite(step)) {
        const double bias = step.load == Load::All ? kLoaded : kUnloaded;
        shifts_.push_back((there->pitch + step.pitch) / 2.0 - bias);
        firstTravelled_ = firstTravelled_ ? firstTravelled_ : travelled_;
        if (shifts_.size() > kMaxPlaces) shifts_.pop_front();
    }
    steps_.push_back(step);
    if (steps_.size() > kSteps) steps_.pop_front();
    if (shifts_.size() < kMinPlaces || *travelled_ - *firstTravelled_ < kMinWay) return;
    shift_ = middleMean();
    if (isCleared()) return;
    found_.push_back(suspicionFor(kHold, Sensor::Pitch, SensorTrouble::BothWays, now, *shift_));
}

const ReturnWatch::Step* ReturnWatch::opposite(const Step& step) const
{
    if (step.load == Load::Some) return nullptr;
    const Step* nearest = nullptr;
    double least = kSame;
    for (std::size_t i = steps_.size(); i-- > 0;) {
        const Step& there = steps_[i];
        if (there.load != step.load
            || std::abs(turnBetween(there.heading, step.heading)) < std::numbers::pi - kOpposite)
            continue;
        const Vec2 apart =
            rotated({there.place.x - step.place.x, there.place.z - step.place.z}, -step.heading);
        if (std::abs(apart.x) > least || std::abs(apart.z) > kNear) continue;
        least = std::abs(apart.x);
        nearest = &there;
    }
    return nearest;
}

double ReturnWatch::middleMean() const
{
    std::vector<double> sorted(shifts_.begin(), shifts_.end());
    std::sort(sorted.begin(), sorted.end());
    const auto quarter = static_cast<std::ptrdiff_t>(sorted.size() / 4);
    const double sum = std::accumulate(sorted.begin() + quarter, sorted.end() - quarter, 0.0);
    return sum / static_cast<double>(sorted.size() - 2 * static_cast<std::size_t>(quarter));
}

}  // namespace terratact
