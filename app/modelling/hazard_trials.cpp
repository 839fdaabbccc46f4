#include "app/modelling/hazard_trials.h"

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

int reachOf(const TerrainEstimate& estimate)
{
    int last = kMinHorizonBin;
    for (int bin = kFirstAhead; bin < kBins; ++bin)
        if (std::isfinite(estimate.ceiling[static_cast<std::size_t>(bin)]))
            last = std::max(last, bin);
    return last;
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

VerdictCounts judge(const HazardScene& driven, const TerrainEstimate& estimate, double stepLimit)
{
    Heights truth{};
    for (std::size_t i = 0; i < kBins; ++i) truth[i] = driven.scene.truth[i].value();
    const Verdict verdict = verdictOf(estimate, driven.scene.s, stepLimit);
    const auto horizon =
        static_cast<int>(std::lround((verdict.horizon - binBegin(0)) / kBinWidth)) - 1;
    const int reach = reachOf(estimate);
    const bool clear = verdict.stepVerdict == StepVerdict::Clear;
    const bool stepAhead = hasStep(truth, stepLimit, kFirstAhead, kBins - 1);
    const bool stepBefore = clear && hasStep(truth, stepLimit, kFirstAhead, horizon);
    const bool flat = isFlatTo(truth, stepLimit, reach);
    const bool pressed = flat && isPressedTo(driven.contacts, reach);
    VerdictCounts c;
    c.scenes = 1;
    c.contradicting = estimate.contradicts ? 1 : 0;
    c.withStep = stepAhead ? 1 : 0;
    c.clear = clear ? 1 : 0;
    c.blocked = verdict.stepVerdict == StepVerdict::Blocked ? 1 : 0;
    c.falseClear = stepBefore ? 1 : 0;
    c.overlooked = clear && stepAhead && !stepBefore ? 1 : 0;
    c.flat = flat ? 1 : 0;
    c.flatClear = flat && clear ? 1 : 0;
    c.pressed = pressed ? 1 : 0;
    c.pressedClear = pressed && clear ? 1 : 0;
    countBands(estimate, truth, c);
    return c;
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

double share(std::size_t part, std::size_t whole, double of)
{
    return whole == 0 ? 0.0 : of * static_cast<double>(part) / static_cast<double>(whole);
}

std::string tableLine(const std::string& what, const VerdictCounts& c)
{
    return fmt::format(
        "{:<20} {:>6} {:>6} {:>7} {:>6} {:>6} {:>7.2f} {:>6} {:>6.0f} {:>6} {:>6.0f} "
        "{:>6.1f} {:>6.1f} {:>6}\n",
        what, c.scenes, c.withStep, c.blocked, c.clear, c.falseClear,
        share(c.falseClear, c.withStep, 1000.0), c.flat, share(c.flatClear, c.flat, 100.0),
        c.pressed, share(c.pressedClear, c.pressed, 100.0), share(c.feltCovered, c.feltBins, 100.0),
        share(c.unfeltCovered, c.unfeltBins, 100.0), c.contradicting);
}

constexpr std::string_view kHead =
    "                     scenes   step BLOCKED  CLEAR  false  per 1k   flat  "
    "flat%  press press% felt80  unf80 contra\n";

constexpr std::string_view kLegend = R"(
random press: 12 to 24 N m, rear flippers -15 to 40 degrees; press of the console: 18 N m, rear flippers 11 degrees
step: a true step ahead; false: CLEAR with a true step before its horizon, per 1k of the scenes with a step ahead
flat: the true ground from the rear bin to the front flippers' reach is flat, flat%: CLEAR of these scenes
press: of the flat scenes, those in which the simulated robot truly presses on all the ground ahead up to that reach
(no stretch above 0.05 m without a contact force), press%: CLEAR of these scenes
felt80, unf80: cover of the 80 % bands of felt bins, and of bins ahead that are not felt [%]
contra: estimates that contradict their readings: their verdict is withheld
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
    return tableLine(what, sum);
}

/// Totals of each ground, first of the scenes without hazards, then of all.
std::string totals(std::span<const HazardLine> lines, PressStyle style, double rate)
{
    std::string text(kHead);
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

VerdictCounts& VerdictCounts::operator+=(const VerdictCounts& o)
{
    scenes += o.scenes;
    failed += o.failed;
    contradicting += o.contradicting;
    withStep += o.withStep;
    clear += o.clear;
    blocked += o.blocked;
    falseClear += o.falseClear;
    overlooked += o.overlooked;
    flat += o.flat;
    flatClear += o.flatClear;
    pressed += o.pressed;
    pressedClear += o.pressedClear;
    feltBins += o.feltBins;
    feltCovered += o.feltCovered;
    unfeltBins += o.unfeltBins;
    unfeltCovered += o.unfeltCovered;
    return *this;
}

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
    std::string text = fmt::format("random press, rate {} per unfelt bin\n{}", rate, kHead);
    for (const HazardLine& line : lines)
        if (isSelected(line, {PressStyle::Random, rate}))
            text += tableLine(line.ground + ", " + line.hazard, line.counts);
    for (const double each : ratesOf(lines))
        text += fmt::format("\nrandom press, totals, rate {} per unfelt bin\n{}", each,
                            totals(lines, PressStyle::Random, each));
    text += fmt::format("\npress of the console, totals, rate {} per unfelt bin\n{}", rate,
                        totals(lines, PressStyle::Console, rate));
    return text.append(kLegend);
}

}  // namespace terratact
