#include "drivers/sim_source.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

namespace terratact {
namespace {

constexpr double kMaxStep = 0.05;  // [s] of simulated time

}  // namespace

SimSource::SimSource(SimulatedRobot robot, double speed)
    : robot_(std::move(robot)), speed_(speed), due_(Clock::now())
{
    if (!(speed > 0.0 && speed <= 1000.0))
        throw std::invalid_argument("SimSource: the speed must lie above 0 and at most at 1000");
}

Result<std::optional<Sample>> SimSource::next(std::chrono::milliseconds patience)
{
    const Clock::time_point limit = Clock::now() + patience;
    if (due_ > limit) {
        std::this_thread::sleep_until(limit);
        return std::optional<Sample>{};
    }
    std::this_thread::sleep_until(due_);

    const double passed = speed_ * std::chrono::duration<double>(kPeriod).count();
    const int steps = std::max(1, static_cast<int>(std::ceil(passed / kMaxStep)));
    const Clock::time_point enough = Clock::now() + kPeriod;
    for (int i = 0; i < steps && Clock::now() < enough; ++i) {
        const std::scoped_lock lock(mutex_);
        robot_.step(passed / steps);
    }
    due_ = std::max(due_ + kPeriod, Clock::now());

    const std::scoped_lock lock(mutex_);
    const Measurement measurement = robot_.measure();
    return std::optional<Sample>{Sample{.measurement = measurement, .truth = robot_.truth()}};
}

Status SimSource::send(const Command& command)
{
    const std::scoped_lock lock(mutex_);
    robot_.command(command);
    return Done{};
}

}  // namespace terratact
