#include "core/mapping/even_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kMaxRise = 3660.0 * 86'400.0;  // [s]
constexpr double kSameStep = 10.0;  // steps of two series that differ by less are one [s]
constexpr std::int64_t kSecondNs = 1'000'000'000;

}  // namespace

std::optional<double> clockStepBetween(std::int64_t before, std::int64_t time, double disorder)
{
    // Doubles: the difference may be beyond 64 bits.
    const double back = (static_cast<double>(before) - static_cast<double>(time)) * 1e-9;
    return back > disorder || back < -kMaxRise ? std::optional(back) : std::nullopt;
}

std::int64_t EvenClock::Follower::add(std::int64_t time)
{
    const auto back = before ? clockStepBetween(*before, time, disorder) : std::nullopt;
    if (back) {
        const bool isKnown =
            steps < clock.steps_.size() && std::abs(clock.steps_[steps].back - *back) < kSameStep;
        const std::uint64_t own = static_cast<std::uint64_t>(*before)
                                - static_cast<std::uint64_t>(time)
                                + static_cast<std::uint64_t>(interval);
        shift += isKnown ? clock.steps_[steps].shift : own;
        if (steps == clock.steps_.size())
            clock.steps_.push_back({shifted(time, shift), *back, own});
        ++steps;
    } else if (before && time > *before) {
        interval = std::min(time - *before, kSecondNs);
    }
    before = time;
    return shifted(time, shift);
}

void EvenClock::follow(const Row& row)
{
    if (isDisordered_) return;
    rows_.add(row.time);
    if (steps_.size() > kMaxSteps) {
        isDisordered_ = true;
        steps_.clear();
        sizes_.clear();
    } else if (steps_.size() > sizes_.size()) {
        sizes_.push_back(row.sizes);
    }
}

std::vector<std::string> clockRemarks(const std::vector<ClockStep>& steps)
{
    constexpr std::size_t kMaxListed = 5;
    std::vector<std::string> remarks;
    for (std::size_t i = 0; i < std::min(kMaxListed, steps.size()); ++i)
        remarks.push_back(fmt::format("the clock was set {} by {:.3f} s while this was recorded; "
                                      "times continue evenly from there",
                                      steps[i].back > 0.0 ? "back" : "forward",
                                      std::abs(steps[i].back)));
    if (steps.size() > kMaxListed)
        remarks.push_back(
            fmt::format("the clock was set {} more times", steps.size() - kMaxListed));
    return remarks;
}

}  // namespace terratact
