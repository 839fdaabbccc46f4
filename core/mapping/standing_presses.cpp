#include "core/mapping/standing_presses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

constexpr std::size_t kPoseAngles = 6;

/// Pitch, roll and flipper angles.
std::array<double, kPoseAngles> poseAngles(const Measurement& m)
{
    return {m.pitch, m.roll, m.frontLeft, m.frontRight, m.rearLeft, m.rearRight};
}

/// Mean pose of lines that follow each other.
struct MeanPose {
    std::array<double, kPoseAngles> angle{};  ///< [rad]
    std::optional<double> travelled{};        ///< [m] of the last line
};

/// Returns the mean pose of the lines first … last. Angles are averaged around those of the first line.
MeanPose meanPose(const std::vector<TelemetryLine>& lines, std::size_t first, std::size_t last)
{
    MeanPose mean;
    const auto begin = poseAngles(lines[first].measurement);
    const auto count = static_cast<double>(last - first + 1);
    for (std::size_t i = first; i <= last; ++i) {
        const auto angles = poseAngles(lines[i].measurement);
        for (std::size_t k = 0; k < kPoseAngles; ++k)
            mean.angle[k] += turnBetween(begin[k], angles[k]) / count;
    }
    for (std::size_t k = 0; k < kPoseAngles; ++k) mean.angle[k] += begin[k];
    mean.travelled = lines[last].measurement.travelled;
    return mean;
}

bool isSamePose(const MeanPose& a, const MeanPose& b, const PressRule& rule)
{
    if (a.travelled && b.travelled && std::abs(*a.travelled - *b.travelled) > rule.maxWay)
        return false;
    for (std::size_t k = 0; k < kPoseAngles; ++k)
        if (std::abs(turnBetween(a.angle[k], b.angle[k])) > rule.maxTurn) return false;
    return true;
}

/// Returns true if the robot stood still in the lines first … last: both halves have one mean pose.
bool stoodStill(const std::vector<TelemetryLine>& lines, std::size_t first, std::size_t last,
                const PressRule& rule)
{
    if (last == first) return true;
    const std::size_t middle = first + (last - first) / 2;
    MeanPose before = meanPose(lines, first, middle);
    before.travelled = lines[first].measurement.travelled;
    return isSamePose(before, meanPose(lines, middle + 1, last), rule);
}

std::int64_t stillTime(const PressRule& rule)
{
    return static_cast<std::int64_t>(rule.still * 1e9);
}

/// Finds the presses line by line.
class PressFinder {
public:
    PressFinder(const std::vector<TelemetryLine>& lines, const PressRule& rule)
        : lines_(lines), rule_(rule)
    {
    }

    void add(std::size_t i)
    {
        const bool isPress = presses(lines_[i].measurement, rule_);
        const bool isGap = i > 0 && lines_[i].time - lines_[i - 1].time > stillTime(rule_);
        if (!isPress || isGap) end();
        if (!isPress) return;
        if (!pressed_) window_ = begin_ = i;
        pressed_ = true;
        while (lines_[i].time - lines_[window_].time > stillTime(rule_)) ++window_;
        const bool isWhole = lines_[i].time - lines_[begin_].time >= stillTime(rule_);
        if (!isWhole || !stoodStill(lines_, window_, i, rule_)) return;
        const MeanPose now = meanPose(lines_, window_, i);
        if (holds_ && !isSamePose(pose_, now, rule_)) keep();
        if (!holds_) pose_ = now;
        held_ = window_ + (i - window_) / 2;
        holds_ = true;
    }

    void end()
    {
        keep();
        pressed_ = false;
    }

    std::vector<std::size_t> found;

private:
    void keep()
    {
        if (holds_) found.push_back(held_);
        holds_ = false;
    }

    const std::vector<TelemetryLine>& lines_;
    const PressRule& rule_;
    std::size_t begin_ = 0, window_ = 0;  ///< first lines of the press and of the window
    std::size_t held_ = 0;                ///< line of this pose
    MeanPose pose_;                       ///< of its first window
    bool pressed_ = false, holds_ = false;
};

}  // namespace

bool presses(const Measurement& m, const PressRule& rule)
{
    if (rule.byActivity)
        return m.activity == RobotActivity::Pressed || m.activity == RobotActivity::Probing;
    const Proprioception s = proprioception(m);
    if (s.frontCurrent || s.rearCurrent)
        return std::max(s.frontCurrent.value_or(0.0), s.rearCurrent.value_or(0.0))
            >= rule.minCurrent;
    double sum = 0.0;
    bool any = false;
    for (const auto& force : s.force) {
        sum += force.value_or(0.0);
        any = any || force.has_value();
    }
    return any && sum >= rule.minForce;
}

std::vector<std::size_t> standingPresses(const std::vector<TelemetryLine>& lines,
                                         const PressRule& rule)
{
    PressFinder finder(lines, rule);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0 && lines[i].time < lines[i - 1].time)
            throw std::invalid_argument("standingPresses: the times of the lines fall");
        finder.add(i);
    }
    finder.end();
    return std::move(finder.found);
}

std::vector<bool> movedAt(const std::vector<TelemetryLine>& lines, const PressRule& rule)
{
    std::vector<bool> moved(lines.size());
    std::size_t window = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        while (lines[i].time - lines[window].time > stillTime(rule)) ++window;
        moved[i] = !stoodStill(lines, window, i, rule);
    }
    return moved;
}

}  // namespace terratact
