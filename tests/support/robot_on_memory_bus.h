#pragma once

#include <memory>
#include <string>
#include <thread>

#include "app/robot_service.h"
#include "app/steady_now.h"
#include "core/sim/robot_on_bus.h"
#include "tests/support/memory_bus.h"

namespace terratact {

/// An end of a MemoryBus that gives every frame the time at which it is sent.
class TimedEnd final : public CanBus {
public:
    TimedEnd(MemoryBus& bus, const std::string& name, std::size_t window)
        : bus_(bus), end_(bus.join(name, window))
    {
    }
    std::string name() const override { return end_->name(); }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override
    {
        return end_->receive(frames, patience);
    }
    Status send(const CanFrame& frame) override
    {
        bus_.setTime(steadyNow());
        return end_->send(frame);
    }
    BusState state() const override { return end_->state(); }
    BusCounters counters() const override { return end_->counters(); }

private:
    MemoryBus& bus_;
    std::unique_ptr<CanBus> end_;
};

/// A simulated robot that lives in a thread of its own on the end "robot" of a MemoryBus.
class RobotOnMemoryBus {
public:
    RobotOnMemoryBus(MemoryBus& bus, const RobotModel& model, const SimulatedRobot& robot,
                     const RobotOnBus::Options& options)
        : end_(bus, "robot", 0), robot_(model, robot, options),
          thread_([this](const std::stop_token& stop) {
              (void)serveRobot(
                  end_, robot_, [&] { return !stop.stop_requested(); }, [](const std::string&) {});
          })
    {
    }

private:
    TimedEnd end_;
    RobotOnBus robot_;
    std::jthread thread_;
};

}  // namespace terratact
