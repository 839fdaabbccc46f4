#include "app/modelling/evaluation/two_track_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bitset>
#include <cmath>
#include <ctime>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/runtime/parallel.h"
#include "core/base/named.h"
#include "core/infer/each_side.h"
#include "core/infer/two_track_estimator.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/side_plane.h"
#include "core/sim/two_track_check.h"
#include "core/store/csv_text.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr auto kApproachNames =
    namesOf<TrackApproach>("two tracks", "always two", "one plane", "one per side");
constexpr auto kClassNames = namesOf<TrackClass>("all", "within", "beyond", "symmetric");

using TrackScenes = std::vector<TwoTrackScene>;
using TrackPart = std::span<const TwoTrackScene>;

TwoTrackEstimate estimateBy(TrackApproach approach, const TwoTrackReadings& s,
                            const EstimatorBundle& bundle, const Settings& settings)
{
    switch (approach) {
    case TrackApproach::Both:
        return estimateTwoTracks(s, {}, bundle.robot, bundle.models, settings);
    case TrackApproach::Always:
        return estimateByBothSides(s, {}, bundle.robot, bundle.models, settings);
    case TrackApproach::Plane: return estimateAsOnePlane(s, bundle.robot, bundle.models, settings);
    case TrackApproach::PerSide:
        return estimateEachSide(s, {}, bundle.robot, bundle.models, settings);
    }
    throw std::invalid_argument("estimateBy: no such approach");
}

bool isIn(TrackClass sceneClass, const TwoTrackReadings& s, const Settings& settings)
{
    const double asymmetry =
        std::max(std::abs(s.flippers[0] - s.flippers[1]), std::abs(s.flippers[2] - s.flippers[3]));
    const bool within =
        std::abs(s.roll) <= settings.rollLimit && asymmetry <= settings.asymmetryLimit;
    switch (sceneClass) {
    case TrackClass::All: return true;
    case TrackClass::Within: return within;
    case TrackClass::Beyond: return !within;
    case TrackClass::Symmetric: return isSymmetric(s);
    }
    return false;
}

/// Adds the errors of both sides. BinError::scene counts scenes; first: number of the first one.
void addErrorsOfBoth(std::vector<BinError>& errors, std::size_t first, TrackPart scenes,
                     const TrackEstimates& estimates)
{
    for (std::size_t k = 0; k < scenes.size(); ++k)
        for (std::size_t side = 0; estimates[k] && side < 2; ++side) {
            Scene own;
            own.truth = scenes[k].truth[side];
            own.truthSd = scenes[k].truthSd[side];
            const auto more = binErrors(first + k, own, {}, estimates[k]->side[side]);
            errors.insert(errors.end(), more.begin(), more.end());
        }
}

std::vector<BinError> those(const std::vector<BinError>& errors,
                            const std::function<bool(const BinError&)>& are)
{
    std::vector<BinError> some;
    std::copy_if(errors.begin(), errors.end(), std::back_inserter(some), are);
    return some;
}

void addErrors(TrackFindings& findings, TrackApproach approach, const TrackScenes& scenes,
               const std::vector<BinError>& errors, const Settings& settings)
{
    for (const TrackClass sceneClass : kTrackClasses)
        findings.errors.push_back({approach, std::string(name(sceneClass)),
                                   statistics(those(errors, [&](const BinError& e) {
                                       return e.bin <= kLastNearBin
                                           && isIn(sceneClass, scenes[e.scene].s, settings);
                                   }))});
    for (int bin = 0; bin < kBins; ++bin)
        findings.errors.push_back(
            {approach, fmt::format("{:+.1f} m", binCentre(bin)),
             statistics(those(errors, [&](const BinError& e) { return e.bin == bin; }))});
}

/// Returns whether there is a step ahead; empty if a height is unknown.
std::optional<bool> stepAhead(const OptionalHeights& truth, double limit)
{
    Heights heights{};
    for (int bin = kFirstAhead; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        if (!truth[i]) return std::nullopt;
        heights[i] = *truth[i];
    }
    return hasStep(heights, limit, kFirstAhead);
}

