#pragma once

#include <functional>
#include <mutex>
#include <thread>

#include "app/link/robot_service.h"
#include "drivers/measurement_source.h"
#include "drivers/memory_bus.h"

namespace terratact {

/// Returns the true heights at the robot's pose.
TrueHeights trueHeights(const SimulatedRobot& robot);

/// A simulated robot in its own thread at the end "robot" of a MemoryBus. It runs until its destruction; the bus must
/// outlive it.
class RobotInProcess {
public:
    /// clock: the robot's monotonic clock [s]
    RobotInProcess(MemoryBus& bus, const RobotModel& model, const SimulatedRobot& robot,
                   const RobotOnBus::Options& options,
                   const std::function<double()>& clock = steadyNow);

    /// Returns the true bin heights at the pose of the newest sample; callable from any thread.
    TrueHeights truth() const;

private:
    std::unique_ptr<CanBus> end_;
    RobotOnBus robot_;  // used by the thread only, with the end of the bus
    mutable std::mutex mutex_;
    TrueHeights truth_;
    std::jthread thread_;  // last member: the thread starts after all others exist
};

}  // namespace terratact
