#include "core/learn/model/clearance_conditionals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/learn/data/columns.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/surface_rows.h"

namespace terratact {

namespace {

constexpr double kForceScale =
    3.0;  // [N] larger forces are compared by ratio, smaller ones by difference
constexpr double kMinSd = 1e-12;
constexpr SearchBounds kBounds{1e-3, 10.0, 5e-4,
                               3.0};  // log clearances: noise may exceed a factor e

constexpr auto kFeatureCount = static_cast<Eigen::Index>(kFeatures);

SourceText rarityOf(Regime regime)
{
    switch (regime) {
    case Regime::Covered:
        return TR_NOOP("core", "bin %1 m under the robot was seen in %2 training scenes, and %3 "
                               "are needed");
    case Regime::Open:
        return TR_NOOP("core", "bin %1 m with no robot above it was seen in %2 training scenes, "
                               "and %3 are needed");
    }
    throw std::invalid_argument("no such Regime");
}

void requireShapes(const ClearanceTraining& t)
{
    const Eigen::Index U = t.heights.rows();
    if (U < kMinTrainingRows || t.heights.cols() != kBins || t.ceilings.rows() != U
        || t.ceilings.cols() != kBins || t.features.rows() != U
        || t.features.cols() != kFeatureCount
        || (t.heightSd.rows() != 0 && (t.heightSd.rows() != U || t.heightSd.cols() != kBins)))
        throw std::invalid_argument(
            fmt::format("conditionals over clearances need at least {} rows with 11 heights, 11 "
                        "ceilings and {} features each",
                        kMinTrainingRows, kFeatures));
}

void requireNumbers(const ClearanceTraining& t)
{
    const double least = std::numeric_limits<double>::lowest();
    if (!t.heights.allFinite() || !t.features.allFinite()
        || !(t.ceilings.array() >= least).all())  // false for NaN
        throw std::invalid_argument("conditionals over clearances need finite heights and features "
                                    "and ceilings that are numbers or +infinity");
}

void require(const ClearanceTraining& training)
{
    requireShapes(training);
    requireNumbers(training);
}

/// Returns s with log(1 + force / 3 N) for the six forces, which noise may make negative; other
/// features are unchanged.
Eigen::VectorXd onModelScale(const Eigen::VectorXd& s)
{
    Eigen::VectorXd scaled = s;
    for (double& force : scaled.tail(kForceElements))
        force = std::log1p(std::max(force, 0.0) / kForceScale);
    return scaled;
}

double y(const ClearanceTraining& t, Eigen::Index row, Eigen::Index bin)
{
    return toLogClearance(t.heights(row, bin), t.ceilings(row, bin));
}

Heights row(const Eigen::MatrixXd& M, Eigen::Index u)
{
    Heights values{};
    Eigen::Map<Eigen::RowVectorXd>(values.data(), kBins) = M.row(u);
    return values;
}

std::vector<Eigen::Index> rowsIn(const ClearanceTraining& t, int bin, Regime regime)
{
    std::vector<Eigen::Index> rows;
    for (Eigen::Index u = 0; u < t.heights.rows(); ++u)
        if (regimeOf(t.ceilings(u, bin)) == regime) rows.push_back(u);
    return rows;
}

ClearanceRegimeData standardisation(const ClearanceTraining& t, int bin, Regime regime)
{
    const std::vector<Eigen::Index> rows = rowsIn(t, bin, regime);
    ClearanceRegimeData result;
    result.rows = static_cast<int>(rows.size());
    if (rows.empty()) return result;
    Eigen::VectorXd values(result.rows);
    for (std::size_t k = 0; k < rows.size(); ++k)
        values[static_cast<Eigen::Index>(k)] = y(t, rows[k], bin);
    result.mean = values.mean();
    const double sd = std::sqrt((values.array() - result.mean).square().mean());
    if (sd > kMinSd) result.sd = sd;
    return result;
}

void setFeatureStandardisation(ClearanceConditionalData& data, const Eigen::MatrixXd& features)
{
    Eigen::MatrixXd scaled(features.rows(), kFeatureCount);
    for (Eigen::Index u = 0; u < features.rows(); ++u)
        scaled.row(u) = onModelScale(features.row(u).transpose()).transpose();
    data.featureMean = scaled.colwise().mean().transpose();
    data.featureSd = (scaled.rowwise() - data.featureMean.transpose())
                         .array()
                         .square()
                         .colwise()
                         .mean()
                         .sqrt()
                         .matrix()
                         .transpose();
    for (std::size_t d = 0; d < kFeatures; ++d)
        if (!(data.featureSd[static_cast<Eigen::Index>(d)] > kMinSd))
            throw std::invalid_argument(fmt::format("{} never varies", featureColumns()[d].name));
}

/// See ClearanceConditionals::input.
Eigen::VectorXd inputOf(const ClearanceConditionalData& data, int i, const Heights& states,
                        const Heights& ceiling, const Eigen::VectorXd& s)
{
    Eigen::VectorXd x(kBins - 1 + kFeatureCount);
    Eigen::Index d = 0;
    for (int j = 0; j < kBins; ++j) {
        if (j == i) continue;
        const auto bin = static_cast<std::size_t>(j);
        const ClearanceRegimeData& scale = data.at(j, regimeOf(ceiling[bin]));
        x[d++] = (states[bin] - scale.mean) / scale.sd;
    }
    x.tail(kFeatureCount) = (onModelScale(s) - data.featureMean).cwiseQuotient(data.featureSd);
    return x;
}

/// Inputs and centred outputs of one Gaussian process.
struct Rows {
    Eigen::MatrixXd X;
    Eigen::VectorXd y;
    Eigen::VectorXd variance;  ///< of y, by the heights' sd; empty: heights are exact
};

Rows rowsFor(const ClearanceTraining& t, const ClearanceConditionalData& data, int bin,
             Regime regime)
{
    std::vector<Eigen::Index> rows = rowsIn(t, bin, regime);
    rows.resize(std::min(rows.size(), static_cast<std::size_t>(kMaxClearanceRows)));
    const auto n = static_cast<Eigen::Index>(rows.size());
    Rows result{Eigen::MatrixXd(n, kBins - 1 + kFeatureCount), Eigen::VectorXd(n),
                Eigen::VectorXd(t.heightSd.rows() > 0 ? n : 0)};
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Index u = rows[static_cast<std::size_t>(k)];
        const Heights ceiling = row(t.ceilings, u);
        Heights states = row(t.heights, u);
        for (std::size_t j = 0; j < kBins; ++j) states[j] = toLogClearance(states[j], ceiling[j]);
        result.X.row(k) =
            inputOf(data, bin, states, ceiling, t.features.row(u).transpose()).transpose();
        result.y[k] = states[static_cast<std::size_t>(bin)] - data.at(bin, regime).mean;
        if (result.variance.size() > 0)
            result.variance[k] = std::pow(
                logClearanceSd(t.heights(u, bin), t.heightSd(u, bin), t.ceilings(u, bin)), 2);
    }
    return result;
}

void requireEnoughRows(const ClearanceConditionalData& data, int bin, Regime regime)
{
    const int rows = data.at(bin, regime).rows;
    if (rows < kMinTrainingRows)
        throw NotLearnt({rarityOf(regime), signedFixed(binCentre(bin), 1), rows, kMinTrainingRows});
}

void requireBin(int bin)
{
    if (bin < 0 || bin >= kBins) throw std::invalid_argument("bins are numbered 0 to 10");
}

}  // namespace