/// Adds the sums of a part; averaged() divides them.
void addSteps(TrackSteps& steps, TrackPart scenes, const TrackEstimates& estimates, double limit)
{
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const auto left = stepAhead(scenes[k].truth[0], limit);
        const auto right = stepAhead(scenes[k].truth[1], limit);
        if (!estimates[k] || !left || !right) continue;
        ++steps.scenes;
        for (std::size_t side = 0; side < 2; ++side) {
            const double p = anyStep(estimates[k]->side[side], limit, kFirstAhead).p;
            const double observed = (side == 0 ? *left : *right) ? 1.0 : 0.0;
            steps.brierPerSide += (p - observed) * (p - observed) / 2.0;
            steps.forecastPerSide += p / 2.0;
            steps.observedPerSide += observed / 2.0;
        }
        const double p = eitherStep(*estimates[k], limit).p;
        const double observed = *left || *right ? 1.0 : 0.0;
        steps.brierEither += (p - observed) * (p - observed);
        steps.forecastEither += p;
        steps.observedEither += observed;
    }
}

TrackSteps averaged(TrackSteps steps)
{
    const double n = std::max<double>(1.0, static_cast<double>(steps.scenes));
    for (double* sum : {&steps.brierPerSide, &steps.brierEither, &steps.forecastPerSide,
                        &steps.forecastEither, &steps.observedPerSide, &steps.observedEither})
        *sum /= n;
    return steps;
}

/// Counts how the approach Both handled the scenes.
void countScenes(TrackFindings& findings, TrackPart scenes, const TrackEstimates& estimates,
                 const Settings& settings)
{
    findings.scenes += scenes.size();
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        findings.attitude += isIn(TrackClass::Beyond, scenes[k].s, settings) ? 1 : 0;
        if (!estimates[k]) {
            ++findings.failed;
            continue;
        }
        findings.asOnePlane += estimates[k]->onePlane ? 1 : 0;
        findings.novel += estimates[k]->side[0].novelty > 1.0 ? 1 : 0;
    }
}

Settings settingsFor(const EvaluateOptions& options, Method method)
{
    Settings settings = options.settings;
    settings.method = method;
    return settings;
}

/// Returns the approaches of a method; the first one counts scenes and time.
std::vector<TrackApproach> approachesOf(Method method)
{
    if (isClosedForm(method)) return {kTrackApproaches.begin(), kTrackApproaches.end()};
    return {TrackApproach::PerSide, TrackApproach::Plane};
}

/// Sensors that a robot may lack. Bit e of an array: element e + 1 of the front flipper.
struct Lack {
    std::string name;
    bool currents = false;
    std::bitset<kForceElements> left{}, right{};
};

std::vector<Lack> possibleLacks()
{
    const auto whole = std::bitset<kForceElements>().set();
    std::vector<Lack> all{{"nothing"}, {"currents", true}};
    for (std::size_t e = 0; e < whole.size(); ++e)
        all.push_back({fmt::format("right element {}", e + 1), false, {}, 1ULL << e});
    all.push_back({"forces", false, whole, whole});
    all.push_back({"right array", false, {}, whole});
    all.push_back({"right array, currents", true, {}, whole});
    all.push_back({"currents, forces", true, whole, whole});
    return all;
}

TrackScenes without(const Lack& lack, TrackScenes scenes)
{
    for (TwoTrackScene& scene : scenes) {
        if (lack.currents) scene.s.currents = {};
        for (std::size_t e = 0; e < lack.left.size(); ++e) {
            if (lack.left[e]) scene.s.forces[indexOf(Flipper::FrontLeft)][e].reset();
            if (lack.right[e]) scene.s.forces[indexOf(Flipper::FrontRight)][e].reset();
        }
    }
    return scenes;
}

std::string line(std::string_view approach, std::string_view what, const ErrorStatistics& e)
{
    return fmt::format("{:<13} {:<22} {:>7} {:>7.1f} {:>7.1f} {:>7.1f} % {:>7.1f}\n", approach,
                       what, e.n, 1000.0 * e.median, 1000.0 * e.mean, 100.0 * e.coverage,
                       1000.0 * e.width);
}

