#pragma once

#include <mutex>
#include <thread>

#include "app/link/robot_service.h"
#include "drivers/memory_bus.h"

namespace terratact {

/// A simulated robot that lives in a thread of its own on the end "robot" of a MemoryBus.  Until it is
/// destroyed; the bus must outlive it.
class RobotInProcess {
public:
    RobotInProcess(MemoryBus& bus, const RobotModel& model, const SimulatedRobot& robot,
                   const RobotOnBus::Options& options);

    /// True bin heights at the pose of the newest line of telemetry; from any thread.
    Heights truth() const;

private:
    std::unique_ptr<CanBus> end_;
    RobotOnBus robot_;  // only the thread touches these two
    mutable std::mutex mutex_;
    Heights truth_;
    std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace terratact
