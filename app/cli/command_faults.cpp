#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "app/cli/commands.h"
#include "app/modelling/scene_estimates.h"
#include "app/modelling/simulation/driven_grounds.h"
#include "app/runtime/parallel.h"
#include "app/runtime/print_text.h"
#include "app/runtime/progress.h"
#include "core/eval/evaluation.h"
#include "core/infer/verdict/verdict.h"
#include "core/sim/fault_matrix.h"
#include "core/sim/fault_trial.h"
#include "core/sim/watched_drive.h"

namespace terratact {
namespace {

using WatchedDrives = std::vector<std::vector<WatchedLine>>;

constexpr double kLeastBack =
    3.0;  // [m] else a drive did not come back: the robot tipped over, or got stuck

/// Returns the grounds to drive over, twice as many if some robots may not come back.
Result<std::vector<TerrainProfile>> watchedGrounds(const FaultsOptions& options)
{
    const std::size_t most = static_cast<std::size_t>(options.drives) * (options.comesBack ? 2 : 1);
    return drivenGrounds({options.terrain, options.step, options.blocks, options.settings.seed},
                         most);
}

std::vector<WatchedLine> driveOne(const FaultsOptions& options, const RobotModel& robot,
                                  const TerrainProfile& ground, std::size_t k)
{
    std::seed_seq seed{options.settings.seed, static_cast<std::uint64_t>(k)};
    std::mt19937_64 rng(seed);
    WatchedStyle style;
    style.flippers = randomDriveStyle(rng);
    style.spacing = options.spacing;
    style.comesBack = options.comesBack;
    return driveWithTelemetry(robot, ground, style, rng());
}

/// Returns the drives. Those that were to come back, but did not, are left out and counted.
WatchedDrives driveWatched(const FaultsOptions& options, const RobotModel& robot,
                           const std::vector<TerrainProfile>& grounds, std::size_t& leftOut)
{
    const auto wanted = static_cast<std::size_t>(options.drives);
    WatchedDrives kept;
    Progress progress("drive", options.drives);
    for (std::size_t next = 0; kept.size() < wanted && next < grounds.size();) {
        WatchedDrives drives(std::min(wanted - kept.size(), grounds.size() - next));
        parallelFor(static_cast<int>(drives.size()), [&](int n) {
            const std::size_t k = next + static_cast<std::size_t>(n);
            drives[k - next] = driveOne(options, robot, grounds[k], k);
        });
        next += drives.size();
        for (std::vector<WatchedLine>& drive : drives) {
            const bool isWhole = !options.comesBack || wayBack(drive) >= kLeastBack;
            leftOut += isWhole ? 0 : 1;
            if (!isWhole) continue;
            kept.push_back(std::move(drive));
            progress.tick();
        }
    }
    return kept;
}

/// Results of one fault on all drives.
struct FaultRow {
    std::size_t scenes = 0, suspects = 0, doubted = 0, contradicting = 0, drives = 0;
    std::vector<double> seconds,
        until;  ///< per drive with a detection: time [s], scenes until then
    std::vector<BinError> all,
        trusted;  ///< errors of all scenes, of scenes without a withheld verdict
};

double percent(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Returns the median time as text; "never" if fewer than half of the drives have a time.
std::string medianWords(std::vector<double> values, std::size_t drives, const char* format)
{
    if (2 * values.size() < drives) return "never";
    values.resize(drives, HUGE_VAL);
    std::sort(values.begin(), values.end());
    return fmt::format(fmt::runtime(format), values[(drives - 1) / 2]);
}

void judgeScenes(const std::vector<WatchedScene>& watched, const FaultsOptions& options,
                 const EstimatorBundle& bundle, FaultRow& row)
{
    std::vector<Scene> scenes;
    scenes.reserve(watched.size());
    for (const WatchedScene& scene : watched) scenes.push_back(scene.scene);
    auto estimates = estimateScenes(scenes, bundle, options.settings, 0.0);
    row.contradicting += checkEstimates(scenes, bundle.robot, estimates);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const auto& estimate = estimates[k].estimate;
        ++row.scenes;
        row.suspects += watched[k].isSuspect ? 1 : 0;
        const bool isDoubted =
            watched[k].isSuspect || !estimate
            || !verdictOf(*estimate, watched[k].measurement, {}, kStepLimit).withheldFor.empty();
        row.doubted += isDoubted ? 1 : 0;
        if (!estimate) continue;
        const auto errors = binErrors(k, scenes[k], "local", *estimate);
        row.all.insert(row.all.end(), errors.begin(), errors.end());
        if (!isDoubted) row.trusted.insert(row.trusted.end(), errors.begin(), errors.end());
    }
}

FaultRow tryFault(const TriedFault& fault, const FaultsOptions& options,
                  const EstimatorBundle& bundle, const WatchedDrives& drives)
{
    std::vector<WatchedFault> watched(drives.size());
    parallelFor(static_cast<int>(drives.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        watched[k] = watchFault(drives[k], bundle.robot, fault.fault, k);
    });
    FaultRow row;
    row.drives = drives.size();
    std::vector<WatchedScene> scenes;
    for (const WatchedFault& drive : watched) {
        scenes.insert(scenes.end(), drive.scenes.begin(), drive.scenes.end());
        if (!drive.noticed) continue;
        row.seconds.push_back(*drive.noticed);
        row.until.push_back(static_cast<double>(drive.scenesUntilNoticed));
    }
    judgeScenes(scenes, options, bundle, row);
    return row;
}

void printFault(const TriedFault& fault, const FaultRow& row)
{
    const ErrorStatistics all = statistics(row.all), trusted = statistics(row.trusted);
    const std::string left =
        row.trusted.empty()
            ? fmt::format("{:>8}{:>7}", "-", "-")
            : fmt::format("{:>8.1f}{:>7.1f}", 1000.0 * trusted.mean, 100.0 * trusted.coverage);
    printText("{:<38}{:>8.1f}{:>7.1f}{:>9.1f}{:>8.1f}{:>8.1f}{:>8.1f}{:>9}{:>8}{}\n", fault.words,
              1000.0 * all.mean, 100.0 * all.coverage, percent(row.suspects, row.scenes),
              percent(row.contradicting, row.scenes), percent(row.doubted, row.scenes),
              percent(row.seconds.size(), row.drives),
              medianWords(row.seconds, row.drives, "{:.1f}"),
              medianWords(row.until, row.drives, "{:.0f}"), left);
    std::fflush(stdout);
}

/// Returns true if the fault adds more than 5 mm of error, or removes more than 10 points of coverage.
bool harms(const FaultRow& row, const FaultRow& sound)
{
    const ErrorStatistics with = statistics(row.all), without = statistics(sound.all);
    return with.mean > without.mean + 0.005 || with.coverage < without.coverage - 0.10;
}

bool isFlagged(const FaultRow& row)
{
    return percent(row.doubted, row.scenes) >= 90.0
        || percent(row.seconds.size(), row.drives) >= 90.0;
}

void printHead(const FaultsOptions& options, std::size_t drives, std::size_t leftOut)
{
    printText("{} drives over {}{}, a scene every {:.2f} m", drives, options.terrain,
              options.comesBack ? " and back" : "", options.spacing);
    if (options.comesBack)
        printText("; {} that came back less than {:.0f} m are left out", leftOut, kLeastBack);
    printText("\n");
    printText("{:<38}{:>8}{:>7}{:>9}{:>8}{:>8}{:>8}{:>9}{:>8}{:>8}{:>7}\n", "", "mean mm", "in 80",
              "suspect", "contra", "doubt", "drives", "after s", "scenes", "left mm", "in 80");
}

/// Returns the share of drives [%] in which SensorWatch detects the fault.
double noticedIn(const std::string& fault, const RobotModel& robot, const WatchedDrives& drives)
{
    std::vector<char> noticed(drives.size());
    parallelFor(static_cast<int>(drives.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        noticed[k] = watchFault(drives[k], robot, fault, k).noticed ? 1 : 0;
    });
    return percent(static_cast<std::size_t>(std::count(noticed.begin(), noticed.end(), 1)),
                   drives.size());
}

/// Prints the matrix of fault kinds and sensors; a letter refers to a reason printed below it.
void printMatrix(const RobotModel& robot, const WatchedDrives& drives)
{
    std::vector<std::string_view> reasons;
    printText("{:<20}", "drives [%]");
    for (const std::string_view kind : matrixKinds()) printText("{:>14}", kind);
    const std::size_t columns = matrixKinds().size();
    std::size_t column = 0;
    for (const MatrixCell& cell : faultMatrix()) {
        if (column++ % columns == 0) printText("\n{:<20}", cell.sensor);
        std::string mark;
        if (!cell.reason.empty()) {
            const auto known = std::find(reasons.begin(), reasons.end(), cell.reason);
            mark = fmt::format(" {}", static_cast<char>('a' + (known - reasons.begin())));
            if (known == reasons.end()) reasons.push_back(cell.reason);
        }
        printText("{:>12.0f}{:<2}", noticedIn(cell.fault, robot, drives), mark);
    }
    printText("\n\nWhy one is not noticed in every drive:\n");
    for (std::size_t k = 0; k < reasons.size(); ++k)
        printText("  {}: {}\n", static_cast<char>('a' + k), reasons[k]);
}

}  // namespace

Status judgeFaults(const FaultsOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const auto grounds = watchedGrounds(options);
    if (!grounds) return grounds.error();
    std::size_t leftOut = 0;
    const WatchedDrives drives = driveWatched(options, (*bundle)->robot, *grounds, leftOut);
    if (drives.empty()) return Error{"no drive came back over its ground: try other ground", 0};
    if (options.matrix) {
        printMatrix((*bundle)->robot, drives);
        return Done{};
    }
    printHead(options, drives.size(), leftOut);
    FaultRow sound;
    std::size_t harmful = 0, flagged = 0;
    std::string missed;
    for (const TriedFault& fault : triedFaults()) {
        FaultRow row = tryFault(fault, options, **bundle, drives);
        printFault(fault, row);
        if (fault.fault.empty()) {
            sound = std::move(row);
            continue;
        }
        const bool isHarmful = harms(row, sound);
        harmful += isHarmful ? 1 : 0;
        flagged += isHarmful && isFlagged(row) ? 1 : 0;
        if (!isFlagged(row))
            missed += fmt::format("  {}{}: {}\n", fault.words, isHarmful ? "" : " (harmless)",
                                  fault.limit.empty() ? "not in every drive" : fault.limit);
    }
    printText("\n{} of {} faults that harm are noticed; not noticed:\n{}", flagged, harmful,
              Lines(missed));
    return Done{};
}

}  // namespace terratact