std::string heading(std::string_view what)
{
    return fmt::format("|error| and width of the 80 % band [mm]\n{:<13} {:<22} {:>7} {:>7} {:>7} "
                       "{:>9} {:>7}\n",
                       "approach", what, "n", "median", "mean", "covers", "width");
}

}  // namespace

std::string_view name(TrackApproach approach)
{
    return nameIn(kApproachNames, approach);
}

std::string_view name(TrackClass sceneClass)
{
    return nameIn(kClassNames, sceneClass);
}

TrackEstimates estimateTracks(TrackApproach approach, TrackPart scenes,
                              const EstimatorBundle& bundle, const Settings& settings)
{
    TrackEstimates estimates(scenes.size());
    parallelFor(static_cast<int>(scenes.size()), [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        Settings own = settings;
        own.seed += at;
        try {
            estimates[at] = estimateBy(approach, scenes[at].s, bundle, own);
        } catch (const std::invalid_argument&) {  // counted as failed
        }
    });
    return estimates;
}

std::size_t checkTracks(TrackPart scenes, const RobotModel& robot, TrackEstimates& estimates)
{
    std::atomic<std::size_t> contradicting{0};
    parallelFor(static_cast<int>(scenes.size()), [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        if (!estimates.at(at)) return;
        writePosteriorCheck(*estimates[at], measurementOf(scenes[at].s), robot);
        if (estimates[at]->side[0].contradicts) ++contradicting;
    });
    return contradicting;
}

std::vector<double> sideErrors(const TrackScenes& scenes, const RobotModel& robot,
                               const Models& models, const Settings& settings)
{
    std::vector<BinError> ofBoth;
    forParts(scenes, [&](std::size_t first, TrackPart part) {
        TrackEstimates estimates(part.size());
        parallelFor(static_cast<int>(part.size()), [&](int k) {
            const auto at = static_cast<std::size_t>(k);
            try {
                estimates[at] = estimateByBothSides(part[at].s, {}, robot, models, settings);
            } catch (const std::invalid_argument&) {  // left out
            }
        });
        addErrorsOfBoth(ofBoth, first, part, estimates);
    });
    std::vector<double> errors;
    for (const BinError& e : ofBoth)
        if (e.bin <= kLastNearBin) errors.push_back(std::abs(e.error));
    return errors;
}

Error modelOfOnePlane(const std::string& path)
{
    return fileError(path, "has learnt one plane only: `terratact train --tracks` makes a model of "
                           "two tracks");
}

TrackFindings evaluateTracks(const TrackScenes& scenes, const EstimatorBundle& bundle,
                             const EvaluateOptions& options, Method method)
{
    const Settings settings = settingsFor(options, method);
    const std::vector<TrackApproach> approaches = approachesOf(method);
    const TrackApproach timed =
        isClosedForm(method) ? TrackApproach::Always : TrackApproach::PerSide;
    TrackFindings findings;
    findings.method = method;
    for (const TrackApproach approach : approaches) {
        std::clock_t spent = 0;
        std::vector<BinError> errors;
        TrackSteps steps{.approach = approach};
        forParts(scenes, [&](std::size_t first, TrackPart part) {
            Settings own = settings;
            own.seed += first;
            const std::clock_t begin = std::clock();
            const TrackEstimates estimates = estimateTracks(approach, part, bundle, own);
            spent += std::clock() - begin;
            if (approach == approaches.front()) countScenes(findings, part, estimates, settings);
            addErrorsOfBoth(errors, first, part, estimates);
            addSteps(steps, part, estimates, options.stepLimit);
        });
        if (approach == timed)
            findings.milliseconds = 1000.0 * static_cast<double>(spent) / CLOCKS_PER_SEC
                                  / static_cast<double>(scenes.size());
        if (approach == approaches.front()) findings.truth = truthShare(errors);
        addErrors(findings, approach, scenes, errors, settings);
        findings.steps.push_back(averaged(steps));
    }
    return findings;
}

