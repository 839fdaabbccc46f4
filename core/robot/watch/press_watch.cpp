#include "core/robot/watch/press_watch.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr std::size_t kReferenceLines = 4;
constexpr int kEarlyLines = 3;
constexpr int kMinSettled = 3;
constexpr double kMoved = 0.1;          // [rad] a larger change is a certain movement
constexpr double kUnmoved = 0.03;       // [rad]
constexpr double kMirrored = 0.15;      // [rad] sum of an angle and a flipped one of the same size
constexpr double kLateAngle = 0.06;     // [rad]
constexpr double kLateWay = 0.05;       // [m]
constexpr double kLateCurrent = 0.5;    // [A]
constexpr double kLateMoment = 2.5;     // [N m] of the forces about the pivot
constexpr double kNoCurrent = 0.2;      // [A]
constexpr double kWrongCurrent = -0.8;  // [A] in front
constexpr double kWrongRear = -0.9;     // [A] a flipper's own weight needs a tenth of this
constexpr double kLowest = -1.0;        // [rad] below this angle the flippers may hang free
constexpr double kMinMoment = 3.0;      // [N m] of one motor
constexpr double kForceShare = 0.1;     // share of the motor's moment
constexpr double kNearEnd = 0.9;        // share of an element's range
constexpr int kSwappedPresses = 2;      // a single press may be a rear flipper that gave way
constexpr std::size_t kPresses = 8;
constexpr double kPressChange = 25.0;  // squared change of pitch, in units of its variance
constexpr double kSumOfChanges = 36.0;
constexpr std::size_t kSidePresses = 5;

constexpr std::array kFront{Sensor::FrontLeft, Sensor::FrontRight};
constexpr std::array kRear{Sensor::RearLeft, Sensor::RearRight};
constexpr std::array kFrontCurrents{Sensor::FrontLeftCurrent, Sensor::FrontRightCurrent};
constexpr std::array kRearCurrents{Sensor::RearLeftCurrent, Sensor::RearRightCurrent};
constexpr std::array kForces{Sensor::Force1, Sensor::Force2, Sensor::Force3,
                             Sensor::Force4, Sensor::Force5, Sensor::Force6};

}  // namespace

void PressWatch::Mean::add(const SensorReadings& readings)
{
    for (std::size_t i = 0; i < kSensors; ++i) {
        if (!readings[i]) continue;
        sum[i] += *readings[i];
        ++lines[i];
    }
    const auto pitch = readings[indexOf(Sensor::Pitch)];
    if (pitch) pitchSquares += *pitch * *pitch;
}

double PressWatch::Mean::of(Sensor sensor) const
{
    const std::size_t i = indexOf(sensor);
    return lines[i] > 0 ? sum[i] / lines[i] : 0.0;
}

double PressWatch::Mean::pitchVariance() const
{
    const int n = count(Sensor::Pitch);
    if (n < 2) return 0.0;
    const double mean = of(Sensor::Pitch);
    return std::max(0.0, (pitchSquares - n * mean * mean) / (n - 1));
}

PressWatch::PressWatch(const RobotModel& robot) : robot_(robot) {}

void PressWatch::reset()
{
    before_.clear();
    press_.reset();
    activity_ = RobotActivity::Halted;
    pitchChanges_.clear();
    swappedPresses_ = 0;
    for (Differences& differences : differences_) differences.clear();
    found_.clear();
    cleared_.clear();
}

bool PressWatch::judges(SensorTrouble trouble)
{
    return trouble == SensorTrouble::Flipped || trouble == SensorTrouble::SwappedAxles
        || trouble == SensorTrouble::Late || trouble == SensorTrouble::NoLoad
        || trouble == SensorTrouble::SidesDiffer;
}

void PressWatch::add(const Measurement& line)
{
    found_.clear();
    cleared_.clear();
    Measurement means = line;
    means.sides = {};
    const SensorReadings readings = readingsOf(means);
    const bool presses = line.activity == RobotActivity::Pressing;
    if (presses && activity_ != RobotActivity::Pressing) {
        press_.emplace(Press{});
        press_->began = line.travelled;
        for (const SensorReadings& before : before_) press_->reference.add(before);
        if (before_.empty()) press_->reference.add(readings);
    }
    if (press_ && !presses) follow(line, readings);
    if (!press_) {
        before_.push_back(readings);
        if (before_.size() > kReferenceLines) before_.pop_front();
    } else {
        before_.clear();
    }
    activity_ = line.activity;
}

