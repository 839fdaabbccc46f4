#pragma once

#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "drivers/measurement_source.h"

namespace terratact {

/// A source with telemetry written by the test, which also reads its commands.
class ScriptedSource final : public MeasurementSource {
public:
    std::string name() const override { return "SCRIPTED"; }

    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override
    {
        std::this_thread::sleep_for(std::min(patience, std::chrono::milliseconds(2)));
        const std::scoped_lock lock(mutex_);
        if (!trouble_.empty()) return Error{trouble_, 5};
        if (silent_) return std::optional<Sample>{};
        ++sample_.measurement.time;
        return std::optional(sample_);
    }

    Status send(const Command& command) override
    {
        const std::scoped_lock lock(mutex_);
        commands_.push_back(command);
        if (deaf_) return Error{"the bus is off", 100};
        if (presses_ && std::holds_alternative<PressCommand>(command))
            sample_.measurement.activity = RobotActivity::Pressing;
        return Done{};
    }

    void setMeasurement(const Measurement& measurement)
    {
        const std::scoped_lock lock(mutex_);
        sample_.measurement = measurement;
    }
    /// Makes the source report pressing as soon as it gets a press command.
    void pressOnCommand()
    {
        const std::scoped_lock lock(mutex_);
        presses_ = true;
    }
    void setSilent(bool silent)
    {
        const std::scoped_lock lock(mutex_);
        silent_ = silent;
    }
    void setDeaf(bool deaf)
    {
        const std::scoped_lock lock(mutex_);
        deaf_ = deaf;
    }
    void setTrouble(const std::string& trouble)
    {
        const std::scoped_lock lock(mutex_);
        trouble_ = trouble;
    }
    std::vector<Command> consumeCommands()
    {
        const std::scoped_lock lock(mutex_);
        return std::exchange(commands_, {});
    }

private:
    std::mutex mutex_;  // guards the members below
    Sample sample_;
    bool silent_ = false, deaf_ = false, presses_ = false;
    std::string trouble_;
    std::vector<Command> commands_;
};

}  // namespace terratact