std::vector<TrackMissing> evaluateMissing(const TrackScenes& scenes, const EstimatorBundle& bundle,
                                          const EvaluateOptions& options)
{
    std::vector<TrackMissing> missing;
    for (const Lack& lack : possibleLacks()) {
        const TrackScenes left = without(lack, scenes);
        std::vector<BinError> errors;
        forParts(left, [&](std::size_t first, TrackPart part) {
            Settings own = settingsFor(options, options.methods.front());
            own.seed += first;
            addErrorsOfBoth(errors, first, part,
                            estimateTracks(TrackApproach::Always, part, bundle, own));
        });
        missing.push_back({lack.name, statistics(those(errors, [](const BinError& e) {
                               return e.bin <= kLastNearBin;
                           }))});
    }
    return missing;
}

std::string tracksTable(const TrackFindings& findings)
{
    std::string text = fmt::format("method {}\n", name(findings.method));
    text += heading("class, bins to +0.5 m");
    for (const TrackErrors& e : findings.errors) text += line(name(e.approach), e.what, e.errors);
    text += fmt::format("\nstep ahead\n{:<13} {:>7} {:>10} {:>8} {:>8} {:>12} {:>8} {:>8}\n",
                        "approach", "scenes", "Brier/side", "mean P", "share", "Brier either",
                        "mean P", "share");
    for (const TrackSteps& s : findings.steps)
        text +=
            fmt::format("{:<13} {:>7} {:>10.3f} {:>8.3f} {:>8.3f} {:>12.3f} {:>8.3f} {:>8.3f}\n",
                        name(s.approach), s.scenes, s.brierPerSide, s.forecastPerSide,
                        s.observedPerSide, s.brierEither, s.forecastEither, s.observedEither);
    const auto share = [&](std::size_t count) {
        return 100.0 * static_cast<double>(count)
             / std::max<double>(1.0, static_cast<double>(findings.scenes));
    };
    text += fmt::format("\n{} scenes, {} not estimated; {:.1f} % estimated as one plane; withheld "
                        "for attitude: {:.1f} % by one plane, {:.1f} % by two tracks (unlike the "
                        "training); {:.2f} ms of processor time for both sides\n",
                        findings.scenes, findings.failed, share(findings.asOnePlane),
                        share(findings.attitude), share(findings.novel), findings.milliseconds);
    if (const TruthShare& truth = findings.truth; truth.measured > 0)
        text += fmt::format(
            "the truth is measured: {} of {} heights have an sd, {:.1f} mm rms, {:.0f} % of "
            "the squared error of {}; coverage counts it\n",
            truth.measured, truth.n, 1000.0 * truth.sd, 100.0 * std::min(truth.share, 1.0),
            name(findings.errors.front().approach));
    return text;
}

std::string tracksCsv(std::span<const TrackFindings> methods)
{
    std::string csv = "approach,what,n,median_m,mean_m,coverage_80,width_80_m,method\n";
    for (const TrackFindings& findings : methods)
        for (const TrackErrors& e : findings.errors)
            csv += csvLine({name(e.approach), e.what, e.errors.n, e.errors.median, e.errors.mean,
                            e.errors.coverage, e.errors.width, name(findings.method)});
    return csv;
}

std::string trackStepsCsv(std::span<const TrackFindings> methods)
{
    std::string csv = "approach,scenes,brier_per_side,forecast_per_side,observed_per_side,"
                      "brier_either,forecast_either,observed_either,method\n";
    for (const TrackFindings& findings : methods)
        for (const TrackSteps& s : findings.steps)
            csv += csvLine({name(s.approach), s.scenes, s.brierPerSide, s.forecastPerSide,
                            s.observedPerSide, s.brierEither, s.forecastEither, s.observedEither,
                            name(findings.method)});
    return csv;
}

std::string missingTable(const std::vector<TrackMissing>& missing)
{
    std::string text = heading("not measured");
    for (const TrackMissing& m : missing)
        text += line(name(TrackApproach::Always), m.lacks, m.errors);
    return text;
}

std::string missingCsv(const std::vector<TrackMissing>& missing)
{
    std::string csv = "not_measured,n,median_m,mean_m,coverage_80,width_80_m\n";
    for (const TrackMissing& m : missing)
        csv += csvLine({m.lacks, m.errors.n, m.errors.median, m.errors.mean, m.errors.coverage,
                        m.errors.width});
    return csv;
}

}  // namespace terratact
