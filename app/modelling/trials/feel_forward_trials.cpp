#include "app/modelling/trials/feel_forward_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string_view>
#include <utility>

#include "app/modelling/trials/feel_forward_simulation.h"
#include "app/runtime/parallel.h"
#include "core/atem/feel_forward.h"
#include "core/sim/drive.h"

namespace terratact {
namespace {

constexpr double kStart = 1.2;  // [m] hazards begin at kHazardBegin

std::string hazardName(const FeelForwardDrive& drive)
{
    std::string text = drive.hazard ? std::string(name(*drive.hazard)) : std::string("none");
    if (drive.tracks && drive.hazard) text += drive.onBothSides ? ", both sides" : ", one side";
    return text;
}

FeelForwardLine sumOf(std::string what, std::span<const FeelForwardDrive> drives,
                      std::span<const FeelForwardCounts> counts,
                      const std::function<bool(const FeelForwardDrive&)>& counted)
{
    FeelForwardLine line{std::move(what), {}};
    for (std::size_t i = 0; i < drives.size(); ++i)
        if (counted(drives[i])) line.counts += counts[i];
    return line;
}

void addKinds(std::vector<FeelForwardLine>& lines, std::span<const FeelForwardDrive> drives,
              std::span<const FeelForwardCounts> counts, bool tracks)
{
    const std::string kind = tracks ? "two tracks" : "one plane";
    std::vector<std::string> hazards;
    for (const FeelForwardDrive& drive : drives)
        if (drive.tracks == tracks
            && std::ranges::find(hazards, hazardName(drive)) == hazards.end())
            hazards.push_back(hazardName(drive));
    for (const std::string& hazard : hazards)
        lines.push_back(
            sumOf(fmt::format("{}, {}", kind, hazard), drives, counts, [&](const auto& drive) {
                return drive.tracks == tracks && hazardName(drive) == hazard;
            }));
    for (std::size_t g = 0; g < kHazardGrounds.size(); ++g)
        lines.push_back(
            sumOf(fmt::format("{}, {}", kind, kHazardGrounds[g].name), drives, counts,
                  [&](const auto& drive) { return drive.tracks == tracks && drive.ground == g; }));
    lines.push_back(sumOf(kind + ", all", drives, counts,
                          [&](const auto& drive) { return drive.tracks == tracks; }));
}

template <class Key>
void add(std::map<Key, std::size_t>& sum, const std::map<Key, std::size_t>& counts)
{
    for (const auto& [key, count] : counts) sum[key] += count;
}

constexpr std::string_view kLegend = R"(
falls, collisions: drives in which an advance of the loop led the tracks over a fall, or into a rise, above the limit.
  A tilt beyond the red limit, and a pose without rest, count as falls.
touches: advances in which a raised front flipper touched ground above the limit
loop m, m/min: true way of the loop's advances, and the pace of the loops, with the press that ends each
hand m: way between two loops, on ground that is truly free: the operator drives on by hand and holds again
hazard, end: drives that ended before a true step, and at the end of the ground
)";

}  // namespace

FeelForwardCounts& FeelForwardCounts::operator+=(const FeelForwardCounts& other)
{
    drives += other.drives;
    presses += other.presses;
    advances += other.advances;
    advanced += other.advanced;
    byHand += other.byHand;
    seconds += other.seconds;
    add(ends, other.ends);
    add(failures, other.failures);
    falls += other.falls;
    collisions += other.collisions;
    touches += other.touches;
    beforeHazard += other.beforeHazard;
    atEnd += other.atEnd;
    return *this;
}

double FeelForwardCounts::metresPerMinute() const
{
    return seconds > 0.0 ? 60.0 * advanced / seconds : 0.0;
}

