#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/trail/trail_record.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Returns true if no cell of any bin was felt.
inline bool feelsNothing(const TrailGround& ground)
{
    return std::ranges::all_of(ground.felt, [](std::uint16_t cells) { return cells == 0; });
}

/// A robot on level ground with raised front flippers.
struct TrailRecordTest : testing::Test {
    RobotModel robot = absolem();
    TrailRecord record{robot};
    Measurement line;

    TrailRecordTest()
    {
        line.travelled = 2.0;
        line.turned = 0.0;
        line.frontLeft = line.frontRight = 0.7;
        record.add(line);
    }

    void drive(double way, double step = 0.03)
    {
        const auto steps = static_cast<int>(std::lround(std::abs(way) / step));
        for (int k = 0; k < steps; ++k) {
            line.time += 0.1;
            *line.travelled += std::copysign(step, way);
            record.add(line);
        }
    }

    /// Returns the line with pressed flippers, and 5 N on the element next to the tip.
    Measurement press() const
    {
        Measurement scene = line;
        scene.frontLeft = scene.frontRight = 0.0;
        SideForces sides;
        for (std::size_t e = 0; e < sides.left.size(); ++e)
            sides.left[e] = sides.right[e] = e == 4 ? 5.0 : 0.0;
        setSides(scene, sides);
        return scene;
    }

    /// Returns the line with flippers pressed flat on level ground.
    Measurement pressFlat() const
    {
        Measurement scene = press();
        SideForces sides;
        for (std::size_t e = 0; e < sides.left.size(); ++e)
            sides.left[e] = sides.right[e] = e == 0 ? 16.0 : e == 5 ? 5.0 : 10.0;
        setSides(scene, sides);
        return scene;
    }

    double groundHeight() const { return -robot.baseHeight - robot.imu.z; }
};

}  // namespace terratact