ClearanceTraining clearanceTraining(const ModelData& model, const RobotModel& robot)
{
    std::vector<int> rows = completeRows(model);
    rows.resize(std::min(rows.size(), std::size_t{kClearanceScenes}));
    ClearanceTraining training{
        model.heights(rows, Eigen::all), {}, model.features(rows, Eigen::all), {}};
    if (model.heightSd.rows() > 0) training.heightSd = model.heightSd(rows, Eigen::all);
    training.ceilings = bodyCeilings(training.features, robot);
    return training;
}

ClearanceConditionalData clearanceConditionalData(const ModelData& model,
                                                  const ClearanceTraining& training)
{
    ClearanceConditionalData data = prepareClearanceConditionals(training);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        data.at(bin, Regime::Open).hyper = model.clearance.conditionalOpen[i];
        data.at(bin, Regime::Covered).hyper = model.clearance.conditionalCovered[i];
    }
    return data;
}

const ClearanceRegimeData& ClearanceConditionalData::at(int bin, Regime regime) const
{
    requireBin(bin);
    return bins[static_cast<std::size_t>(bin)][static_cast<std::size_t>(regime)];
}

ClearanceRegimeData& ClearanceConditionalData::at(int bin, Regime regime)
{
    return const_cast<ClearanceRegimeData&>(std::as_const(*this).at(bin, regime));
}

