#include "app/modelling/simulation/simulated_drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "app/runtime/parallel.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/ground_file.h"
#include "core/learn/data/profile_file.h"
#include "core/sim/drive.h"
#include "core/sim/ground/random_ground.h"
#include "core/sim/ground/random_terrain.h"

namespace terratact {
namespace {

/// Grounds of the drives: `count`, of which `of` makes or finds number k.
template <class Ground>
struct WayGrounds {
    int count = 0;
    std::function<Ground(int k, std::mt19937_64& rng)> of;
    std::function<int(int k)> number;  ///< of its run
};

template <class Ground>
WayGrounds<Ground> randomGrounds(int count, std::function<Ground(std::mt19937_64&)> make)
{
    return {.count = count,
            .of = [make = std::move(make)](int, std::mt19937_64& rng) { return make(rng); },
            .number = [](int k) { return k + 1; }};
}

/// Returns at most `most` grounds, at equal distances in the file.
template <class Ground>
WayGrounds<Ground> groundsAmong(const std::vector<Ground>& all, int most)
{
    const std::size_t count = std::min(all.size(), static_cast<std::size_t>(most));
    const auto place = [count, size = all.size()](int k) {
        return static_cast<std::size_t>(k) * size / count;
    };
    return {.count = static_cast<int>(count),
            .of = [&all, place](int k, std::mt19937_64&) { return all[place(k)]; },
            .number = [place](int k) { return static_cast<int>(place(k)) + 1; }};
}

struct DrivePart {
    std::string text;
    std::size_t lines = 0, scenes = 0;
    int skipped = 0;
};

template <class Ground>
DrivePart drivePart(const RobotModel& robot, const SimulatedDrives& options,
                    const WayGrounds<Ground>& grounds, int k)
{
    const std::uint64_t seed = options.grounds.seed;
    std::seed_seq words{seed & 0xffffffffU, seed >> 32U, static_cast<std::uint64_t>(k)};
    std::mt19937_64 rng(words);
    const Ground ground = grounds.of(k, rng);
    const DriveStyle style = randomDriveStyle(rng);
    DriveConditions conditions;
    if (options.exactTruth) conditions.noise.height = 0.0;
    if (std::uniform_real_distribution<double>()(rng) < options.softDrives)
        conditions.ground = randomSoftGround(rng);
    DrivePart part;
    DriveLines drive = driveWay(robot, ground, std::to_string(grounds.number(k)), style,
                                options.way, conditions, rng, part.skipped);
    // A flipper wedged in a gap may press with more than its motor can.
    std::erase_if(drive.lines, [&](const DriveLine& line) {
        const bool isRefused = !isPlausible(drive, line);
        part.skipped += isRefused && line.isScene ? 1 : 0;
        return isRefused;
    });
    part.text = driveText(drive);
    part.lines = drive.lines.size();
    part.scenes =
        static_cast<std::size_t>(std::ranges::count(drive.lines, true, &DriveLine::isScene));
    return part;
}

/// Returns how many of the first drives have at most so many lines together.
std::size_t drivesThatFit(const std::vector<DrivePart>& parts, std::size_t most)
{
    std::size_t count = 0;
    for (std::size_t lines = 0; count < parts.size(); ++count)
        if ((lines += parts[count].lines) > most) break;
    return count;
}

template <class Ground>
Result<DriveRecording> recordingOver(const RobotModel& robot, const SimulatedDrives& options,
                                     const WayGrounds<Ground>& grounds)
{
    std::vector<DrivePart> parts(static_cast<std::size_t>(grounds.count));
    std::atomic<std::size_t> lines = 0;
    parallelFor(
        grounds.count,
        [&](int k) {
            if (lines > options.maxLines) return;
            DrivePart& part = parts[static_cast<std::size_t>(k)];
            part = drivePart(robot, options, grounds, k);
            lines += part.lines;
        },
        options.threads);
    if (lines > options.maxLines)
        return Error{
            fmt::format("the drives have more than {} lines, the most that a file holds: ask "
                        "for {} drives, and write others to a second file with another seed",
                        options.maxLines, drivesThatFit(parts, options.maxLines)),
            0};
    DriveRecording recording;
    recording.parts.reserve(parts.size() + 1);
    recording.parts.push_back(drivesHeader(!options.tracks));
    for (DrivePart& part : parts) {
        recording.drives += part.lines > 0 ? 1 : 0;
        recording.lines += part.lines;
        recording.scenes += part.scenes;
        recording.skipped += part.skipped;
        recording.parts.push_back(std::move(part.text));
    }
    return recording;
}

Result<DriveRecording> recordingOnPlane(const RobotModel& robot, const SimulatedDrives& options)
{
    const DrivenGrounds& from = options.grounds;
    if (from.terrain == "varied")
        return recordingOver(robot, options,
                             randomGrounds<TerrainProfile>(options.drives, randomVariedTerrain));
    const auto file = readProfiles(from.terrain, from.step, from.blocks);
    if (!file) return file.error();
    return recordingOver(robot, options, groundsAmong(file->profiles, options.drives));
}

Result<DriveRecording> recordingOnTracks(const RobotModel& robot, const SimulatedDrives& options)
{
    const DrivenGrounds& from = options.grounds;
    if (from.terrain == "varied") {
        const auto make = [ys = groundYs(robot)](std::mt19937_64& rng) {
            const GroundKind kind = randomGroundKind(rng);
            return randomGround(kind, ys, rng);
        };
        return recordingOver(robot, options, randomGrounds<GroundLines>(options.drives, make));
    }
    const auto file = readGrounds(from.terrain, from.step, from.blocks);
    if (!file) return file.error();
    return recordingOver(robot, options, groundsAmong(file->grounds, options.drives));
}

}  // namespace

Result<DriveRecording> simulateDrives(const RobotModel& robot, const SimulatedDrives& options)
{
    return options.tracks ? recordingOnTracks(robot, options) : recordingOnPlane(robot, options);
}

}  // namespace terratact
