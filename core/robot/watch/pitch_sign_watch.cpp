#include "core/robot/watch/pitch_sign_watch.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr std::size_t kLines = 6;  // most lines of a mean
constexpr double kSlow =
    0.3;  // [rad/s] flippers that rise more slowly have arrived, and the tracks may move
constexpr double kRise = 0.15;  // [rad] a flipper that has risen this far is off the ground

bool isPressed(const Measurement& m)
{
    return m.activity == RobotActivity::Pressed || m.activity == RobotActivity::Probing;
}

double frontOf(const Measurement& m)
{
    return (m.frontLeft + m.frontRight) / 2.0;
}

}  // namespace

void PitchSignWatch::Recent::add(double pitch)
{
    lines_.push_back(pitch);
    if (lines_.size() > kLines) lines_.pop_front();
}

double PitchSignWatch::Recent::mean() const
{
    double sum = 0.0;
    for (const double pitch : lines_) sum += pitch;
    return sum / static_cast<double>(lines_.size());
}

void PitchSignWatch::reset()
{
    sum_ = 0.0;
    before_.reset();
    free_.clear();
    pressed_.clear();
    raised_.clear();
    isRising_ = false;
    found_.clear();
}

void PitchSignWatch::judge(const Recent& down, const Recent& up, double now)
{
    if (down.isEmpty() || up.isEmpty() || !(pitchSd_ > 0.0)) return;
    const double sd = pitchSd_ * std::sqrt(1.0 / down.count() + 1.0 / up.count());
    const double lifted = up.mean() - down.mean();
    sum_ = std::clamp(sum_ - std::clamp(lifted / sd, -kCut, kCut), 0.0, 2.0 * kLimit);
    if (sum_ <= kLimit) return;
    found_.push_back(suspicionFor(kHold, Sensor::Pitch, SensorTrouble::Flipped, now, lifted));
}

void PitchSignWatch::add(const Measurement& line)
{
    found_.clear();
    const bool wasPressed = before_ && isPressed(*before_);
    const bool rests = before_ && line.travelled && before_->travelled == line.travelled;
    if (isPressed(line)) {
        if (!wasPressed) pressed_.clear();
        pressed_.add(line.pitch);
        lowest_ = frontOf(line);
        isRising_ = false;
        raised_.clear();
    } else if (wasPressed) {
        judge(free_, pressed_, line.time);
        isRising_ = line.activity == RobotActivity::Driving;
        free_.clear();
    }
    const bool rises =
        before_ && frontOf(line) - frontOf(*before_) > kSlow * (line.time - before_->time);
    if (isRising_ && (!rests || (!rises && !raised_.isEmpty()))) {
        judge(raised_, pressed_, line.time);
        isRising_ = false;
    }
    if (isRising_ && frontOf(line) > lowest_ + kRise) raised_.add(line.pitch);
    const bool isFree =
        line.activity == RobotActivity::Driving || line.activity == RobotActivity::Halted;
    if (isFree && !rests) free_.clear();
    if (isFree) free_.add(line.pitch);
    before_ = line;
}

}  // namespace terratact
