#pragma once

#include <fmt/format.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/modelling/truth/laser_truth.h"
#include "app/modelling/truth/truth_file.h"
#include "core/clouds/made_cloud.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/terrain/ground_lines.h"
#include "tests/support/absolem.h"

namespace terratact {

/// Returns heights of a robot that stands level on a floor with a step ahead. The places are 0.1 m apart. Its files
/// are in the directory, whose write(name, text) returns a path.
template <class Directory>
LaserTruth madeTruth(const Directory& directory, int count)
{
    const RobotModel robot = absolem();
    const TerrainProfile ground{{{-2, 0}, {0.9, 0}, {0.9, 0.2}, {3, 0.2}}};
    std::mt19937_64 rng{5};
    std::string poses;
    std::vector<TwoTrackScene> scenes;
    scenes.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        scenes.push_back({.run = "a", .time = static_cast<double>(i), .s = {}, .truth = {}});
        poses += fmt::format("{} {} 0 {} 0 0 0 1\n", i, 0.1 * i, robot.baseHeight);
    }
    const auto points = groundCloud(robot, GroundLines(ground), {}, -1.0, 2.0,
                                    {.density = 20'000, .noise = 0.002}, rng);
    LaserTruthOptions options;
    options.robot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    options.scenes = directory.write("scenes.csv", twoTrackScenesText(scenes));
    options.poses = directory.write("poses.tum", poses);
    options.clouds = {directory.write("map.pcd", pcdText(points))};
    auto truth = laserTruth(options);
    if (!truth) throw std::runtime_error(truth.error().text);
    return *std::move(truth);
}

/// Writes a truth file.
inline Status writeTruthFile(const std::string& path, const LaserTruth& truth,
                             const std::string& robotFile)
{
    auto file = newTruthFile(path, truth, robotFile);
    return file ? file->commit() : file.error();
}

}  // namespace terratact
