#include "core/sim/two_track_drive.h"

#include <stdexcept>

namespace terratact {

std::vector<TwoTrackScene> driveOver(const RobotModel& robot, const GroundLines& terrain,
                                     const std::vector<double>& stops, const std::string& run,
                                     const DriveStyle& style, const DriveConditions& conditions,
                                     std::mt19937_64& rng, int& skipped)
{
    if (conditions.reading || conditions.rested || conditions.slide > 0.0)
        throw std::invalid_argument("driveOver: two tracks know noise and ground alone");
    const PerFlipper<FlipperDrive> drives =
        flipperDrives(PressTorque{style.pressTorque}, HoldAngle{style.rearAngle});
    std::vector<TwoTrackScene> scenes;
    RestStart start;
    for (const double x : stops) {
        const auto rest = restPose(robot, terrain, x, drives, start, conditions.ground);
        if (!rest) {
            ++skipped;
            continue;
        }
        start = {rest->pose.pitch, rest->pose.roll};
        if (conditions.stood) conditions.stood(rest->pose);
        const Vec2 imu = imuPosition(robot, rest->pose);
        TwoTrackScene scene{
            .run = run,
            .time = (x - stops.front()) / kDriveSpeed,
            .s = noisy(exactReadings(robot, *rest), conditions.noise, robot.forceSaturation, rng),
            .truth = {}};
        for (const Side side : {Side::Left, Side::Right})
            scene.truth[indexOf(side)] =
                known(noisy(sideHeights(terrain, robot, side, imu), conditions.noise, rng));
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

}  // namespace terratact
