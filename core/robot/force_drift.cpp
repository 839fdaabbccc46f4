#include "core/robot/force_drift.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace terratact {
namespace {

constexpr double kRaised = 0.3;  // [rad]

}  // namespace

bool isUnloaded(const Measurement& m, double limit)
{
    const bool still = m.activity == RobotActivity::Halted || m.activity == RobotActivity::Driving;
    const bool raised = m.frontLeft >= kRaised && m.frontRight >= kRaised;
    const bool felt = (m.missing >> kFirstForceFeature).none();
    return still && raised && felt
        && std::all_of(m.force.begin(), m.force.end(), [=](double f) { return f < limit; });
}

void ForceDrift::add(double time, const Forces& forces)
{
    if (!std::isfinite(time)) throw std::invalid_argument("ForceDrift: the time must be finite");
    if (taken_ && time < *taken_) *this = {};
    constexpr double kRounding = 1e-6;  // [s]
    if (taken_ && time - *taken_ < kSpacing - kRounding) return;
    taken_ = time;
    for (std::size_t e = 0; e < forces.size(); ++e) {
        if (!forces[e] || !std::isfinite(*forces[e])) continue;
        readings_[e].push_back(*forces[e]);
        if (readings_[e].size() > kMax) readings_[e].pop_front();
    }
}

std::optional<double> ForceDrift::drift(int element) const
{
    const auto& readings = readings_.at(static_cast<std::size_t>(element));
    if (readings.size() < kMin) return std::nullopt;
    std::vector<double> sorted(readings.begin(), readings.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

}  // namespace terratact