void PressWatch::follow(const Measurement& line, const SensorReadings& readings)
{
    Press& press = *press_;
    const bool rests =
        line.activity == RobotActivity::Pressed || line.activity == RobotActivity::Probing;
    if (rests && !press.pressed) {
        press.pressed = line.time;
        press.first.add(readings);
        judgeMotion(line.time);
    }
    const bool isOver = !rests || line.time - *press.pressed > kWatched;
    if (rests && press.early.count(Sensor::Pitch) < kEarlyLines) press.early.add(readings);
    if (rests && !isOver && line.time - *press.pressed >= kSettle) press.settled.add(readings);
    const bool isEarly = press.early.count(Sensor::Pitch) >= kEarlyLines || !rests;
    if (press.pressed && isEarly && !press.wasJudgedEarly) judgeEarly(line.time);
    if (press.pressed && isOver && !press.wasJudged) judgeSettled(line.time);
    if (!rests) press_.reset();
}

double PressWatch::rise(Sensor angle) const
{
    return turnBetween(press_->reference.of(angle), press_->first.of(angle));
}

bool PressWatch::looksFlipped(Sensor front) const
{
    if (rise(front) <= kMoved) return false;
    const Sensor other = front == kFront[0] ? kFront[1] : kFront[0];
    const Mean& reference = press_->reference;
    return reference.count(other) == 0 || rise(other) > kMoved
        || std::abs(reference.of(front) + reference.of(other)) <= kMirrored;
}

bool PressWatch::foundGround() const
{
    return press_->early.of(Sensor::FrontLeft) > kLowest
        && press_->early.of(Sensor::FrontRight) > kLowest;
}

void PressWatch::judgeMotion(double now)
{
    const auto still = [this](Sensor s) { return std::abs(rise(s)) <= kUnmoved; };
    const auto moved = [this](Sensor s) { return std::abs(rise(s)) >= kMoved; };
    for (const Sensor sensor : kFront)
        if (looksFlipped(sensor)) suspect(sensor, SensorTrouble::Flipped, now, rise(sensor));
    const double way =
        press_->began ? std::abs(press_->first.of(Sensor::Travelled) - *press_->began) : 0.0;
    if (way > kLateWay && press_->first.count(Sensor::Travelled) > 0)
        suspect(Sensor::Travelled, SensorTrouble::Late, now, way);
    const bool isSwapped = std::all_of(kFront.begin(), kFront.end(), still)
                        && std::all_of(kRear.begin(), kRear.end(), moved);
    swappedPresses_ = isSwapped ? swappedPresses_ + 1 : 0;
    if (swappedPresses_ >= kSwappedPresses)
        for (const Sensor sensor : {kFront[0], kFront[1], kRear[0], kRear[1]})
            suspect(sensor, SensorTrouble::SwappedAxles, now, rise(sensor));
}

void PressWatch::judgeEarly(double now)
{
    press_->wasJudgedEarly = true;
    judgeCurrents(now);
    judgeForces(now);
}

void PressWatch::judgeCurrents(double now)
{
    const Mean& rest = press_->early;
    for (const Sensor sensor : kFrontCurrents) {
        if (rest.count(sensor) == 0) continue;
        const double current = rest.of(sensor);
        if (current < kWrongCurrent)
            suspect(sensor, SensorTrouble::Flipped, now, current);
        else if (foundGround() && std::abs(current) < kNoCurrent)
            suspect(sensor, SensorTrouble::NoLoad, now, current);
    }
    for (const Sensor sensor : kRearCurrents)
        if (rest.of(sensor) < kWrongRear)
            suspect(sensor, SensorTrouble::Flipped, now, rest.of(sensor));
}

void PressWatch::judgeForces(double now)
{
    const Mean& rest = press_->early;
    double currents = 0.0, motors = 0.0;
    for (const Sensor sensor : kFrontCurrents) {
        currents += rest.of(sensor);
        motors += rest.count(sensor) > 0 ? 1.0 : 0.0;
    }
    const double motor = robot_.torquePerAmpere * currents / std::max(motors, 1.0);
    double moment = 0.0, most = 0.0;
    bool areMeasured = true;
    for (std::size_t e = 0; e < kForces.size(); ++e) {
        const double force = rest.of(kForces[e]);
        moment += force * robot_.elementShare[e] * robot_.front.edgeLength();
        most = std::max(most, force);
        areMeasured = areMeasured && rest.count(kForces[e]) > 0;
    }
    const bool isAtEnd = most > kNearEnd * robot_.forceSaturation;
    if (foundGround() && areMeasured && motor >= kMinMoment && !isAtEnd
        && moment < kForceShare * motor)
        for (const Sensor sensor : kForces) suspect(sensor, SensorTrouble::NoLoad, now, moment);
}

