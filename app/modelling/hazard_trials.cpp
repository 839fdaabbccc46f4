#include "app/modelling/hazard_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/runtime/parallel.h"
#include "core/infer/verdict/verdict.h"
#include "core/sim/drive.h"
#include "core/sim/random_terrain.h"
#include "core/sim/terrain_shapes.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr double kStops = 0.1;       // [m] distance between two scenes
constexpr double kBefore = 1.0;      // [m] judged ground before the hazard
constexpr double kBehind = 0.5;      // [m] ground behind the latest start of the hazard
constexpr double kFirstStop = 0.65;  // [m] see stopsOver()
constexpr double kSpeed = 0.3;       // [m/s] speed of driveOver()

struct Ground {
    std::string_view name;
    double roughness;  // [m³] G(n₀) of ISO 8608
};
constexpr std::array kGrounds{Ground{"level", 0.0}, Ground{"class A", 16e-6},
                              Ground{"class C", 256e-6}};

/// Drives once and returns the scenes near the hazard, with exact truth.
std::vector<Scene> driveOnce(const RobotModel& robot, const Ground& ground,
                             std::optional<Hazard> hazard, std::mt19937_64& rng)
{
    const TerrainProfile terrain = hazard ? randomHazardTerrain(*hazard, ground.roughness, rng)
                                 : ground.roughness > 0.0
                                     ? isoRoughness(ground.roughness, kRandomTerrainLength, rng)
                                     : flatTerrain(kRandomTerrainLength);
    DriveConditions conditions;
    conditions.noise.height = 0.0;
    const DriveStyle style = randomDriveStyle(rng);
    int skipped = 0;
    std::vector<Scene> scenes = driveOver(robot, terrain, stopsOver(terrain, kStops), "hazard",
                                          style, conditions, rng, skipped);
    std::erase_if(scenes, [](const Scene& scene) {
        const double x = kFirstStop + kSpeed * scene.time;
        return x < kHazardBegin - kBefore || x > kHazardEnd + kBehind;
    });
    return scenes;
}

int reachOf(const TerrainEstimate& estimate)
{
    int last = kMinHorizonBin;
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (std::isfinite(estimate.ceiling[static_cast<std::size_t>(bin)]))
            last = std::max(last, bin);
    return last;
}

bool isFeltTo(const TerrainEstimate& estimate, int last)
{
    for (int bin = kFirstAhead; bin <= last; ++bin)
        if (estimate.touch[static_cast<std::size_t>(bin)] != Touch::Felt) return false;
    return true;
}

void countBands(const TerrainEstimate& estimate, const Heights& truth, VerdictCounts& counts)
{
    for (std::size_t i = 0; i < kBins; ++i) {
        const bool covered = truth[i] >= estimate.q10[i] && truth[i] <= estimate.q90[i];
        const bool felt =
            estimate.touch[i] == Touch::Felt || estimate.touch[i] == Touch::FeltInPart;
        if (felt) {
            ++counts.feltBins;
            counts.feltCovered += covered ? 1 : 0;
        } else if (static_cast<int>(i) >= kFirstAhead) {
            ++counts.unfeltBins;
            counts.unfeltCovered += covered ? 1 : 0;
        }
    }
}

VerdictCounts judge(const Scene& scene, const TerrainEstimate& estimate, double stepLimit)
{
    Heights truth{};
    for (std::size_t i = 0; i < kBins; ++i) truth[i] = scene.truth[i].value();
    const Verdict verdict = verdictOf(estimate, scene.s, stepLimit);
    const auto horizon =
        static_cast<int>(std::lround((verdict.horizon - binBegin(0)) / kBinWidth)) - 1;
    const int reach = reachOf(estimate);
    const bool clear = verdict.stepVerdict == StepVerdict::Clear;
    const bool stepAhead = hasStep(truth, stepLimit, kFirstAhead, kBins - 1);
    const bool stepBefore = clear && hasStep(truth, stepLimit, kFirstAhead, horizon);
    const bool flat = !hasStep(truth, stepLimit, kFirstAhead, reach);
    const bool felt = flat && isFeltTo(estimate, reach);
    VerdictCounts c;
    c.scenes = 1;
    c.withStep = stepAhead ? 1 : 0;
    c.clear = clear ? 1 : 0;
    c.blocked = verdict.stepVerdict == StepVerdict::Blocked ? 1 : 0;
    c.falseClear = stepBefore ? 1 : 0;
    c.overlooked = clear && stepAhead && !stepBefore ? 1 : 0;
    c.flat = flat ? 1 : 0;
    c.flatClear = flat && clear ? 1 : 0;
    c.felt = felt ? 1 : 0;
    c.feltClear = felt && clear ? 1 : 0;
    countBands(estimate, truth, c);
    return c;
}

