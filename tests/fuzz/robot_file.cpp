// Fuzzes robot files. Accepted robots have computable geometry and force elements.
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/robot/kinematics.h"
#include "core/robot/robot_model.h"
#include "core/robot/toml_depth.h"
#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

namespace {

constexpr int kDeepest = 16;  // limit of readRobotModel()

int depthOf(const toml::node& node)
{
    int deepest = 0;
    if (const toml::table* const table = node.as_table())
        for (const auto& [key, value] : *table) deepest = std::max(deepest, 1 + depthOf(value));
    if (const toml::array* const array = node.as_array())
        for (const toml::node& value : *array) deepest = std::max(deepest, 1 + depthOf(value));
    return deepest;
}

/// Checks that nestingDepth() bounds the depth: a header, and a dotted key with its value, at most twice together.
void promiseDepth(const std::string& text)
{
    const int bound = nestingDepth(text);
    if (bound > kDeepest) return;
    try {
        promise(depthOf(toml::parse(std::string_view(text))) <= 2 * (bound + 1),
                "no text nests deeper than it was measured");
    } catch (const toml::parse_error&) {
        return;
    }
}

void promiseShape(const RobotModel& robot)
{
    for (const double angle : {-1.2, 0.0, 0.7}) {
        const RobotShape shape = shapeAt(robot, poseInDem(robot, 0.3 * angle, angle, -angle));
        for (double x = -1.0; x <= 1.0; x += 0.125) {
            const double z = lowerEnvelope(shape, x);
            promise(z > -100.0, "the robot's lower boundary is near it, or +infinity");
        }
    }
    for (const double share : robot.elementShare) {
        const Vec2 at = elementPosition(robot, poseInDem(robot, 0.1, 0.2, 0.3), share);
        promise(std::isfinite(at.x) && std::isfinite(at.z), "an element is somewhere");
    }
}

void promiseForces(const RobotModel& robot)
{
    promise(!robot.forceArrays.empty() && robot.forceArrays.size() <= kMaxForceArrays,
            "a console can show the arrays");
    for (int e = 0; e < kForceElements; ++e)
        promise(haveElement(robot.forceArrays, Side::Left, e)
                    || haveElement(robot.forceArrays, Side::Right, e),
                "each of the six forces is measured");
    const ForceCalibration& calibration = robot.forceCalibration;
    for (int tenth = -1; tenth <= 11; ++tenth)
        for (const Side side : {Side::Left, Side::Right}) {
            const double voltage = 0.1 * tenth * calibration.supply;
            const double force =
                elementForce(voltage, side, 0, calibration, robot.forceSaturation).force;
            promise(force >= 0.0 && force <= robot.forceSaturation,
                    "a force is between 0 and saturation");
        }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text = textOf(data, size);
    promiseDepth(text);
    const Result<RobotModel> robot = robotModelFrom("f", text);
    if (!robot) return promiseRefusal(robot.error(), "f"), 0;
    promise(robot->totalMass() > 0.0 && std::isfinite(robot->totalMass()), "a robot has a mass");
    promise(std::isfinite(robot->front.edgeLength()) && robot->front.edgeLength() >= 0.0,
            "a flipper has a length");
    promiseShape(*robot);
    promiseForces(*robot);
    return 0;
}