void PressWatch::judgeSettled(double now)
{
    Press& press = *press_;
    press.wasJudged = true;
    const auto change = [&press](Sensor s) {
        const bool isMeasured = press.first.count(s) > 0 && press.settled.count(s) > 0;
        return isMeasured ? press.settled.of(s) - press.first.of(s) : 0.0;
    };
    if (press.settled.count(Sensor::Pitch) >= kMinSettled) {
        for (const auto& axle : {kFront, kRear})
            for (const Sensor s : axle)
                if (std::abs(change(s)) > kLateAngle)
                    suspect(s, SensorTrouble::Late, now, std::abs(change(s)));
        for (const auto& axle : {kFrontCurrents, kRearCurrents})
            for (const Sensor s : axle)
                if (std::abs(change(s)) > kLateCurrent)
                    suspect(s, SensorTrouble::Late, now, std::abs(change(s)));
        double moment = 0.0;
        for (std::size_t e = 0; e < kForces.size(); ++e)
            moment += change(kForces[e]) * robot_.elementShare[e] * robot_.front.edgeLength();
        if (std::abs(moment) > kLateMoment)
            for (const Sensor s : kForces)
                suspect(s, SensorTrouble::Late, now, std::abs(change(s)));
        judgePitch(now);
    }
    judgeSides(now);
    for (std::size_t i = 0; i < kSensors; ++i) {
        const Sensor s = sensorAt(i);
        const bool wasMeasured =
            press.early.count(s) + press.first.count(s) + press.settled.count(s) > 0;
        if (wasMeasured && !press.isSuspect[i] && !isSideForce(s)) cleared_.push_back(s);
    }
}

void PressWatch::judgePitch(double now)
{
    const Press& press = *press_;
    const double change = press.settled.of(Sensor::Pitch) - press.early.of(Sensor::Pitch);
    const double variance =
        std::max(robot_.pitchSd * robot_.pitchSd, press.settled.pitchVariance());
    const double ofChange =
        variance
        * (1.0 / press.early.count(Sensor::Pitch) + 1.0 / press.settled.count(Sensor::Pitch));
    pitchChanges_.push_back(ofChange > 0.0 ? change * change / ofChange : 0.0);
    if (pitchChanges_.size() > kPresses) pitchChanges_.pop_front();
    double sum = 0.0;
    for (const double squared : pitchChanges_) sum += squared;
    if (pitchChanges_.back() > kPressChange || sum > kSumOfChanges)
        suspect(Sensor::Pitch, SensorTrouble::Late, now, std::abs(change));
}

void PressWatch::judgeSides(double now)
{
    constexpr std::array kMin{0.05, 0.05, 0.4, 0.4};  // [rad], [A]
    constexpr std::array kSpread{0.03, 0.03, 0.3, 0.3};
    const std::array axles{kFront, kRear, kFrontCurrents, kRearCurrents};
    for (std::size_t a = 0; a < axles.size(); ++a) {
        const Mean& early = press_->early;
        if (early.count(axles[a][0]) == 0 || early.count(axles[a][1]) == 0) continue;
        Differences& last = differences_[a];
        last.push_back(early.of(axles[a][0]) - early.of(axles[a][1]));
        if (last.size() > kSidePresses) last.pop_front();
        if (last.size() < kSidePresses) continue;
        const auto [low, high] = std::minmax_element(last.begin(), last.end());
        const double least = std::min(std::abs(*low), std::abs(*high));
        if (*low * *high > 0.0 && least > kMin[a] && *high - *low < kSpread[a])
            for (const Sensor s : axles[a]) suspect(s, SensorTrouble::SidesDiffer, now, least);
    }
}

void PressWatch::suspect(Sensor sensor, SensorTrouble trouble, double now, double amount)
{
    press_->isSuspect[indexOf(sensor)] = true;
    found_.push_back(suspicionFor(kHold, sensor, trouble, now, amount));
}

}  // namespace terratact
