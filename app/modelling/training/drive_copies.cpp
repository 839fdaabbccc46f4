#include "app/modelling/training/drive_copies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/two_tracks.h"

namespace terratact {
namespace {

std::vector<float> sceneReadings(const DriveLines& drive)
{
    std::vector<float> readings;
    for (const DriveLine& line : drive.lines) {
        if (!line.isScene) continue;
        const TwoTrackReadings s = twoTrackReadings(line.line);
        readings.push_back(static_cast<float>(s.pitch));
        for (const double angle : s.flippers) readings.push_back(static_cast<float>(angle));
        readings.push_back(static_cast<float>(line.line.travelled.value_or(0.0)));
    }
    return readings;
}

}  // namespace

bool DriveCopies::isCopy(const DriveLines& drive)
{
    std::vector<float> readings = sceneReadings(drive);
    if (readings.empty()) return false;
    const auto [first, last] = known_.equal_range(drive.lines.size());
    const bool isKnown = std::any_of(first, last, [&readings](const auto& known) {
        return std::ranges::equal(known.second, readings, [](float a, float b) {
            return std::abs(a - b) <= kRewrittenReading;
        });
    });
    if (!isKnown) known_.emplace(drive.lines.size(), std::move(readings));
    return isKnown;
}

}  // namespace terratact
