#include "core/learn/data/drive_lines.h"

namespace terratact {

std::vector<Scene> planeScenesOf(const DriveLines& drive)
{
    std::vector<Scene> scenes;
    for (const DriveLine& line : drive.lines)
        if (line.isScene)
            scenes.push_back({.run = drive.run,
                              .time = line.line.time,
                              .s = proprioception(line.line),
                              .truth = line.truth[0],
                              .truthSd = line.truthSd[0]});
    return scenes;
}

std::vector<TwoTrackScene> trackScenesOf(const DriveLines& drive)
{
    std::vector<TwoTrackScene> scenes;
    for (const DriveLine& line : drive.lines)
        if (line.isScene)
            scenes.push_back({.run = drive.run,
                              .time = line.line.time,
                              .s = twoTrackReadings(line.line),
                              .truth = line.truth,
                              .truthSd = line.truthSd});
    return scenes;
}

}  // namespace terratact
