#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <utility>

#include "app/cli/commands.h"
#include "app/modelling/scene_estimates.h"
#include "app/runtime/parallel.h"
#include "app/runtime/progress.h"
#include "app/runtime/say.h"
#include "core/eval/ghost_gain.h"
#include "core/infer/verdict/ghost_track.h"
#include "core/learn/data/profile_file.h"
#include "core/sim/drive.h"
#include "core/sim/random_terrain.h"

namespace terratact {
namespace {

constexpr double kMillimetres = 1000.0;

using Drives = std::vector<std::vector<DrivenScene>>;

Result<std::vector<TerrainProfile>> groundsOf(const GhostOptions& options)
{
    if (options.terrain == "boxes" || options.terrain == "varied") {
        std::mt19937_64 rng(options.settings.seed);
        std::vector<TerrainProfile> grounds;
        grounds.reserve(static_cast<std::size_t>(options.drives));
        for (int k = 0; k < options.drives; ++k)
            grounds.push_back(options.terrain == "boxes" ? randomBoxTerrain(rng)
                                                         : randomVariedTerrain(rng));
        return grounds;
    }
    auto file = readProfiles(options.terrain, options.step, options.blocks);
    if (!file) return file.error();
    std::vector<TerrainProfile> all = std::move(file->profiles);
    const auto most = static_cast<std::size_t>(options.drives);
    if (all.size() <= most) return all;
    std::vector<TerrainProfile>
        grounds;  // spread evenly, because neighbouring profiles are similar
    grounds.reserve(most);
    for (std::size_t k = 0; k < most; ++k) grounds.push_back(all[k * all.size() / most]);
    return grounds;
}

Drives driveAll(const GhostOptions& options, const RobotModel& robot,
                const std::vector<TerrainProfile>& grounds)
{
    Drives drives(grounds.size());
    Progress progress("drive", static_cast<int>(grounds.size()));
    parallelFor(static_cast<int>(grounds.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        std::seed_seq seed{options.settings.seed, static_cast<std::uint64_t>(k)};
        std::mt19937_64 rng(seed);
        DriveConditions conditions;
        conditions.noise.height = 0.0;  // scored against the true ground
        int skipped = 0;
        const DriveStyle style = randomDriveStyle(rng);
        drives[k] = driveWithOdometry(robot, grounds[k], stopsOver(grounds[k], options.spacing),
                                      std::to_string(k + 1), style, conditions,
                                      robot.travelledSdShare, rng, skipped);
        progress.tick();
    });
    return drives;
}

Measurement telemetry(const OdometryReading& reading)
{
    Measurement m;
    m.pitch = reading.pitch;
    m.travelled = reading.travelled;
    m.turned = 0.0;
    return m;
}

/// Returns the ghost of the estimate after the drive to the next scene.
std::optional<Ghost> ghostAfter(const TerrainEstimate& estimate, const RobotModel& robot,
                                const OdometryReading& scene,
                                const std::vector<OdometryReading>& way)
{
    GhostTrack track(robot, estimate, telemetry(scene));
    for (const OdometryReading& reading : way) track.take(telemetry(reading));
    return track.ghost();
}

WeakHeights weakHeights(const Ghost& ghost, double sdFactor)
{
    WeakHeights weak;
    for (std::size_t i = 0; i < kBins; ++i)
        if (ghost.bin[i]) weak[i] = WeakHeight{ghost.bin[i]->height, sdFactor * ghost.bin[i]->sd};
    return weak;
}

/// Scores a ghost as a forecast, with the truth of its bins only.
std::vector<BinError> errorsOfGhost(std::size_t number, Scene scene, const Ghost& ghost)
{
    TerrainEstimate forecast;
    for (std::size_t i = 0; i < kBins; ++i) {
        const auto& bin = ghost.bin[i];
        if (!bin) {
            scene.truth[i].reset();
            continue;
        }
        forecast.mean[i] = forecast.height[i] = bin->height;
        forecast.sd[i] = bin->sd;
        forecast.q10[i] = bin->q10;
        forecast.q90[i] = bin->q90;
    }
    return binErrors(number, scene, "ghost", forecast);
}

struct GhostFindings {
    std::vector<Scene> scenes;                      ///< scenes with a previous scene
    std::vector<BinError> ghost;                    ///< errors of the ghost's bins
    std::vector<BinError> without, with;            ///< errors in all bins of scenes with a ghost
    std::vector<BinError> withoutThere, withThere;  ///< errors in the ghost's bins only
    std::size_t ended = 0;                          ///< scenes whose ghost had ended
};

void append(std::vector<BinError>& all, const std::vector<BinError>& some)
{
    all.insert(all.end(), some.begin(), some.end());
}

/// Returns the `errors` in bins for which the ghost has a forecast.
std::vector<BinError> where(const std::vector<BinError>& ghost, const std::vector<BinError>& errors)
{
    std::vector<BinError> kept;
    for (const BinError& e : errors)
        for (const BinError& g : ghost)
            if (g.bin == e.bin) kept.push_back(e);
    return kept;
}

/// Estimates the scenes of one drive in sequence, without a ghost and with that of the previous scene.
class DriveTrial {
public:
    DriveTrial(const EstimatorBundle& bundle, const GhostOptions& options, Settings settings)
        : bundle_(bundle), options_(options), settings_(settings)
    {
    }