/// Returns the counts of one drive for each rate.
std::vector<VerdictCounts> judgeDrive(const EstimatorBundle& bundle, const HazardTrial& trial,
                                      const Ground& ground, std::optional<Hazard> hazard,
                                      std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    std::vector<VerdictCounts> counts(trial.rates.size());
    for (const Scene& scene : driveOnce(bundle.robot, ground, hazard, rng))
        for (std::size_t r = 0; r < trial.rates.size(); ++r) {
            Settings settings = trial.settings;
            settings.hazardRate = trial.rates[r];
            const SceneEstimate result = estimateScene(scene, bundle, settings);
            if (!result.estimate) {
                ++counts[r].failed;
                continue;
            }
            counts[r] += judge(scene, *result.estimate, trial.stepLimit);
        }
    return counts;
}

void addLines(const EstimatorBundle& bundle, const HazardTrial& trial, std::size_t ground,
              std::optional<Hazard> hazard, std::vector<HazardLine>& lines)
{
    const std::size_t kind = hazard ? static_cast<std::size_t>(*hazard) + 1 : 0;
    std::vector<std::vector<VerdictCounts>> drives(static_cast<std::size_t>(trial.drives));
    parallelFor(trial.drives, [&](int k) {
        const auto drive = static_cast<std::size_t>(k);
        const std::uint64_t seed =
            trial.seed * 1'000'003 + (kind * kGrounds.size() + ground) * 10'007 + drive;
        drives[drive] = judgeDrive(bundle, trial, kGrounds[ground], hazard, seed);
    });
    for (std::size_t r = 0; r < trial.rates.size(); ++r) {
        HazardLine line{std::string(kGrounds[ground].name),
                        hazard ? std::string(name(*hazard)) : std::string("none"),
                        trial.rates[r],
                        {}};
        for (const auto& counts : drives) line.counts += counts[r];
        lines.push_back(std::move(line));
    }
}

double share(std::size_t part, std::size_t whole, double of)
{
    return whole == 0 ? 0.0 : of * static_cast<double>(part) / static_cast<double>(whole);
}

std::string tableLine(const std::string& what, const VerdictCounts& c)
{
    return fmt::format(
        "{:<20} {:>6} {:>6} {:>7} {:>6} {:>6} {:>7.2f} {:>6.0f} {:>6} {:>6.0f} {:>6.1f} {:>6.1f}\n",
        what, c.scenes, c.withStep, c.blocked, c.clear, c.falseClear,
        share(c.falseClear, c.withStep, 1000.0), share(c.flatClear, c.flat, 100.0), c.felt,
        share(c.feltClear, c.felt, 100.0), share(c.feltCovered, c.feltBins, 100.0),
        share(c.unfeltCovered, c.unfeltBins, 100.0));
}

constexpr std::string_view kHead = "                     scenes   step BLOCKED  CLEAR  false  per "
                                   "1k  flat%   felt  felt% felt80  unf80\n";

VerdictCounts total(std::span<const HazardLine> lines, double rate, std::string_view ground)
{
    VerdictCounts sum;
    for (const HazardLine& line : lines)
        if (line.rate == rate && (ground.empty() || line.ground == ground)) sum += line.counts;
    return sum;
}

std::vector<double> ratesOf(std::span<const HazardLine> lines)
{
    std::vector<double> rates;
    for (const HazardLine& line : lines)
        if (std::ranges::find(rates, line.rate) == rates.end()) rates.push_back(line.rate);
    return rates;
}

}  // namespace

VerdictCounts& VerdictCounts::operator+=(const VerdictCounts& o)
{
    scenes += o.scenes;
    failed += o.failed;
    withStep += o.withStep;
    clear += o.clear;
    blocked += o.blocked;
    falseClear += o.falseClear;
    overlooked += o.overlooked;
    flat += o.flat;
    flatClear += o.flatClear;
    felt += o.felt;
    feltClear += o.feltClear;
    feltBins += o.feltBins;
    feltCovered += o.feltCovered;
    unfeltBins += o.unfeltBins;
    unfeltCovered += o.unfeltCovered;
    return *this;
}

std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial)
{
    std::vector<HazardLine> lines;
    for (std::size_t ground = 0; ground < kGrounds.size(); ++ground) {
        addLines(bundle, trial, ground, std::nullopt, lines);
        for (const Hazard hazard : kHazards) addLines(bundle, trial, ground, hazard, lines);
    }
    return lines;
}

std::string hazardTable(std::span<const HazardLine> lines, double rate)
{
    std::string text = fmt::format("rate {} per unfelt bin\n{}", rate, kHead);
    for (const HazardLine& line : lines)
        if (line.rate == rate) text += tableLine(line.ground + ", " + line.hazard, line.counts);
    for (const double each : ratesOf(lines)) {
        text += fmt::format("\nall hazards, rate {} per unfelt bin\n{}", each, kHead);
        for (const Ground& ground : kGrounds)
            text += tableLine(std::string(ground.name), total(lines, each, ground.name));
        text += tableLine("all", total(lines, each, {}));
    }
    return text
         + "\nstep: a true step ahead; false: CLEAR with a true step before its horizon, per 1k of "
           "these scenes; "
           "flat%: CLEAR of\nthe scenes without a true step up to the front flippers' reach; felt: "
           "of these, those "
           "felt up to the reach, felt%: CLEAR\nof them; felt80, unf80: cover of the 80 % bands of "
           "felt bins, and "
           "of bins ahead that are not felt [%]\n";
}

}  // namespace terratact