ClearanceConditionalData prepareClearanceConditionals(const ClearanceTraining& training)
{
    require(training);
    ClearanceConditionalData data;
    for (int i = 0; i < kBins; ++i)
        for (const Regime regime : kRegimes)
            data.at(i, regime) = standardisation(training, i, regime);
    setFeatureStandardisation(data, training.features);
    return data;
}

TrainedBin trainClearanceConditional(const ClearanceTraining& training,
                                     const ClearanceConditionalData& data, int bin, Regime regime,
                                     const TrainingOptions& options, const Poll& poll)
{
    requireEnoughRows(data, bin, regime);
    const Rows rows = rowsFor(training, data, bin, regime);
    TrainingOptions own = options;
    own.seed += 2 * static_cast<std::uint64_t>(bin) + static_cast<std::uint64_t>(regime);
    return maximiseLikelihood(rows.X, rows.y, searchStart(rows.X.cols(), data.at(bin, regime).sd),
                              own, kBounds, poll, rows.variance);
}

ClearanceConditionals::ClearanceConditionals(ClearanceTraining training,
                                             ClearanceConditionalData data)
    : training_(std::move(training)), data_(std::move(data))
{
    require(training_);
    if (data_.offset != kClearanceOffset)
        throw std::invalid_argument(
            fmt::format("the model's clearance offset is {} m, this program's {} m", data_.offset,
                        kClearanceOffset));
    if (data_.featureMean.size() != kFeatureCount || data_.featureSd.size() != kFeatureCount
        || !(data_.featureSd.array() > 0.0).all())
        throw std::invalid_argument(
            fmt::format("conditionals over clearances need mean and sd of {} features", kFeatures));
    for (int i = 0; i < kBins; ++i)
        for (const Regime regime : kRegimes)
            if (rowsIn(training_, i, regime).size()
                != static_cast<std::size_t>(data_.at(i, regime).rows))
                throw std::invalid_argument(
                    "conditionals over clearances: standardised with other training rows");
}

bool ClearanceConditionals::isTrained(int bin, Regime regime) const
{
    const ClearanceRegimeData& own = data_.at(bin, regime);
    return own.rows >= kMinTrainingRows && own.hyper.lengthScale.size() > 0;
}

const GaussianProcess& ClearanceConditionals::gp(int bin, Regime regime, int inducing,
                                                 const Poll& poll) const
{
    requireEnoughRows(data_, bin, regime);
    const ClearanceRegimeData& own = data_.at(bin, regime);
    if (own.hyper.lengthScale.size() == 0)
        throw std::invalid_argument(
            fmt::format("bin {:+.1f} m {} has not been trained", binCentre(bin),
                        regime == Regime::Open ? "with no robot above it" : "under the robot"));
    const int rows = rowsToInduce(inducing, 0, std::min(own.rows, kMaxClearanceRows));
    return lazy_[static_cast<std::size_t>(bin)][static_cast<std::size_t>(regime)].get(
        rows,
        [&] {
            Rows data = rowsFor(training_, data_, bin, regime);
            auto gp = GaussianProcess::sparse(std::move(data.X), data.y, rows, own.hyper, own.mean,
                                              poll, std::move(data.variance));
            factorised_[static_cast<std::size_t>(regime)] |= 1UL << static_cast<unsigned>(bin);
            return gp;
        },
        poll);
}

Eigen::VectorXd ClearanceConditionals::input(int i, const Heights& y, const Heights& ceiling,
                                             const Eigen::VectorXd& s) const
{
    requireBin(i);
    if (s.size() != kFeatureCount)
        throw std::invalid_argument(fmt::format("s needs {} features", kFeatures));
    return inputOf(data_, i, y, ceiling, s);
}

}  // namespace terratact