    GhostFindings run(const std::vector<DrivenScene>& drive)
    {
        std::optional<TerrainEstimate> lastWithout, lastWith;
        OdometryReading at;
        for (const DrivenScene& driven : drive) {
            ++settings_.seed;
            std::optional<Ghost> drawn, weak;
            if (lastWithout && lastWith) {
                drawn = ghostAfter(*lastWithout, bundle_.robot, at, driven.way);
                weak = ghostAfter(*lastWith, bundle_.robot, at, driven.way);
                found_.ended += drawn && weak ? 0 : 1;
            }
            lastWithout = estimate(driven.scene, {});
            lastWith =
                weak ? estimate(driven.scene, weakHeights(*weak, options_.sdFactor)) : lastWithout;
            if (drawn && weak && lastWithout && lastWith)
                judge(driven.scene, *drawn, *lastWithout, *lastWith);
            at = driven.way.back();
        }
        return std::move(found_);
    }

private:
    /// Returns the estimate; empty for a scene outside everything the method has learnt.
    std::optional<TerrainEstimate> estimate(const Scene& scene, const WeakHeights& weak) const
    {
        try {
            return estimateTerrain(scene.s, {}, bundle_.robot, bundle_.models, settings_, {}, weak);
        } catch (const NotLearnt&) {
            return std::nullopt;
        }
    }

    void judge(const Scene& scene, const Ghost& drawn, const TerrainEstimate& without,
               const TerrainEstimate& with)
    {
        const std::size_t number = found_.scenes.size();
        const std::vector<BinError> alone = errorsOfGhost(number, scene, drawn);
        const std::vector<BinError> before = binErrors(number, scene, "without", without);
        const std::vector<BinError> after = binErrors(number, scene, "with", with);
        found_.scenes.push_back(scene);
        append(found_.ghost, alone);
        append(found_.without, before);
        append(found_.with, after);
        append(found_.withoutThere, where(alone, before));
        append(found_.withThere, where(alone, after));
    }

