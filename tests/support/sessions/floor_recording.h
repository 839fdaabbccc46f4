#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mapping/standing_presses.h"
#include "core/sim/simulated_robot.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// A robot whose sensors have errors: reading = truth + error.
struct FloorRobot {
    RobotModel robot;
    PerFlipper<double> encoders{};              ///< [rad]
    double pitch = 0.0, roll = 0.0, yaw = 0.0;  ///< [rad] of the IMU; yaw to the left
};

/// Held flipper angles, front and rear [rad].
using FloorPoses = std::vector<std::pair<double, double>>;
inline const FloorPoses kFloorPoses{{0.7, 0.6},   {-0.2, 0.6}, {-0.35, 0.6}, {-0.5, 0.6},
                                    {-0.65, 0.6}, {-0.8, 0.6}, {-0.95, 0.6}, {0.7, -0.2},
                                    {0.7, -0.35}, {0.7, -0.5}, {0.7, -0.65}, {0.7, -0.8},
                                    {-0.4, -0.4}, {-0.6, -0.3}};
inline const FloorPoses kRaisedFloorPoses{{0.7, 0.6}, {0.4, 0.3}, {0.9, 0.8}, {0.5, 0.7}};

/// Returns the telemetry of a simulated robot on a flat floor at 20 Hz. Each pose is held for two seconds. If
/// `presses`, the front flippers press with 12 N m after the first one.
inline std::vector<TelemetryLine> floorRecording(const FloorRobot& truth, std::uint64_t seed,
                                                 const FloorPoses& poses = kFloorPoses,
                                                 bool presses = true)
{
    const TerrainProfile floor(std::vector<Vec2>{{-3.0, 0.0}, {5.0, 0.0}});
    SimulatedRobot::Options options;
    options.seed = seed;
    SimulatedRobot robot(truth.robot, floor, options);
    std::vector<TelemetryLine> lines;
    const auto run = [&](double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(20.0 * seconds)); ++i) {
            robot.step(0.05);
            Measurement m = robot.measure();
            const double pitch = robot.pose().pitch;
            m.pitch += truth.pitch;
            m.roll += truth.roll - truth.yaw * std::sin(pitch);
            m.frontLeft += truth.encoders[0], m.frontRight += truth.encoders[1];
            m.rearLeft += truth.encoders[2], m.rearRight += truth.encoders[3];
            lines.push_back({static_cast<std::int64_t>(lines.size()) * 50'000'000, m});
        }
    };
    const auto hold = [&](std::pair<double, double> pose) {
        robot.command(HoldFlippersCommand{pose.first, pose.second});
        run(5.0);
    };
    hold(poses.front());
    if (presses) {
        robot.command(PressCommand{12.0});
        run(5.0);
    }
    for (const auto& pose : poses) hold(pose);
    return lines;
}

}  // namespace terratact
