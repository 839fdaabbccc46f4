#include "core/learn/model/training.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/learn/data/scene_copies.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/likelihood.h"
#include "core/learn/model/bin_models.h"

namespace terratact {

namespace {

void setStandardisation(const ModelData& model, BinModelData& data, FeatureSet set)
{
    data.set = set;
    const Eigen::MatrixXd raw = rawInputs(model, set);
    const auto rows = static_cast<double>(raw.rows());
    data.mean = raw.colwise().mean();
    data.sd = ((raw.rowwise() - data.mean.transpose()).array().square().colwise().sum() / rows)
                  .sqrt()
                  .matrix();
    for (Eigen::Index d = 0; d < data.sd.size(); ++d)
        if (!(data.sd[d] > 1e-12))
            throw std::invalid_argument(
                d < kBins ? fmt::format("the height of bin {:+.1f} m never varies",
                                        binCentre(static_cast<int>(d)))
                          : fmt::format("{} never varies",
                                        featureNames(set)[static_cast<std::size_t>(d - kBins)]));
}

Hyperparameters fromLog(const Eigen::VectorXd& theta)
{
    const Eigen::Index d = theta.size() - 2;
    return {theta.head(d).array().exp().matrix(), std::exp(theta[d]), std::exp(theta[d + 1])};
}

struct Search {
    const Eigen::MatrixXd& X;
    const Eigen::VectorXd& y;
    const Eigen::VectorXd& rowVariance;
    const Poll& poll;
    nlopt_opt optimiser;
    double best = std::numeric_limits<double>::infinity();
    Eigen::VectorXd bestTheta;
    /// exception to rethrow later: it must not pass through the optimiser, which is C code
    std::exception_ptr thrown{};
};

double uphill(unsigned n, double* gradient)
{
    if (gradient) std::fill(gradient, gradient + n, 0.0);
    return std::numeric_limits<double>::max();
}

double objective(unsigned n, const double* x, double* gradient, void* context)
{
    auto& search = *static_cast<Search*>(context);
    if (search.thrown) return uphill(n, gradient);  // a line search may continue for a while
    const Eigen::Map<const Eigen::VectorXd> theta(x, n);
    const Poll poll = [&search] {
        try {
            callPoll(search.poll);
        } catch (...) {  // of any type
            search.thrown = std::current_exception();
            throw;
        }
    };
    try {
        const Likelihood value =
            negativeLogLikelihood(search.X, search.y, fromLog(theta), poll, search.rowVariance);
        if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, n) = value.gradient;
        if (value.negativeLog < search.best) {
            search.best = value.negativeLog;
            search.bestTheta = theta;
        }
        return value.negativeLog;
    } catch (const std::invalid_argument&) {  // not positive definite here
    } catch (...) {
        search.thrown = std::current_exception();
    }
    if (search.thrown) nlopt_force_stop(search.optimiser);
    return uphill(n, gradient);
}

/// Returns the best theta found in at most `evaluations` evaluations from `start`.
Eigen::VectorXd minimise(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                         const Eigen::VectorXd& rowVariance, const Eigen::VectorXd& start,
                         int evaluations, const SearchBounds& bounds, const Poll& poll,
                         double& best)
{
    const auto n = static_cast<unsigned>(start.size());
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(NLOPT_LD_LBFGS, n), &nlopt_destroy);
    Search search{
        X, y, rowVariance, poll, optimiser.get(), std::numeric_limits<double>::infinity(), start};
    Eigen::VectorXd low = Eigen::VectorXd::Constant(start.size(), std::log(0.05));
    Eigen::VectorXd high = Eigen::VectorXd::Constant(start.size(), std::log(1000.0));
    low.tail(2) << std::log(bounds.leastSignal), std::log(bounds.leastNoise);
    high.tail(2) << std::log(bounds.mostSignal), std::log(bounds.mostNoise);
    nlopt_set_lower_bounds(optimiser.get(), low.data());
    nlopt_set_upper_bounds(optimiser.get(), high.data());
    nlopt_set_min_objective(optimiser.get(), objective, &search);
    nlopt_set_maxeval(optimiser.get(), evaluations);
    nlopt_set_ftol_rel(optimiser.get(), 1e-7);
    Eigen::VectorXd theta = start.cwiseMax(low).cwiseMin(high);
    double value = 0.0;
    nlopt_optimize(optimiser.get(), theta.data(), &value);
    if (search.thrown) std::rethrow_exception(search.thrown);
    best = search.best;
    return search.bestTheta;
}