    const EstimatorBundle& bundle_;
    const GhostOptions& options_;
    Settings settings_;
    GhostFindings found_;
};

void renumber(std::vector<BinError>& errors, std::size_t first)
{
    for (BinError& e : errors) e.scene += first;
}

void append(GhostFindings& all, GhostFindings some)
{
    const std::size_t first = all.scenes.size();
    all.scenes.insert(all.scenes.end(), some.scenes.begin(), some.scenes.end());
    for (const auto member : {&GhostFindings::ghost, &GhostFindings::without, &GhostFindings::with,
                              &GhostFindings::withoutThere, &GhostFindings::withThere}) {
        renumber(some.*member, first);
        append(all.*member, some.*member);
    }
    all.ended += some.ended;
}

GhostFindings tryMethod(const GhostOptions& options, const EstimatorBundle& bundle,
                        const Drives& drives, Method method)
{
    std::vector<GhostFindings> each(drives.size());
    Progress progress(fmt::format("{}: drive", name(method)), static_cast<int>(drives.size()));
    parallelFor(static_cast<int>(drives.size()), [&](int n) {
        const auto k = static_cast<std::size_t>(n);
        Settings settings = options.settings;
        settings.method = method;
        settings.seed += 1000 * k;
        each[k] = DriveTrial(bundle, options, settings).run(drives[k]);
        progress.tick();
    });
    GhostFindings all;
    for (GhostFindings& some : each) append(all, std::move(some));
    return all;
}

void printRow(const std::string& what, const std::vector<BinError>& errors)
{
    const ErrorStatistics s = statistics(errors);
    say("{:<34}{:>7}{:>8.1f}{:>8.1f}{:>7.1f}{:>7.1f}{:>7.1f}{:>9.0f}\n", what, s.n,
        kMillimetres * s.mean, kMillimetres * s.crps, 100.0 * s.coverage50, 100.0 * s.coverage,
        100.0 * s.coverage95, kMillimetres * s.width);
}

void printGain(const std::string& where, const std::vector<BinError>& before,
               const std::vector<BinError>& after, const GhostFindings& found, std::uint64_t seed)
{
    const PairedGain gain = pairedGain(before, after, found.scenes, seed);
    if (!gain.intervals) {
        say("  {}: not decided, fewer than {} drives\n", where, kMinRuns);
        return;
    }
    const auto& i = *gain.intervals;
    say("  {}: mean |error| {:+.1f} mm ({:+.1f} to {:+.1f}), CRPS {:+.1f} mm ({:+.1f} to "
        "{:+.1f}), 80 % band {:+.1f} points ({:+.1f} to {:+.1f}): {}\n",
        where, kMillimetres * (gain.after.mean - gain.before.mean), kMillimetres * i.mean.low,
        kMillimetres * i.mean.high, kMillimetres * (gain.after.crps - gain.before.crps),
        kMillimetres * i.crps.low, kMillimetres * i.crps.high,
        100.0 * (gain.after.coverage - gain.before.coverage), 100.0 * i.coverage.low,
        100.0 * i.coverage.high, gain.helps() ? "helps" : "not shown to help");
}

void printFindings(Method method, const GhostFindings& found, std::uint64_t seed)
{
    const std::string label(name(method));
    say("\n{}: {} scenes with a ghost, {} where it had ended\n", label, found.scenes.size(),
        found.ended);
    say("{:<34}{:>7}{:>8}{:>8}{:>7}{:>7}{:>7}{:>9}\n", "", "bins", "mean mm", "CRPS mm", "in 50",
        "in 80", "in 95", "width mm");
    printRow("the ghost, as it is drawn", found.ghost);
    printRow("its bins without it", found.withoutThere);
    printRow("its bins with it", found.withThere);
    printRow("all bins without it", found.without);
    printRow("all bins with it", found.with);
    say("with minus without, 95 % intervals over drives:\n");
    printGain("its bins", found.withoutThere, found.withThere, found, seed);
    printGain("all bins", found.without, found.with, found, seed);
}

}  // namespace

Status judgeGhost(const GhostOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    const auto grounds = groundsOf(options);
    if (!grounds) return grounds.error();
    const Drives drives = driveAll(options, (*bundle)->robot, *grounds);
    std::size_t scenes = 0;
    for (const auto& drive : drives) scenes += drive.size();
    say("{} drives over {}, {} scenes every {:.2f} m; odometry's sd {:.0f} % of the way; the "
        "ghost's sd times {:g} as a measurement\n",
        drives.size(), options.terrain, scenes, options.spacing,
        100.0 * (*bundle)->robot.travelledSdShare, options.sdFactor);
    for (const Method method : options.methods)
        printFindings(method, tryMethod(options, **bundle, drives, method), options.settings.seed);
    return Done{};
}

}  // namespace terratact
