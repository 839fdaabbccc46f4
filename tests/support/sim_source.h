#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "core/sim/simulated_robot.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// The simulated robot without a bus, which needs no arming. It makes a telemetry sample every 50 ms of the steady
/// clock, with the true terrain.
class SimSource final : public MeasurementSource {
public:
    /// speed: simulated seconds per second. On a slow machine simulated time slows down and never catches up in a
    /// burst.
    SimSource(SimulatedRobot robot, double speed) : robot_(std::move(robot)), speed_(speed) {}

    std::string name() const override { return "SIMULATED ROBOT"; }

    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override
    {
        const Clock::time_point limit = Clock::now() + patience;
        std::this_thread::sleep_until(std::min(due_, limit));
        if (due_ > limit) return std::optional<Sample>{};
        pass(speed_ * std::chrono::duration<double>(kPeriod).count());
        due_ = std::max(due_ + kPeriod, Clock::now());
        const std::scoped_lock lock(mutex_);
        return std::optional(Sample{.measurement = robot_.measure(), .truth = robot_.truth()});
    }

    /// Takes effect at once, between two steps of simulated time.
    Status send(const Command& command) override
    {
        const std::scoped_lock lock(mutex_);
        robot_.command(command);
        return Done{};
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kPeriod{50};
    static constexpr double kMaxStep = 0.05;  // [s] of simulated time

    void pass(double seconds)
    {
        const int steps = std::max(1, static_cast<int>(std::ceil(seconds / kMaxStep)));
        const Clock::time_point enough = Clock::now() + kPeriod;
        for (int i = 0; i < steps && Clock::now() < enough; ++i) {
            const std::scoped_lock lock(mutex_);
            robot_.step(seconds / steps);
        }
    }

    std::mutex mutex_;  // guards robot_
    SimulatedRobot robot_;
    double speed_;
    Clock::time_point due_ = Clock::now();  // time of the next sample; used by next() only
};

}  // namespace terratact
