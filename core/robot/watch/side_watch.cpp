#include "core/robot/watch/side_watch.h"

#include <algorithm>
#include <cmath>

#include "core/robot/watch/unloaded_watch.h"

namespace terratact {
namespace {

constexpr int kFirstLines = 3;
constexpr int kMinSettledLines = 3;
constexpr double kNoise = 0.2;       // [A] within which currents agree
constexpr double kBothRaised = 0.3;  // [rad] both front flippers, at least
constexpr int kRaisedLines = 50;
constexpr double kHardlyFree = 0.1;  // share of the raised lines
constexpr double kMinLate = 4.0;     // [N]
constexpr double kOtherLate = 0.35;  // of that change, in the other side
constexpr std::size_t kOrders = 2;   // elements 1 and 2, against 6 and 5

double& countOf(std::array<double, kForceElements>& counts, std::size_t e, double more)
{
    counts[e] = std::clamp(counts[e] + more, 0.0, 2.0 * SideWatch::kPresses);
    return counts[e];
}

bool differ(double a, double b)
{
    return std::abs(a - b) > std::max(SideWatch::kMinDifference,
                                      SideWatch::kShare * std::max(std::abs(a), std::abs(b)));
}

}  // namespace

void SideWatch::Mean::add(const Measurement& line)
{
    ++lines;
    const double share = 1.0 / lines;
    const auto towards = [share](double& mean, double value) { mean += share * (value - mean); };
    for (std::size_t e = 0; e < kForceElements; ++e) {
        const auto &ofLeft = line.sides.left[e], &ofRight = line.sides.right[e];
        isMissing[e] = isMissing[e] || !ofLeft || !ofRight;
        towards(left[e], ofLeft.value_or(0.0));
        towards(right[e], ofRight.value_or(0.0));
    }
    const MotorCurrents currents = motorCurrents(line);
    lacksCurrent = lacksCurrent || !currents[0] || !currents[1];
    towards(leftCurrent, currents[0].value_or(0.0));
    towards(rightCurrent, currents[1].value_or(0.0));
    towards(angle, line.frontLeft - line.frontRight);
}

void SideWatch::reset()
{
    *this = SideWatch();
}

bool SideWatch::isCleared(const SensorSuspicion& s) const
{
    if (!isSideForce(s.sensor)) return false;
    const std::size_t e = elementOf(s.sensor);
    const bool isLeft = s.sensor < Sensor::RightForce1;
    switch (s.trouble) {
    case SensorTrouble::Late: return (isLeft ? late_.left : late_.right)[e] <= 0.0;
    case SensorTrouble::WrongOrder: return order_[std::min(e, kForceElements - 1 - e)] <= 0.0;
    case SensorTrouble::NoLoad:
    case SensorTrouble::SidesDiffer: return lower_.left[e] <= 0.0 && lower_.right[e] <= 0.0;
    default: return false;
    }
}

void SideWatch::suspect(Sensor sensor, SensorTrouble trouble, double now, double amount)
{
    found_.push_back(
        {.sensor = sensor,
         .trouble = trouble,
         .since = now,
         .until = now + (trouble == SensorTrouble::LoadedFree ? UnloadedWatch::kHold : kHold),
         .amount = amount,
         .way = 0.0});
}

void SideWatch::add(const Measurement& line)
{
    found_.clear();
    const RobotActivity activity = line.activity;
    if (activity == RobotActivity::Pressed || activity == RobotActivity::Probing)
        return follow(line);
    if (press_ && !press_->wasJudged) judge(*press_, line.time);
    press_.reset();
    if (activity == RobotActivity::Driving) followRaised(line);
}

void SideWatch::follow(const Measurement& line)
{
    const double now = line.time;
    if (!press_) press_.emplace(Press{.began = now, .early = {}, .settled = {}});
    Press& press = *press_;
    if (press.early.lines < kFirstLines) press.early.add(line);
    const double rested = now - press.began;
    if (rested >= kSettle && rested <= kWatched) press.settled.add(line);
    if (rested <= kWatched || press.wasJudged) return;
    press.wasJudged = true;
    judge(press, now);
}

void SideWatch::followRaised(const Measurement& line)
{
    if (line.frontLeft < kBothRaised || line.frontRight < kBothRaised) return;
    raisedLines_ = std::min(raisedLines_ + 1, kRaisedLines);
    for (std::size_t e = 0; e < kForceElements; ++e) {
        const auto follow = [this](double& share, const std::optional<double>& force) {
            share += 1.0 / raisedLines_ * ((force.value_or(0.0) < kNothing ? 1.0 : 0.0) - share);
        };
        follow(freeLeft_[e], line.sides.left[e]);
        follow(freeRight_[e], line.sides.right[e]);
    }
}

void SideWatch::judge(const Press& press, double now)
{
    const bool isSettled = press.settled.lines >= kMinSettledLines;
    const Mean& rest = isSettled ? press.settled : press.early;
    if (raisedLines_ < kMinRaised || rest.lacksCurrent) return;
    const double most = std::max(std::abs(rest.leftCurrent), std::abs(rest.rightCurrent));
    if (std::abs(rest.angle) > kAngle) return;
    if (std::abs(rest.leftCurrent - rest.rightCurrent) > kNoise + kCurrent * most) return;
    judgeLoads(rest, now);
    if (isSettled) judgeLate(press, now);
}

void SideWatch::judgeLoads(const Mean& rest, double now)
{
    int lowerLeft = 0, lowerRight = 0;
    for (std::size_t e = 0; e < kForceElements; ++e)
        if (!rest.isMissing[e] && differ(rest.left[e], rest.right[e]))
            ++(rest.left[e] < rest.right[e] ? lowerLeft : lowerRight);
    for (std::size_t e = 0; e < kOrders; ++e) judgeOrder(rest, e, now);
    for (std::size_t e = 0; e < kForceElements; ++e) {
        if (rest.isMissing[e]) continue;
        const bool isLoaded = std::max(rest.left[e], rest.right[e]) >= kLoaded;
        if (!differ(rest.left[e], rest.right[e])) {
            const double less = isLoaded ? -1.0 : 0.0;
            countOf(lower_.left, e, less);
            countOf(lower_.right, e, less);
            continue;
        }
        if (lowerLeft > 0 && lowerRight > 0) continue;
        const bool isLeft = rest.left[e] < rest.right[e];
        countOf(isLeft ? lower_.right : lower_.left, e, -1.0);
        if (countOf(isLeft ? lower_.left : lower_.right, e, 1.0) >= kPresses) blame(rest, e, now);
    }
}

void SideWatch::blame(const Mean& rest, std::size_t e, double now)
{
    const bool isLeft = rest.left[e] < rest.right[e];
    const Sensor lower = isLeft ? leftForce(e) : rightForce(e);
    const Sensor higher = isLeft ? rightForce(e) : leftForce(e);
    const double apart = std::abs(rest.left[e] - rest.right[e]);
    if ((isLeft ? freeRight_ : freeLeft_)[e] < kHardlyFree)
        return suspect(higher, SensorTrouble::LoadedFree, now, apart);
    if (std::min(rest.left[e], rest.right[e]) < kNothing)
        return suspect(lower, SensorTrouble::NoLoad, now, apart);
    suspect(lower, SensorTrouble::SidesDiffer, now, apart);
    suspect(higher, SensorTrouble::SidesDiffer, now, apart);
}

void SideWatch::judgeOrder(const Mean& rest, std::size_t e, double now)
{
    const std::size_t other = kForceElements - 1 - e;
    if (rest.isMissing[e] || rest.isMissing[other]) return;
    const Forces &l = rest.left, &r = rest.right;
    const bool differs = differ(l[e], r[e]) && differ(l[other], r[other]);
    if (!differs) {
        const bool tells = differ(l[e], l[other]) && differ(r[e], r[other]);
        countOf(order_, e, tells ? -1.0 : 0.0);
        return;
    }
    if (differ(l[e], r[other]) || differ(l[other], r[e])) return;
    if (countOf(order_, e, 1.0) < kPresses) return;
    // A press that loads the pivot's end alone is rare; of 2 and 5, either may be loaded alone.
    const bool isLeft = e > 0 || l[e] > r[e], isRight = e > 0 || !isLeft;
    for (const std::size_t k : {e, other}) {
        const double apart = std::abs(l[k] - r[k]);
        if (isLeft) suspect(leftForce(k), SensorTrouble::WrongOrder, now, apart);
        if (isRight) suspect(rightForce(k), SensorTrouble::WrongOrder, now, apart);
    }
}

void SideWatch::judgeLate(const Press& press, double now)
{
    for (std::size_t e = 0; e < kForceElements; ++e) {
        if (press.early.isMissing[e] || press.settled.isMissing[e]) continue;
        const double left = press.settled.left[e] - press.early.left[e];
        const double right = press.settled.right[e] - press.early.right[e];
        const double apart = std::abs(left - right);
        const bool isLoaded = std::max(press.settled.left[e], press.settled.right[e]) >= kLoaded;
        const bool isLeft = std::abs(left) > std::abs(right);
        const double other = std::min(std::abs(left), std::abs(right));
        const bool isLate = apart > kMinLate && other < kOtherLate * apart;
        if (!isLate) {
            countOf(late_.left, e, isLoaded ? -1.0 : 0.0);
            countOf(late_.right, e, isLoaded ? -1.0 : 0.0);
            continue;
        }
        if (countOf(isLeft ? late_.left : late_.right, e, 1.0) >= kPresses)
            suspect(isLeft ? leftForce(e) : rightForce(e), SensorTrouble::Late, now, apart);
    }
}

}  // namespace terratact
