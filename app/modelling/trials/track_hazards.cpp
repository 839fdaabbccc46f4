#include "app/modelling/trials/track_hazards.h"

#include <algorithm>
#include <array>
#include <optional>

#include "app/runtime/parallel.h"
#include "core/infer/two_track_estimator.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/sim/two_track_check.h"
#include "core/terrain/step.h"
#include "core/trail/trail_record.h"

namespace terratact {
namespace {

/// What one drive of two tracks is like.
struct TrackDriveKind {
    std::size_t ground = 0;  ///< index into kHazardGrounds
    std::optional<Hazard> hazard{};
    bool onBothSides = false;
    PressStyle style = PressStyle::Random;
};

VerdictCounts robotCounts(const std::array<VerdictCounts, 2>& sides, StepVerdict answer,
                          bool stepBefore)
{
    const auto any = [&](std::size_t VerdictCounts::*count) {
        return std::size_t{sides[0].*count + sides[1].*count > 0 ? 1U : 0U};
    };
    const bool clear = answer == StepVerdict::Clear;
    VerdictCounts counts;
    counts.scenes = 1;
    counts.contradicting = any(&VerdictCounts::contradicting);
    counts.withStep = any(&VerdictCounts::withStep);
    counts.clear = clear ? 1 : 0;
    counts.blocked = answer == StepVerdict::Blocked ? 1 : 0;
    counts.falseClear = clear && stepBefore ? 1 : 0;
    counts.overlooked = clear && !stepBefore ? counts.withStep : 0;
    counts.flat = sides[0].flat * sides[1].flat;
    counts.flatClear = clear ? counts.flat : 0;
    for (const VerdictCounts& side : sides) {
        counts.feltBins += side.feltBins;
        counts.feltCovered += side.feltCovered;
        counts.unfeltBins += side.unfeltBins;
        counts.unfeltCovered += side.unfeltCovered;
    }
    return counts;
}

TrackHazardLine lineOf(const TrackDriveKind& kind)
{
    TrackHazardLine line;
    line.ground = kHazardGrounds[kind.ground].name;
    line.hazard = kind.hazard ? std::string(name(*kind.hazard)) : std::string("none");
    if (kind.hazard) line.hazard += kind.onBothSides ? ", both sides" : ", one side";
    line.style = kind.style;
    return line;
}

TrackHazardLine judgeTrackDrive(const EstimatorBundle& bundle, const HazardTrial& trial,
                                const TrackDriveKind& kind, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    Settings settings = trial.settings;
    settings.hazardRate = trial.rates.back();
    TrackHazardLine line = lineOf(kind);
    for (const TwoTrackScene& scene :
         driveTracksTowards(bundle.robot, kHazardGrounds[kind.ground], kind.hazard,
                            kind.onBothSides, kind.style, rng)) {
        TwoTrackEstimate estimate =
            estimateTwoTracks(scene.s, {}, bundle.robot, bundle.models, settings);
        writePosteriorCheck(estimate, measurementOf(scene.s), bundle.robot);
        countScene(scene, bundle.robot, estimate, trial.stepLimit, line);
    }
    return line;
}

/// Judges a drive with telemetry on the way. Of the methods, Trail alone uses its memory.
TrackHazardLine judgeWayDrive(const EstimatorBundle& bundle, const HazardTrial& trial,
                              const TrackDriveKind& kind, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    Settings settings = trial.settings;
    settings.hazardRate = trial.rates.back();
    TrackHazardLine line = lineOf(kind);
    TrailRecord record(bundle.robot);
    for (const DriveLine& driven : driveTracksAlong(bundle.robot, kHazardGrounds[kind.ground],
                                                    kind.hazard, kind.onBothSides, kind.style, rng)
                                       .lines) {
        if (!driven.isScene) {
            record.add(driven.line);
            continue;
        }
        const TrailHistory history = record.before(driven.line);
        record.addScene(driven.line);
        if (!isNear(driven.line)) continue;
        TwoTrackEstimate estimate =
            estimateMeasured(driven.line, {}, bundle.robot, bundle.models, settings, {}, &history);
        writePosteriorCheck(estimate, driven.line, bundle.robot);
        TwoTrackScene scene;
        scene.s = twoTrackReadings(driven.line);
        scene.truth = driven.truth;
        countScene(scene, bundle.robot, estimate, trial.stepLimit, line);
    }
    return line;
}

std::vector<TrackDriveKind> trackDriveKinds()
{
    std::vector<TrackDriveKind> kinds;
    for (const PressStyle style : {PressStyle::Random, PressStyle::Console})
        for (std::size_t ground = 0; ground < kHazardGrounds.size(); ++ground) {
            kinds.push_back({ground, std::nullopt, true, style});
            for (const Hazard hazard : kHazards)
                for (const bool both : {false, true})
                    kinds.push_back({ground, hazard, both, style});
        }
    return kinds;
}

TrackHazardLine total(std::span<const TrackHazardLine> lines, PressStyle style,
                      std::string_view ground)
{
    TrackHazardLine sum;
    for (const TrackHazardLine& line : lines)
        if (line.style == style && (ground.empty() || line.ground == ground)) {
            sum.robot += line.robot;
            sum.sides += line.sides;
        }
    return sum;
}

std::string trackTotals(std::span<const TrackHazardLine> lines, PressStyle style)
{
    std::string text;
    for (const HazardGround& ground : kHazardGrounds)
        text += countsLine(ground.name, total(lines, style, ground.name).robot);
    const TrackHazardLine all = total(lines, style, {});
    return text + countsLine("all", all.robot) + countsLine("all, each side", all.sides);
}

}  // namespace

void countScene(const TwoTrackScene& scene, const RobotModel& robot,
                const TwoTrackEstimate& estimate, double stepLimit, TrackHazardLine& line)
{
    const TwoTrackVerdict verdict =
        verdictOf(estimate, robot, measurementOf(scene.s), {}, stepLimit);
    std::array<VerdictCounts, 2> sides;
    bool stepBefore = false;
    for (std::size_t i = 0; i < 2; ++i) {
        const Heights truth = knownHeights(scene.truth[i]);
        sides[i] = countVerdict(verdict.side[i], estimate.side[i], truth, stepLimit);
        stepBefore =
            stepBefore || hasStep(truth, stepLimit, kFirstAhead, lastBinOf(verdict.side[i]));
        line.sides += sides[i];
    }
    line.robot += robotCounts(sides, verdict.both, stepBefore);
}

std::vector<TrackHazardLine> tryTrackHazards(const EstimatorBundle& bundle,
                                             const HazardTrial& trial)
{
    std::vector<TrackHazardLine> lines;
    const std::vector<TrackDriveKind> kinds = trackDriveKinds();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        std::vector<TrackHazardLine> drives(static_cast<std::size_t>(trial.drives));
        parallelFor(trial.drives, [&](int drive) {
            const auto i = static_cast<std::size_t>(drive);
            const std::uint64_t seed = trial.seed * 10'000'019 + k * 10'007 + i;
            drives[i] = trial.remembers ? judgeWayDrive(bundle, trial, kinds[k], seed)
                                        : judgeTrackDrive(bundle, trial, kinds[k], seed);
        });
        TrackHazardLine line = lineOf(kinds[k]);
        for (const TrackHazardLine& drive : drives) {
            line.robot += drive.robot;
            line.sides += drive.sides;
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

std::string trackHazardTable(std::span<const TrackHazardLine> lines)
{
    std::string text = "two tracks, random press\n" + std::string(kCountsHead);
    for (const TrackHazardLine& line : lines)
        if (line.style == PressStyle::Random)
            text += countsLine(line.ground + ", " + line.hazard, line.robot);
    text.append("\ntotals, random press\n").append(kCountsHead);
    text += trackTotals(lines, PressStyle::Random);
    text.append("\ntotals, press of the console\n").append(kCountsHead);
    text += trackTotals(lines, PressStyle::Console);
    text += R"(
A scene's answer is the robot's: a step counts on either side, CLEAR is false if a side has a step before its horizon,
and flat ground is flat on both sides. The last rows count each side by its own answer. press: not counted.
)";
    return text.append(kCountsLegend);
}

}  // namespace terratact
