#pragma once

#include <array>
#include <optional>

#include "core/robot/force_sensor.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/wire/can_codec.h"

namespace terratact {

/// Forces of the left and right elements; an empty optional was not measured, or the robot lacks
/// the element.
struct ElementForces {
    std::array<std::optional<ElementForce>, kForceElements> left, right;  ///< front flippers
    std::array<std::optional<ElementForce>, kForceElements> rearLeft, rearRight;  ///< rear flippers
    /// the line carried voltages, even if only of elements that the robot lacks
    bool carried = false;
    bool operator==(const ElementForces&) const = default;
};

/// Returns the frames of a line that the robot sends beyond those of every robot.
LineExtent lineExtent(const RobotModel& robot);

/// Converts the voltages of a line to forces. The elements of rear flippers have no bias. A
/// received voltage becomes a force only here, once per line.
ElementForces elementForces(const SensorLine& line, const RobotModel& robot);

/// Converts a line of sensors, its elementForces() and its status to a Measurement. The forces of
/// each side are those of its valid or saturated elements. A force is the mean of left and right, or
/// the value of the one that is not broken. Measurement::missing names forces with both broken, and
/// axles without a current; Measurement::missingMotors names single motors. Empty if attitude or
/// angles are missing: there is no pose.
std::optional<Measurement> measurementOf(const SensorLine& line, const ElementForces& forces,
                                         const RobotStatus& status, double time);

/// Converts a Measurement to a line of sensors, for a simulated robot. The voltages are those that
/// give the forces back. A missing element or force gets 0 V, which reads as a broken wire. Where only
/// the mean of an element is known, both sides get it. Angles are wrapped into one turn. Values beyond
/// their signal's range are sent as its end; a travelled way beyond it is sent as not measured. So is
/// a way without a heading: one frame holds both.
SensorLine sensorLineOf(const Measurement& measurement, const RobotModel& robot);

}  // namespace terratact
