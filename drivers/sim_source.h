#pragma once

#include <chrono>
#include <mutex>

#include "core/sim/simulated_robot.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// The simulated robot behind the interface of a real one: a line of telemetry every 50 ms of the
/// steady clock, with the true terrain.
class SimSource final : public MeasurementSource {
public:
    static constexpr std::chrono::milliseconds kPeriod{50};

    /// speed: simulated seconds per second, so that a probe of 45 s can be shown in less.  Simulated
    /// time is stepped by at most 50 ms; where the machine cannot keep up, it runs slower and never
    /// catches up in a burst.  Throws std::invalid_argument unless 0 < speed ≤ 1000.
    explicit SimSource(SimulatedRobot robot, double speed = 1.0);

    std::string name() const override { return "SIMULATED ROBOT"; }
    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override;

    /// Takes effect at once, between two steps of simulated time.
    Status send(const Command& command) override;

private:
    using Clock = std::chrono::steady_clock;

    std::mutex mutex_;  // guards robot_
    SimulatedRobot robot_;
    double speed_;
    Clock::time_point due_;  // of the next line; only next() touches it
};

}  // namespace terratact
