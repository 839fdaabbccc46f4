#include "core/robot/watch/return_watch.h"

#include <cmath>
#include <numbers>

namespace terratact {
namespace {

constexpr std::size_t kSteps = 500;
// [A] front flippers with more current lean on something and change the slope
constexpr double kFrontLoad = 0.5;
constexpr double kMaxWay = 0.5;  // [m] between two lines

bool isFrontLoaded(const Measurement& m)
{
    return !m.missing[kFrontCurrentFeature]
        && (m.frontLeftCurrent + m.frontRightCurrent) / 2.0 > kFrontLoad;
}

}  // namespace

void ReturnWatch::reset()
{
    const RobotModel robot = robot_;
    *this = ReturnWatch(robot);
}

void ReturnWatch::take(const Measurement& line)
{
    found_.clear();
    rear_.take(line);
    if (!line.travelled || !line.turned) return;
    const double ds = travelled_ ? *line.travelled - *travelled_ : 0.0;
    travelled_ = line.travelled;
    if (std::abs(ds) > kMaxWay) return reset();
    const double rear = (line.rearLeft + line.rearRight) / 2.0;
    const double pitch = line.pitch + (rear_.isLoaded() ? supportAngle(robot_, rear) : 0.0);
    const Vec2 ahead = rotated({ds * std::cos(pitch), 0.0}, *line.turned);
    place_ = {place_.x + ahead.x, place_.z + ahead.z};
    if (line.activity != RobotActivity::Driving || !(ds > 0.0) || isFrontLoaded(line)) return;
    way_ += ds;
    pitchWay_ += ds * pitch;
    loadedWay_ += rear_.isLoaded() ? ds : 0.0;
    if (way_ >= kStep) end(*line.turned, line.time);
}

std::size_t ReturnWatch::turnedAt() const
{
    const double heading = steps_.back().heading;
    std::size_t first = steps_.size();
    while (first > 0 && std::abs(turnBetween(steps_[first - 1].heading, heading)) < kOpposite)
        --first;
    return first;
}

double ReturnWatch::wayBack() const
{
    return static_cast<double>(steps_.size() - turnedAt()) * kStep;
}

std::optional<double> ReturnWatch::shiftNow() const
{
    const std::size_t turned = turnedAt();
    const std::size_t back = steps_.size() - turned;
    if (wayBack() < kMinWay) return std::nullopt;
    const auto isOut = [this](const Step& s) {
        return std::abs(turnBetween(s.heading, steps_.back().heading))
             > std::numbers::pi - kOpposite;
    };
    std::size_t nearest = turned;
    double least = kNear;
    Step there{}, here{};
    for (std::size_t k = turned; k > 0 && isOut(steps_[k - 1]); --k) {
        const Vec2 from = steps_.back().place, to = steps_[k - 1].place;
        const double apart = std::hypot(to.x - from.x, to.z - from.z);
        if (apart > least) continue;
        least = apart;
        nearest = k - 1;
    }
    if (nearest == turned) return std::nullopt;
    for (std::size_t k = nearest; k < steps_.size(); ++k) {
        Step& sum = k < turned ? there : here;
        sum.pitch += steps_[k].pitch / static_cast<double>(k < turned ? turned - nearest : back);
        sum.loaded += steps_[k].loaded / static_cast<double>(k < turned ? turned - nearest : back);
    }
    const double loaded = (there.loaded + here.loaded) / 2.0;
    return (there.pitch + here.pitch) / 2.0 - (kNoseUp - kNoseDown * loaded);
}

void ReturnWatch::end(double heading, double now)
{
    steps_.push_back({.place = place_,
                      .heading = heading,
                      .pitch = pitchWay_ / way_,
                      .loaded = loadedWay_ / way_});
    way_ = pitchWay_ = loadedWay_ = 0.0;
    if (steps_.size() > kSteps) steps_.pop_front();
    const auto shift = shiftNow();
    if (!shift) return;
    shift_ = shift;
    limit_ = kLimit * std::sqrt(kLimitWay / wayBack());
    if (isCleared()) return;
    found_.push_back({.sensor = Sensor::Pitch,
                      .trouble = SensorTrouble::BothWays,
                      .since = now,
                      .until = now + kHold,
                      .amount = *shift,
                      .way = 0.0});
}

}  // namespace terratact