std::vector<FeelForwardDrive> feelForwardDrives(int drives, bool tracks)
{
    std::vector<FeelForwardDrive> list;
    list.reserve(static_cast<std::size_t>(drives));
    // Two drives a kind: one plane and two tracks. One kind without a hazard follows the seven hazards.
    constexpr std::size_t kKinds = kHazards.size() + 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(drives); ++i) {
        const std::size_t kind = i / 2 % kKinds, round = i / (2 * kKinds);
        FeelForwardDrive drive{.ground = (i + i / 24) % kHazardGrounds.size(),
                               .tracks = tracks && i % 2 == 1,
                               .onBothSides = (kind + round) % 2 == 1};
        if (kind < kHazards.size()) drive.hazard = kHazards[kind];
        list.push_back(drive);
    }
    return list;
}

FeelForwardCounts feelForwardOnce(const EstimatorBundle& bundle, const FeelForwardTrial& trial,
                                  const FeelForwardDrive& drive, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    const HazardGround& ground = kHazardGrounds[drive.ground];
    GroundLines lines = drive.tracks
                          ? hazardLines(bundle.robot, ground, drive.hazard, drive.onBothSides, rng)
                          : GroundLines(hazardProfile(ground, drive.hazard, rng));
    SimulatedRobot::Options options;
    options.startX = kStart;
    options.seed = seed;
    if (ground.isSoft) options.ground = randomSoftGround(rng);
    return FeelForwardSimulation(bundle, trial, std::move(lines), options).run();
}

std::vector<FeelForwardLine> tryFeelForward(const EstimatorBundle& bundle,
                                            const FeelForwardTrial& trial)
{
    const std::vector<FeelForwardDrive> drives =
        feelForwardDrives(trial.drives, bundle.models.sides.has_value());
    std::vector<FeelForwardCounts> counts(drives.size());
    parallelFor(trial.drives, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        counts[i] = feelForwardOnce(bundle, trial, drives[i], trial.seed * 10'000'019 + i);
    });
    std::vector<FeelForwardLine> lines;
    addKinds(lines, drives, counts, false);
    if (bundle.models.sides) addKinds(lines, drives, counts, true);
    lines.push_back(sumOf("all", drives, counts, [](const auto&) { return true; }));
    return lines;
}

std::string feelForwardTable(std::span<const FeelForwardLine> lines, const RobotModel& robot,
                             const FeelForwardTrial& trial)
{
    std::string text = fmt::format("time model: flippers {:.2f} rad/s, advance {:.2f} m at "
                                   "0.1 m/s, estimate {:.2f} s\n\n",
                                   robot.flipperSpeed, kAdvance, trial.estimateSeconds);
    text += fmt::format("{:<32}{:>7}{:>7}{:>7}{:>9}{:>8}{:>8}{:>8}{:>7}{:>8}{:>7}{:>5}\n", "ground",
                        "drives", "press", "falls", "collide", "touch", "loop m", "hand m", "m/min",
                        "faults", "hazard", "end");
    for (const auto& [what, c] : lines) {
        std::size_t faults = 0;
        for (const auto& [failure, count] : c.failures) faults += count;
        text +=
            fmt::format("{:<32}{:>7}{:>7}{:>7}{:>9}{:>8}{:>8.1f}{:>8.1f}{:>7.2f}{:>8}{:>7}{:>5}\n",
                        what, c.drives, c.presses, c.falls, c.collisions, c.touches, c.advanced,
                        c.byHand, c.metresPerMinute(), faults, c.beforeHazard, c.atEnd);
    }
    if (lines.empty()) return text;
    text += "\nends of the loop, all drives\n";
    for (const auto& [end, count] : lines.back().counts.ends)
        text += fmt::format("{:>6}  {}\n", count,
                            end == LoopEnd::None ? "a fall or a collision" : describe(end).english);
    for (const auto& [failure, count] : lines.back().counts.failures)
        text += fmt::format("{:>6}  fault: {}\n", count, describe(failure).english);
    return text.append(kLegend);
}

}  // namespace terratact
