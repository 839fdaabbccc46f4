#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/learn/data/drive_copies.h"
#include "core/sim/ground/random_terrain.h"
#include "core/sim/way_drive.h"
#include "core/trail/trail_training.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Returns conditions in which the heights of the scenes have no error.
inline DriveConditions exactHeights()
{
    DriveConditions conditions;
    conditions.noise.height = 0.0;
    return conditions;
}

/// Drives over one varied profile under both tracks.
inline DriveLines driveOnPlane(std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    int skipped = 0;
    const TerrainProfile terrain = randomVariedTerrain(rng);
    const DriveStyle style = randomDriveStyle(rng);
    return driveWay(absolem(), terrain, std::to_string(seed), style, {.spacing = 0.05},
                    exactHeights(), rng, skipped);
}

/// Drives over a varied profile whose right side lies 0.04 m lower.
inline DriveLines driveOnSides(std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    int skipped = 0;
    const TerrainProfile left = randomVariedTerrain(rng);
    std::vector<Vec2> low = left.points();
    for (Vec2& point : low) point.z -= 0.04;
    const RobotModel robot = absolem();
    const GroundLines ground({{robot.lateral.trackY, left},
                              {robot.lateral.flipperY, left},
                              {-robot.lateral.trackY, TerrainProfile(low)},
                              {-robot.lateral.flipperY, TerrainProfile(low)}});
    return driveWay(robot, ground, std::to_string(seed), randomDriveStyle(rng), {.spacing = 0.05},
                    exactHeights(), rng, skipped);
}

/// Options that train two small networks in short time.
inline TrailOptions quickTrailOptions()
{
    TrailOptions options;
    options.networks = 2;
    options.network.hidden = {24};
    options.network.epochs = 30;
    options.network.batch = 32;
    return options;
}

/// Networks of few drives, made once.
inline const TrailData& smallTrail()
{
    static const TrailData data = [] {
        std::vector<DriveLines> plane, sides;
        plane.reserve(11);
        sides.reserve(11);
        for (std::uint64_t k = 0; k < 11; ++k) plane.push_back(driveOnPlane(k));
        for (std::uint64_t k = 0; k < 11; ++k) sides.push_back(driveOnSides(k));
        TrailData trail;
        trail.plane =
            trainTrail(trailRows(plane, 0, absolem(), false, 1), false, quickTrailOptions());
        trail.side = trainTrail(trailRows(sides, 0, absolem(), true, 1), true, quickTrailOptions());
        for (const DriveLines& drive : plane) trail.plane.drives.push_back(driveMarks(drive));
        for (const DriveLines& drive : sides) trail.side.drives.push_back(driveMarks(drive));
        trail.command = "terratact train";
        trail.planeHash = std::string(64, 'a');
        trail.sideHash = std::string(64, 'b');
        return trail;
    }();
    return data;
}

}  // namespace terratact
