#include "core/eval/evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/infer/estimate/quantile.h"
#include "core/robot/kinematics.h"

namespace terratact {
namespace {

template <class Keep>
std::vector<BinError> only(std::span<const BinError> errors, Keep keep)
{
    std::vector<BinError> kept;
    std::copy_if(errors.begin(), errors.end(), std::back_inserter(kept), keep);
    return kept;
}

/// Returns the mean of a number per error; 0 for none.
template <class Number>
double meanOf(std::span<const BinError> errors, Number number)
{
    double sum = 0.0;
    for (const BinError& e : errors) sum += number(e);
    return errors.empty() ? 0.0 : sum / static_cast<double>(errors.size());
}

double coverageOf(std::span<const BinError> errors)
{
    return meanOf(errors, [](const BinError& e) { return e.scores.in80 ? 1.0 : 0.0; });
}

MethodSummary summaryOf(const std::string& label, std::span<const BinError> errors)
{
    MethodSummary summary{label, {}, statistics(errors), {}};
    for (int bin = 0; bin < kBins; ++bin)
        summary.bin[static_cast<std::size_t>(bin)] =
            statistics(only(errors, [bin](const BinError& e) { return e.bin == bin; }));
    summary.near =
        statistics(only(errors, [](const BinError& e) { return e.bin <= kLastNearBin; }));
    return summary;
}

/// Returns one histogram per label of number(error), which is 0 or more.
template <class Number>
std::vector<ErrorHistogram> classify(std::span<const BinError> errors, double width, int classes,
                                     Number number)
{
    if (!(width > 0.0) || classes < 1)
        throw std::invalid_argument("histograms: width and classes must be above 0");
    std::vector<ErrorHistogram> result;
    for (const std::string& label : labelsOf(errors)) {
        ErrorHistogram histogram{label, width,
                                 std::vector<std::size_t>(static_cast<std::size_t>(classes)), 0};
        const double last = static_cast<double>(classes - 1);
        for (const BinError& e : errorsOf(label, errors)) {
            ++histogram
                  .count[static_cast<std::size_t>(std::min(std::floor(number(e) / width), last))];
            ++histogram.n;
        }
        result.push_back(std::move(histogram));
    }
    return result;
}

}  // namespace

std::string labelOf(const Settings& settings)
{
    return std::string(name(settings.method));
}

std::vector<BinError> binErrors(std::size_t sceneIndex, const Scene& scene,
                                const std::string& label, const TerrainEstimate& estimate)
{
    std::vector<BinError> errors;
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        if (!scene.truth[i]) continue;
        errors.push_back({.scene = sceneIndex,
                          .label = label,
                          .bin = bin,
                          .error = estimate.height[i] - *scene.truth[i],
                          .scores = forecastScores(estimate, bin, *scene.truth[i],
                                                   scene.truthSd[i].value_or(0.0)),
                          .origin = estimate.origin[i],
                          .novelty = estimate.novelty,
                          .truthSd = scene.truthSd[i].value_or(0.0)});
    }
    return errors;
}

std::vector<std::string> labelsOf(std::span<const BinError> errors)
{
    std::vector<std::string> labels;
    for (const BinError& e : errors)
        if (std::find(labels.begin(), labels.end(), e.label) == labels.end())
            labels.push_back(e.label);
    return labels;
}

std::vector<BinError> errorsOf(std::string_view label, std::span<const BinError> errors)
{
    return only(errors, [label](const BinError& e) { return e.label == label; });
}

ErrorStatistics statistics(std::span<const BinError> errors)
{
    ErrorStatistics result;
    if (errors.empty()) return result;
    std::vector<double> size;
    size.reserve(errors.size());
    for (const BinError& e : errors) size.push_back(std::abs(e.error));
    result.n = errors.size();
    result.q1 = quantile(size, 0.25);
    result.median = quantile(size, 0.5);
    result.q3 = quantile(size, 0.75);
    for (const double x : size) result.mean += x / static_cast<double>(size.size());
    result.crps = meanOf(errors, [](const BinError& e) { return e.scores.crps; });
    result.coverage50 = meanOf(errors, [](const BinError& e) { return e.scores.in50 ? 1.0 : 0.0; });
    result.coverage = coverageOf(errors);
    result.coverage95 = meanOf(errors, [](const BinError& e) { return e.scores.in95 ? 1.0 : 0.0; });
    result.width = meanOf(errors, [](const BinError& e) { return e.scores.width; });

    const auto sampled =
        only(errors, [](const BinError& e) { return e.origin == Origin::Sampled; });
    result.sampled = sampled.size();
    result.sampledCoverage = coverageOf(sampled);
    return result;
}

TruthShare truthShare(std::span<const BinError> errors)
{
    TruthShare share;
    double own = 0.0, all = 0.0;
    for (const BinError& e : errors) {
        if (e.truthSd > 0.0) ++share.measured;
        own += e.truthSd * e.truthSd;
        all += e.error * e.error;
    }
    share.n = errors.size();
    if (share.n > 0) share.sd = std::sqrt(own / static_cast<double>(share.n));
    if (all > 0.0) share.share = own / all;
    return share;
}

std::vector<MethodSummary> summarise(std::span<const BinError> errors)
{
    std::vector<MethodSummary> summaries;
    for (const std::string& label : labelsOf(errors))
        summaries.push_back(summaryOf(label, errorsOf(label, errors)));
    return summaries;
}

std::vector<int> binsUnderFrontFlipper(const RobotModel& robot, const Proprioception& s)
{
    const TaperedHull flipper = shapeAt(robot, poseInDem(robot, s.pitch, s.front, s.rear)).front;
    const double pivot = flipper.a.x;
    const double tip = flipper.b.x + std::copysign(flipper.rb, flipper.b.x - pivot);
    std::vector<int> bins;
    for (int i = 0; i < kBins; ++i)
        if (binCentre(i) >= std::min(pivot, tip) && binCentre(i) <= std::max(pivot, tip))
            bins.push_back(i);
    return bins;
}

std::vector<BinError> errorsInBins(std::span<const BinError> errors,
                                   std::span<const std::vector<int>> bins)
{
    return only(errors, [&](const BinError& e) {
        if (e.scene >= bins.size())
            throw std::invalid_argument("errorsInBins: a scene without its list of bins");
        return std::count(bins[e.scene].begin(), bins[e.scene].end(), e.bin) > 0;
    });
}

std::vector<ErrorHistogram> histograms(std::span<const BinError> errors, double width, int classes)
{
    return classify(errors, width, classes, [](const BinError& e) { return std::abs(e.error); });
}

std::vector<ErrorHistogram> pitHistograms(std::span<const BinError> errors, int classes)
{
    if (classes < 1) throw std::invalid_argument("pitHistograms: at least one class");
    return classify(errors, 1.0 / classes, classes, [](const BinError& e) { return e.scores.pit; });
}

}  // namespace terratact
