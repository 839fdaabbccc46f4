#include "core/wire/telemetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terratact {
namespace {

constexpr std::size_t kPerFrame = 3;  ///< voltages

bool isWhole(const std::optional<ElementForce>& element)
{
    return element
        && (element->state == ElementState::Sound || element->state == ElementState::Saturated);
}

using Elements = std::array<std::optional<ElementForce>, kForceElements>;

SideForces sideForces(const Elements& left, const Elements& right)
{
    const auto whole = [](const std::optional<ElementForce>& element) {
        return isWhole(element) ? std::optional(element->force) : std::nullopt;
    };
    SideForces sides;
    for (std::size_t e = 0; e < sides.left.size(); ++e) {
        sides.left[e] = whole(left[e]);
        sides.right[e] = whole(right[e]);
    }
    return sides;
}

void addCurrents(Measurement& m, const SensorLine& line)
{
    setCurrents(m, {line.frontCurrents.left, line.frontCurrents.right, line.rearCurrents.left,
                    line.rearCurrents.right});
}

double clamped(FrameKind kind, std::size_t signal, double value)
{
    const SignalLayout& layout = layoutOf(kind).payload[signal];
    return std::clamp(value, layout.least, layout.most);
}

Pair angles(double left, double right)
{
    constexpr double kTurn = 2.0 * std::numbers::pi;
    return {std::remainder(left, kTurn), std::remainder(right, kTurn)};
}

AxleCurrents currents(FrameKind kind, const std::optional<double>& left,
                      const std::optional<double>& right)
{
    AxleCurrents axle;
    if (left) axle.left = clamped(kind, 0, *left);
    if (right) axle.right = clamped(kind, 1, *right);
    return axle;
}

// Returns the resistance at which the curve has this force [Ω].
double curveResistance(double force, const std::vector<ForcePoint>& curve)
{
    std::size_t i = 1;
    while (i + 1 < curve.size() && force > curve[i].force) ++i;
    const ForcePoint& a = curve[i - 1];
    const ForcePoint& b = curve[i];
    const double share = std::log(force / a.force) / std::log(b.force / a.force);
    return a.resistance * std::pow(b.resistance / a.resistance, share);
}

double voltageOf(double force, double bias, const RobotModel& robot)
{
    const ForceCalibration& c = robot.forceCalibration;
    const double total = std::clamp(force + bias, 1e-6, robot.forceSaturation);
    const double voltage = c.supply * c.reference / (c.reference + curveResistance(total, c.curve));
    return std::clamp(voltage, c.openBelow, c.shortAbove);
}

/// Returns the odometry. It is also empty for a way beyond its signal: a constant limit would look
/// like a standing robot. It is empty without a heading: 0 would look like a robot that never turns.
std::optional<SensorLine::Odometry> odometryOf(const Measurement& m)
{
    const SignalLayout& way = layoutOf(FrameKind::Odometry).payload[0];
    if (!m.travelled || *m.travelled < way.least || *m.travelled > way.most) return std::nullopt;
    if (!m.turned) return std::nullopt;
    return SensorLine::Odometry{*m.travelled, std::remainder(*m.turned, 2.0 * std::numbers::pi)};
}

/// Place of a set of voltages of SensorLine.
struct VoltageSet {
    explicit VoltageSet(std::size_t set)
        : side(set % 4 < 2 ? Side::Left : Side::Right), isRear(set >= 4),
          firstElement(kPerFrame * (set % 2))
    {
    }
    Side side;
    bool isRear;
    std::size_t firstElement;
};

bool isWired(const RobotModel& robot, const VoltageSet& set, std::size_t element)
{
    return set.isRear ? robot.rearElementShare.has_value()
                      : haveElement(robot.forceArrays, set.side, static_cast<int>(element));
}

/// Returns the calibration of the rear elements: without a bias.
ForceCalibration rearCalibration(ForceCalibration front)
{
    front.biasLeft = front.biasRight = {};
    return front;
}

SensorLine::Three voltages(const Measurement& m, std::size_t set, const RobotModel& robot)
{
    const VoltageSet place(set);
    const ForceCalibration& c = robot.forceCalibration;
    const SideForces& sides = place.isRear ? m.rearSides : m.sides;
    const auto& side = place.side == Side::Left ? sides.left : sides.right;
    const auto& bias = place.side == Side::Left ? c.biasLeft : c.biasRight;
    SensorLine::Three three{};
    for (std::size_t i = 0; i < kPerFrame; ++i) {
        const std::size_t e = place.firstElement + i;
        std::optional<double> force = side[e];
        if (!place.isRear && m.missing[kFirstForceFeature + e])
            force.reset();
        else if (!place.isRear && !sides.knows(e))
            force = m.force[e];
        if (!isWired(robot, place, e)) force.reset();
        const double voltage = force ? voltageOf(*force, place.isRear ? 0.0 : bias[e], robot) : 0.0;
        three[i] = clamped(FrameKind::LeftForces1To3, i, voltage);
    }
    return three;
}

}  // namespace