std::vector<int> drawRows(int total, int wanted, std::uint64_t seed)
{
    std::vector<int> rows(static_cast<std::size_t>(total));
    std::iota(rows.begin(), rows.end(), 0);
    std::mt19937_64 rng(seed);
    std::shuffle(rows.begin(), rows.end(), rng);
    rows.resize(static_cast<std::size_t>(std::min(total, wanted)));
    std::sort(rows.begin(), rows.end());
    return rows;
}

/// Returns the sd of the heights of these scenes, 0 where a height is exact; no rows if all are.
Eigen::MatrixXd heightSdOf(const std::vector<const Scene*>& scenes)
{
    Eigen::MatrixXd sd = Eigen::MatrixXd::Zero(std::ssize(scenes), kBins);
    for (Eigen::Index u = 0; u < sd.rows(); ++u) {
        const Scene& scene = *scenes[static_cast<std::size_t>(u)];
        for (std::size_t i = 0; i < kBins; ++i)
            if (scene.truth[i])
                sd(u, static_cast<Eigen::Index>(i)) = scene.truthSd[i].value_or(0.0);
    }
    if ((sd.array() == 0.0).all()) sd.resize(0, 0);
    return sd;
}

/// Returns the scenes with all features and at least one height; those with all heights come first.
std::vector<const Scene*> usableScenes(const std::vector<Scene>& scenes)
{
    std::vector<const Scene*> complete, incomplete;
    for (const Scene& scene : scenes) {
        if (isComplete(scene))
            complete.push_back(&scene);
        else if (missingFeature(FeatureSet::Paf, scene.s).empty() && knowsHeights(scene.truth))
            incomplete.push_back(&scene);
    }
    complete.insert(complete.end(), incomplete.begin(), incomplete.end());
    return complete;
}

/// places: number of complete rows that start a place; they come first.
void setConditionalRows(ModelData& model, Eigen::Index places, const RowOptions& options)
{
    const Eigen::Index rows = std::min<Eigen::Index>(options.conditionalRows, places);
    model.scannedHeights = model.heights.topRows(rows);
    std::mt19937_64 rng(options.seed);
    std::normal_distribution<double> noise;
    for (Eigen::Index u = 0; u < rows; ++u)
        for (Eigen::Index i = 0; i < kBins; ++i)
            model.scannedHeights(u, i) += options.scannerSd * noise(rng);
}

}  // namespace

bool isComplete(const Scene& scene)
{
    return missingFeature(FeatureSet::Paf, scene.s).empty() && unknownMask(scene.truth) == 0;
}

