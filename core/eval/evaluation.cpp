#include "core/eval/evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/infer/quantile.h"
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

/// Share of errors with the truth in the band; 0 for none.
double coverageOf(std::span<const BinError> errors)
{
    if (errors.empty()) return 0.0;
    const auto inside =
        std::count_if(errors.begin(), errors.end(), [](const BinError& e) { return e.inBand; });
    return static_cast<double>(inside) / static_cast<double>(errors.size());
}

MethodSummary summaryOf(Method method, std::span<const BinError> errors)
{
    MethodSummary summary{method, {}, statistics(errors)};
    for (int bin = 0; bin < kBins; ++bin)
        summary.bin[static_cast<std::size_t>(bin)] =
            statistics(only(errors, [bin](const BinError& e) { return e.bin == bin; }));
    return summary;
}

}  // namespace

std::vector<BinError> binErrors(std::size_t sceneIndex, const Scene& scene,
                                const TerrainEstimate& estimate)
{
    std::vector<BinError> errors;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (!scene.truth[i]) continue;
        const double truth = *scene.truth[i];
        errors.push_back({.scene = sceneIndex,
                          .method = estimate.settings.method,
                          .bin = static_cast<int>(i),
                          .error = estimate.height[i] - truth,
                          .inBand = estimate.q10[i] <= truth && truth <= estimate.q90[i],
                          .origin = estimate.origin[i]});
    }
    return errors;
}

ErrorStatistics statistics(std::span<const BinError> errors)
{
    ErrorStatistics result;
    if (errors.empty()) return result;
    std::vector<double> size;
    for (const BinError& e : errors) size.push_back(std::abs(e.error));
    result.n = errors.size();
    result.q1 = quantile(size, 0.25);
    result.median = quantile(size, 0.5);
    result.q3 = quantile(size, 0.75);
    for (const double x : size) result.mean += x / static_cast<double>(size.size());
    result.coverage = coverageOf(errors);

    const auto sampled =
        only(errors, [](const BinError& e) { return e.origin == Origin::Sampled; });
    result.sampled = sampled.size();
    result.sampledCoverage = coverageOf(sampled);
    return result;
}

std::vector<MethodSummary> summarise(std::span<const BinError> errors)
{
    std::vector<MethodSummary> summaries;
    for (const Method method : kMethods) {
        const auto own = only(errors, [method](const BinError& e) { return e.method == method; });
        if (!own.empty()) summaries.push_back(summaryOf(method, own));
    }
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
    if (!(width > 0.0) || classes < 1)
        throw std::invalid_argument("histograms: width and classes must be above 0");
    std::vector<ErrorHistogram> result;
    for (const Method method : kMethods) {
        ErrorHistogram histogram{method, width,
                                 std::vector<std::size_t>(static_cast<std::size_t>(classes)), 0};
        for (const BinError& e : errors) {
            if (e.method != method) continue;
            const double last = static_cast<double>(classes - 1);
            ++histogram.count[static_cast<std::size_t>(
                std::min(std::floor(std::abs(e.error) / width), last))];
            ++histogram.n;
        }
        if (histogram.n > 0) result.push_back(std::move(histogram));
    }
    return result;
}

}  // namespace terratact