LineExtent lineExtent(const RobotModel& robot)
{
    return {.rearForces = robot.rearElementShare.has_value(),
            .differential = !robot.differential.locked};
}

ElementForces elementForces(const SensorLine& line, const RobotModel& robot)
{
    const ForceCalibration ofRear = rearCalibration(robot.forceCalibration);
    ElementForces forces;
    for (std::size_t set = 0; set < line.voltages.size(); ++set) {
        if (!line.voltages[set]) continue;
        forces.carried = true;
        const VoltageSet place(set);
        auto& left = place.isRear ? forces.rearLeft : forces.left;
        auto& right = place.isRear ? forces.rearRight : forces.right;
        auto& array = place.side == Side::Left ? left : right;
        for (std::size_t i = 0; i < kPerFrame; ++i) {
            const std::size_t e = place.firstElement + i;
            if (!isWired(robot, place, e)) continue;
            array[e] =
                elementForce((*line.voltages[set])[i], place.side, static_cast<int>(e),
                             place.isRear ? ofRear : robot.forceCalibration, robot.forceSaturation);
        }
    }
    return forces;
}

std::optional<Measurement> measurementOf(const SensorLine& line, const ElementForces& forces,
                                         const RobotStatus& status, double time)
{
    if (!line.attitude || !line.frontAngles || !line.rearAngles) return std::nullopt;
    Measurement m{.time = time,
                  .pitch = line.attitude->pitch,
                  .roll = line.attitude->roll,
                  .frontLeft = line.frontAngles->left,
                  .frontRight = line.frontAngles->right,
                  .rearLeft = line.rearAngles->left,
                  .rearRight = line.rearAngles->right,
                  .activity = status.activity,
                  .refusal = status.refusal,
                  .arm = line.arm,
                  .travelled =
                      line.odometry ? std::optional(line.odometry->travelled) : std::nullopt,
                  .turned = line.odometry ? std::optional(line.odometry->turned) : std::nullopt};
    addCurrents(m, line);
    setSides(m, sideForces(forces.left, forces.right));
    m.rearSides = sideForces(forces.rearLeft, forces.rearRight);
    m.differential = line.differential;
    return m;
}

SensorLine sensorLineOf(const Measurement& m, const RobotModel& robot)
{
    SensorLine line;
    line.odometry = odometryOf(m);
    line.attitude = SensorLine::Attitude{clamped(FrameKind::Attitude, 0, m.pitch),
                                         clamped(FrameKind::Attitude, 1, m.roll)};
    line.frontAngles = angles(m.frontLeft, m.frontRight);
    line.rearAngles = angles(m.rearLeft, m.rearRight);
    const MotorCurrents motors = motorCurrents(m);
    line.frontCurrents = currents(FrameKind::FrontCurrents, motors[0], motors[1]);
    line.rearCurrents = currents(FrameKind::RearCurrents, motors[2], motors[3]);
    const LineExtent extent = lineExtent(robot);
    const std::size_t sets = extent.rearForces ? line.voltages.size() : line.voltages.size() / 2;
    for (std::size_t set = 0; set < sets; ++set) line.voltages[set] = voltages(m, set, robot);
    if (extent.differential && m.differential)
        line.differential = clamped(FrameKind::Differential, 0, *m.differential);
    line.arm = m.arm;
    if (line.arm) {
        line.arm->height = clamped(FrameKind::ArmResult, 1, line.arm->height);
        // The sd is at least one raw step: a reading is never exact.
        line.arm->sd = std::max(clamped(FrameKind::ArmResult, 2, line.arm->sd),
                                layoutOf(FrameKind::ArmResult).payload[2].scale);
    }
    return line;
}

}  // namespace terratact
