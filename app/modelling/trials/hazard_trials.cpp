#include "app/modelling/trials/hazard_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/runtime/parallel.h"
#include "core/infer/verdict/verdict.h"
#include "core/sim/posterior_check.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

VerdictCounts judge(const HazardScene& driven, const TerrainEstimate& estimate, double stepLimit)
{
    const Heights truth = knownHeights(driven.scene.truth);
    VerdictCounts counts =
        countVerdict(verdictOf(estimate, driven.scene.s, stepLimit), estimate, truth, stepLimit);
    if (counts.flat != 0 && isPressedTo(driven.contacts, reachOf(estimate))) {
        counts.pressed = 1;
        counts.pressedClear = counts.flatClear;
    }
    return counts;
}

constexpr std::string_view kNoHazard = "none";

/// What one drive is like.
struct DriveKind {
    std::size_t ground = 0;  ///< index into kHazardGrounds
    std::optional<Hazard> hazard;
    PressStyle style = PressStyle::Random;
};

/// The console's press is tried with the last rate alone.
std::vector<double> ratesOf(const HazardTrial& trial, PressStyle style)
{
    if (style == PressStyle::Random) return trial.rates;
    return {trial.rates.back()};
}

/// Returns the counts of one drive for each rate.
std::vector<VerdictCounts> judgeDrive(const EstimatorBundle& bundle, const HazardTrial& trial,
                                      const DriveKind& kind, std::uint64_t seed)
{
    std::mt19937_64 rng(seed);
    const std::vector<double> rates = ratesOf(trial, kind.style);
    std::vector<VerdictCounts> counts(rates.size());
    const auto scenes =
        driveTowards(bundle.robot, kHazardGrounds[kind.ground], kind.hazard, kind.style, rng);
    for (const HazardScene& driven : scenes)
        for (std::size_t r = 0; r < rates.size(); ++r) {
            Settings settings = trial.settings;
            settings.hazardRate = rates[r];
            SceneEstimate result = estimateScene(driven.scene, bundle, settings);
            if (!result.estimate) {
                ++counts[r].failed;
                continue;
            }
            writePosteriorCheck(*result.estimate, driven.scene.s, bundle.robot);
            counts[r] += judge(driven, *result.estimate, trial.stepLimit);
        }
    return counts;
}

/// No two kinds of drives share a seed.
std::uint64_t seedOf(const HazardTrial& trial, const DriveKind& kind)
{
    const std::size_t hazard = kind.hazard ? static_cast<std::size_t>(*kind.hazard) + 1 : 0;
    const std::size_t style = kind.style == PressStyle::Random ? 0 : kHazards.size() + 1;
    return trial.seed * 10'000'019
         + ((style + hazard) * kHazardGrounds.size() + kind.ground) * 10'007;
}

void addLines(const EstimatorBundle& bundle, const HazardTrial& trial, const DriveKind& kind,
              std::vector<HazardLine>& lines)
{
    std::vector<std::vector<VerdictCounts>> drives(static_cast<std::size_t>(trial.drives));
    parallelFor(trial.drives, [&](int k) {
        const auto drive = static_cast<std::size_t>(k);
        drives[drive] = judgeDrive(bundle, trial, kind, seedOf(trial, kind) + drive);
    });
    const std::vector<double> rates = ratesOf(trial, kind.style);
    for (std::size_t r = 0; r < rates.size(); ++r) {
        HazardLine line{std::string(kHazardGrounds[kind.ground].name),
                        kind.hazard ? std::string(name(*kind.hazard)) : std::string(kNoHazard),
                        kind.style,
                        rates[r],
                        {}};
        for (const auto& counts : drives) line.counts += counts[r];
        lines.push_back(std::move(line));
    }
}

constexpr std::string_view kPressLegend = R"(
random press: 12 to 24 N m, rear flippers -15 to 40 degrees; press of the console: 18 N m, rear flippers 11 degrees
press: of the flat scenes, those in which the simulated robot truly presses on all the ground ahead up to that reach
(no stretch above 0.05 m without a contact force), press%: CLEAR of these scenes
)";

/// Which lines a total sums up.
struct Selection {
    PressStyle style = PressStyle::Random;
    double rate = 0.0;
    std::string_view ground = {};  ///< empty: all
    std::string_view hazard = {};  ///< empty: all
};

bool isSelected(const HazardLine& line, const Selection& selection)
{
    return line.style == selection.style && line.rate == selection.rate
        && (selection.ground.empty() || line.ground == selection.ground)
        && (selection.hazard.empty() || line.hazard == selection.hazard);
}

std::string totalLine(std::span<const HazardLine> lines, const std::string& what,
                      const Selection& selection)
{
    VerdictCounts sum;
    for (const HazardLine& line : lines)
        if (isSelected(line, selection)) sum += line.counts;
    return countsLine(what, sum);
}

/// Totals of each ground, first of the scenes without hazards, then of all.
std::string totals(std::span<const HazardLine> lines, PressStyle style, double rate)
{
    std::string text(kCountsHead);
    for (const std::string_view hazard : {kNoHazard, std::string_view{}}) {
        const std::string suffix = hazard.empty() ? "" : ", none";
        for (const HazardGround& ground : kHazardGrounds)
            text += totalLine(lines, std::string(ground.name) + suffix,
                              {style, rate, ground.name, hazard});
        text += totalLine(lines, "all" + suffix, {style, rate, {}, hazard});
    }
    return text;
}

std::vector<double> ratesOf(std::span<const HazardLine> lines)
{
    std::vector<double> rates;
    for (const HazardLine& line : lines)
        if (std::ranges::find(rates, line.rate) == rates.end()) rates.push_back(line.rate);
    return rates;
}

}  // namespace

std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial)
{
    std::vector<HazardLine> lines;
    for (const PressStyle style : {PressStyle::Random, PressStyle::Console})
        for (std::size_t ground = 0; ground < kHazardGrounds.size(); ++ground) {
            addLines(bundle, trial, {ground, std::nullopt, style}, lines);
            for (const Hazard hazard : kHazards)
                addLines(bundle, trial, {ground, hazard, style}, lines);
        }
    return lines;
}

std::string hazardTable(std::span<const HazardLine> lines, double rate)
{
    std::string text = fmt::format("random press, rate {} per unfelt bin\n{}", rate, kCountsHead);
    for (const HazardLine& line : lines)
        if (isSelected(line, {PressStyle::Random, rate}))
            text += countsLine(line.ground + ", " + line.hazard, line.counts);
    for (const double each : ratesOf(lines))
        text += fmt::format("\nrandom press, totals, rate {} per unfelt bin\n{}", each,
                            totals(lines, PressStyle::Random, each));
    text += fmt::format("\npress of the console, totals, rate {} per unfelt bin\n{}", rate,
                        totals(lines, PressStyle::Console, rate));
    return text.append(kPressLegend).append(kCountsLegend);
}

}  // namespace terratact