TrainingSet prepareTraining(const std::vector<Scene>& scenes, const RowOptions& options)
{
    TrainingSet set;
    std::vector<const Scene*> rows = usableScenes(scenes);
    set.leftOut = static_cast<int>(scenes.size() - rows.size());
    SceneCopies copies = withoutCopies(rows);
    rows = std::move(copies.kept);
    set.exactCopies = static_cast<int>(copies.exact);
    set.nearCopies = static_cast<int>(copies.repeats.size());
    const auto places = static_cast<int>(
        std::ranges::find_if_not(rows, [](const Scene* scene) { return isComplete(*scene); })
        - rows.begin());
    const auto incomplete = static_cast<int>(rows.size()) - places;
    rows.insert(rows.end(), copies.repeats.begin(), copies.repeats.end());
    set.runsWithCopies = std::move(copies.runs);
    set.used = static_cast<int>(rows.size());
    if (places < kMinTrainingRows)
        throw std::invalid_argument(
            fmt::format("training needs at least {} scenes, each different, with all heights, "
                        "currents and forces known, found {}{}",
                        kMinTrainingRows, places,
                        incomplete > 0 ? fmt::format(" and {} with unknown heights", incomplete)
                                       : std::string()));
    ModelData& model = set.model;
    model.repeats = set.nearCopies;
    model.heights.resize(set.used, kBins);
    model.features.resize(set.used,
                          static_cast<Eigen::Index>(featureNames(FeatureSet::Paf).size()));
    for (Eigen::Index u = 0; u < set.used; ++u) {
        const Scene& scene = *rows[static_cast<std::size_t>(u)];
        for (Eigen::Index i = 0; i < kBins; ++i)
            model.heights(u, i) = scene.truth[static_cast<std::size_t>(i)].value_or(0.0);
        model.unknownBins.push_back(unknownMask(scene.truth));
        if (model.unknownBins.back() != 0) ++set.withHoles;
        model.features.row(u) = features(FeatureSet::Paf, scene.s).transpose();
    }
    if (set.withHoles == 0) model.unknownBins.clear();
    model.heightSd = heightSdOf(rows);
    setConditionalRows(model, places, options);
    setStandardisation(model, model.pa, FeatureSet::Pa);
    setStandardisation(model, model.paf, FeatureSet::Paf);
    return set;
}

Eigen::VectorXd heightVariance(const SurfaceData& data, int bin, Eigen::Index rows)
{
    if (data.heightSd.rows() == 0) return {};
    return data.heightSd.col(bin).head(rows).array().square();
}

Eigen::VectorXd searchStart(Eigen::Index d, double outputSd)
{
    Eigen::VectorXd theta =
        Eigen::VectorXd::Constant(d + 2, 0.5 * std::log(static_cast<double>(d)));
    theta.tail(2) << std::log(outputSd), std::log(0.2 * outputSd);
    return theta;
}

TrainedBin maximiseLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                              const Eigen::VectorXd& start, const TrainingOptions& options,
                              const SearchBounds& bounds, const Poll& poll,
                              const Eigen::VectorXd& rowVariance)
{
    requireRowVariance(rowVariance, y.size());
    const auto varianceOf = [&rowVariance](const std::vector<int>& rows) {
        return rowVariance.size() > 0 ? Eigen::VectorXd(rowVariance(rows)) : Eigen::VectorXd();
    };
    Eigen::VectorXd theta = start;
    double best = 0.0;
    const auto total = static_cast<int>(X.rows());
    const std::vector<int> rows = drawRows(total, options.subset, options.seed);
    const bool thinned = static_cast<Eigen::Index>(rows.size()) < X.rows();
    if (thinned || options.fullEvaluations == 0)
        theta = minimise(X(rows, Eigen::all), y(rows), varianceOf(rows), theta,
                         options.subsetEvaluations, bounds, poll, best);
    if (options.fullEvaluations > 0) {
        const std::vector<int> full =
            drawRows(total, options.fullRows > 0 ? options.fullRows : total, options.seed);
        theta = minimise(X(full, Eigen::all), y(full), varianceOf(full), theta,
                         options.fullEvaluations, bounds, poll, best);
    }
    return {fromLog(theta), -best};
}

TrainedBin trainBin(const ModelData& model, FeatureSet set, int bin, const TrainingOptions& options,
                    const Poll& poll)
{
    const BinModelData& data = set == FeatureSet::Pa ? model.pa : model.paf;
    const Eigen::MatrixXd X =
        withoutBin(standardised(rawInputs(model, set), data.mean, data.sd), bin);
    const Eigen::VectorXd y = model.scannedHeights.col(bin).array() - data.mean[bin];
    TrainingOptions ofBin = options;
    ofBin.seed += static_cast<std::uint64_t>(bin);
    return maximiseLikelihood(X, y, searchStart(X.cols(), data.sd[bin]), ofBin, {}, poll,
                              heightVariance(model, bin, y.size()));
}

}  // namespace terratact
