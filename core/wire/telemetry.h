#pragma once

#include <array>
#include <optional>

#include "core/robot/force_sensor.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/wire/can_codec.h"

namespace terratact {

/// What the elements left and right feel; an empty optional was not measured, or is none of the robot's.
struct ElementForces {
    std::array<std::optional<ElementForce>, kForceElements> left, right;
    bool operator==(const ElementForces&) const = default;
};

ElementForces elementForces(const SensorLine& line, const RobotModel& robot);

/// A line of sensors and the status beside it as the rest of the core knows them.  A force is the mean of
/// left and right, or the one of them that is not broken; Measurement::missing where both are, and where
/// currents were not measured.  Empty optional where attitude or angles were not: there is no pose.
std::optional<Measurement> measurementOf(const SensorLine& line, const RobotStatus& status,
                                         const RobotModel& robot, double time);

/// The other way round, for a robot that is simulated: the voltages are those that give the forces back, and 0
/// where the robot has no element or its force is missing, which reads as a broken wire.
/// Angles are wrapped into one turn; values beyond their signal's range are sent as its end, but a travelled
/// way as not measured.
SensorLine sensorLineOf(const Measurement& measurement, const RobotModel& robot);

}  // namespace terratact
