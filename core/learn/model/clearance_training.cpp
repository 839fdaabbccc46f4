#include "core/learn/model/clearance_training.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/learn/data/columns.h"
#include "core/learn/data/side_features.h"
#include "core/learn/gp/projected_process.h"
#include "core/learn/model/clearance.h"
#include "core/learn/model/clearance_model.h"
#include "core/robot/side_plane.h"
#include "core/terrain/body_ceiling.h"
#include "core/terrain/ground_lines.h"
#include "core/terrain/kinematic_reconstruction.h"

namespace terratact {

namespace {

constexpr double kMaxNoise = 3.0;  // of surface coordinates, not metres

/// Returns the standardised surface features of those rows: n × 11.
Eigen::MatrixXd inputs(const SurfaceData& model, const std::vector<int>& rows,
                       AbsentFeatures without)
{
    Eigen::MatrixXd X(std::ssize(rows), model.features.cols());
    for (Eigen::Index k = 0; k < X.rows(); ++k)
        X.row(k) = standardisedFeatures(
                       model.clearance.featureMean, model.clearance.featureSd,
                       model.features.row(rows[static_cast<std::size_t>(k)]).transpose(), without)
                       .transpose();
    return X;
}

double surfaceOf(const SurfaceData& model, const Eigen::MatrixXd& ceilings, Eigen::Index row,
                 int bin)
{
    return toSurface(model.heights(row, bin), ceilings(row, bin));
}

/// Returns y of these bins wherever they are known in that regime; for an open bin, its known
/// heights.
std::vector<double> substitutes(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                                bool covered)
{
    std::vector<double> values;
    const auto known = [&model](Eigen::Index u, int i) {
        return isKnown(model.unknownBins, static_cast<std::size_t>(u), i);
    };
    for (Eigen::Index u = 0; u < model.heights.rows(); ++u) {
        if (!covered && known(u, bin)) values.push_back(model.heights(u, bin));
        for (int other = 0; covered && other < kBins; ++other)
            if (std::isfinite(ceilings(u, other)) && known(u, other))
                values.push_back(surfaceOf(model, ceilings, u, other));
    }
    if (values.empty()) values.push_back(0.0);  // touching
    return values;
}

TrainedSurface constantSurface(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                               bool covered, std::vector<int> rows)
{
    const std::vector<double> values = substitutes(model, ceilings, bin, covered);
    const Eigen::Map<const Eigen::ArrayXd> y(values.data(), std::ssize(values));
    TrainedSurface trained;
    trained.process.mean = y.mean();
    trained.process.residualSd = std::max(std::sqrt((y - y.mean()).square().mean()), 1e-3);
    trained.residuals.resize(std::ssize(rows));
    for (std::size_t k = 0; k < rows.size(); ++k)
        trained.residuals[static_cast<Eigen::Index>(k)] =
            surfaceOf(model, ceilings, rows[k], bin) - trained.process.mean;
    trained.rows = std::move(rows);
    return trained;
}

/// Returns how many of the sorted rows are below `kept`; all for 0.
std::size_t keptAmong(const std::vector<int>& rows, Eigen::Index kept)
{
    if (kept == 0) return rows.size();
    return static_cast<std::size_t>(
        std::lower_bound(rows.begin(), rows.end(), static_cast<int>(kept)) - rows.begin());
}

/// Returns the positions of the inducing rows among the first `rows`.
std::vector<int> inducingPositions(std::size_t rows)
{
    std::vector<int> positions(rows);
    for (std::size_t k = 0; k < rows; ++k) positions[k] = static_cast<int>(k);
    return inducingRows(positions);
}

/// Returns s of a training row.
Proprioception proprioceptionOf(const SurfaceData& model, Eigen::Index row)
{
    FeatureValues values;
    for (std::size_t d = 0; d < kFeatures; ++d)
        values[d] = model.features(row, static_cast<Eigen::Index>(d));
    return proprioception(values);
}

/// Training rows of a surface process.
struct SurfaceRows {
    std::vector<int> rows;
    Eigen::MatrixXd X;           ///< n × 11
    Eigen::VectorXd y;           ///< n, centred
    double mean = 0.0;           ///< subtracted from y
    Eigen::VectorXd variance{};  ///< n, of y by the heights' sd; empty: heights are exact
};

/// Returns the mean of y. A row with a variance of its own counts as much less as this exceeds the spread of all.
double weightedMean(const Eigen::VectorXd& y, const Eigen::VectorXd& variance)
{
    const double mean = y.mean();
    if (variance.size() == 0) return mean;
    const double spread = (y.array() - mean).square().mean();
    const Eigen::ArrayXd weight = (variance.array() + std::max(spread, 1e-12)).inverse();
    return (weight * y.array()).sum() / weight.sum();
}

SurfaceRows surfaceRows(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                        std::vector<int> rows, AbsentFeatures without)
{
    SurfaceRows own{{}, inputs(model, rows, without), Eigen::VectorXd(std::ssize(rows))};
    for (std::size_t k = 0; k < rows.size(); ++k)
        own.y[static_cast<Eigen::Index>(k)] = surfaceOf(model, ceilings, rows[k], bin);
    if (model.heightSd.rows() > 0) {
        own.variance.resize(own.y.size());
        for (std::size_t k = 0; k < rows.size(); ++k)
            own.variance[static_cast<Eigen::Index>(k)] =
                std::pow(surfaceSd(model.heights(rows[k], bin), model.heightSd(rows[k], bin),
                                   ceilings(rows[k], bin)),
                         2);
    }
    own.mean = weightedMean(own.y, own.variance);
    own.y.array() -= own.mean;
    own.rows = std::move(rows);
    return own;
}

double rootMeanSquare(const Eigen::VectorXd& values)
{
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// Returns the places of some rows; none if places is empty.
std::vector<int> some(const std::vector<int>& places, const std::vector<int>& rows)
{
    std::vector<int> own;
    if (places.empty()) return own;
    for (const int u : rows) own.push_back(places[static_cast<std::size_t>(u)]);
    return own;
}

/// Returns the positions among `rows` of the first row of each place.
std::vector<int> firstOfPlaces(const std::vector<int>& places, const std::vector<int>& rows)
{
    std::set<int> known;
    std::vector<int> firsts;
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (places.empty() || known.insert(places[static_cast<std::size_t>(rows[k])]).second)
            firsts.push_back(static_cast<int>(k));
    return firsts;
}

/// Scales residuals to the variance v that they would have with exact heights: r √(v / (v + s²)).
///   v = Σ w (r² − s²) / Σ w, w = (σ_n² + s²)⁻², at least σ_n².   variance: s²
void removeVariance(Eigen::VectorXd& residuals, const Eigen::VectorXd& variance, double noiseSd)
{
    if (variance.size() == 0) return;
    const double least = noiseSd * noiseSd;
    const Eigen::ArrayXd weight = (variance.array() + least).square().inverse();
    const Eigen::ArrayXd excess = residuals.array().square() - variance.array();
    const double v = std::max((weight * excess).sum() / weight.sum(), least);
    residuals.array() *= (v / (v + variance.array())).sqrt();
}

/// Returns weights and leave-one-out residuals with these hyperparameters.
TrainedSurface fitted(SurfaceRows own, Hyperparameters hyper, const Poll& poll,
                      const std::vector<int>& places, Eigen::Index kept)
{
    TrainedSurface trained;
    trained.process.mean = own.mean;
    trained.process.hyper = std::move(hyper);
    ProjectedProcess projected =
        projectProcess(own.X, own.y, inducingPositions(keptAmong(own.rows, kept)),
                       trained.process.hyper, poll, some(places, own.rows), own.variance);
    trained.process.weights = std::move(projected.weights);
    trained.residuals = std::move(projected.leaveOneOut);
    removeVariance(trained.residuals, own.variance, trained.process.hyper.noiseSd);
    trained.process.residualSd = rootMeanSquare(trained.residuals);
    trained.rows = std::move(own.rows);
    return trained;
}

/// Returns the heights of isolated contacts of a training row. Of a side, a contact of the flipper
/// counts in the bins of its line only.
OptionalHeights contactHeights(const SurfaceData& model, Eigen::Index row, const RobotModel& robot,
                               double threshold)
{
    if (!holdsSides(model))
        return reconstructContacts(robot, proprioceptionOf(model, row), threshold, true).height;
    const TwoTrackReadings s = readingsOf(model.features.row(row).transpose());
    OptionalHeights height = reconstructContacts(inSidePlane(robot, s.roll, robot.lateral.flipperY),
                                                 sideReadings(s, Side::Left), threshold, true)
                                 .height;
    std::fill_n(height.begin(), kFirstFlipperBin, std::nullopt);
    return height;
}

/// Gain of contacts: pairs of z − m and h − m.
struct ContactErrors {
    std::vector<double> contact, height;
    double heightVariance = 0.0;  ///< mean variance of the true heights
};

ContactErrors contactErrors(const SurfaceData& model, const Eigen::MatrixXd& ceilings,
                            const RobotModel& robot, const Poll& poll)
{
    constexpr double kThreshold = 2.0;  // [N] as in Settings
    constexpr double kMax = 0.1;        // [m]
    ContactErrors errors;
    for (Eigen::Index u = 0; u < model.heights.rows(); ++u) {
        callPoll(poll);
        const OptionalHeights contacts = contactHeights(model, u, robot, kThreshold);
        for (int bin = 0; bin < kBins; ++bin) {
            const auto& z = contacts[static_cast<std::size_t>(bin)];
            if (!z || !isKnown(model.unknownBins, static_cast<std::size_t>(u), bin)) continue;
            const double y = surfaceOf(model, ceilings, u, bin) - model.clearance.residuals(u, bin);
            const double m = toHeight(y, ceilings(u, bin));
            if (std::abs(*z - m) > kMax) continue;
            errors.contact.push_back(*z - m);
            errors.height.push_back(model.heights(u, bin) - m);
            if (model.heightSd.rows() > 0)
                errors.heightVariance += std::pow(model.heightSd(u, bin), 2);
        }
    }
    if (!errors.height.empty()) errors.heightVariance /= static_cast<double>(errors.height.size());
    return errors;
}

void calibrateContacts(SurfaceData& model, const Eigen::MatrixXd& ceilings, const RobotModel& robot,
                       const Poll& poll)
{
    constexpr double kMin = 0.005, kMax = 10.0;  // [m]
    constexpr std::size_t kMinCount = 30;
    ClearanceData& data = model.clearance;
    data.contactBias = 0.0;
    data.contactSd = kMax;
    const ContactErrors errors = contactErrors(model, ceilings, robot, poll);
    if (errors.contact.size() < kMinCount) return;
    const Eigen::Map<const Eigen::ArrayXd> z(errors.contact.data(), std::ssize(errors.contact));
    const Eigen::Map<const Eigen::ArrayXd> h(errors.height.data(), std::ssize(errors.height));
    const Eigen::ArrayXd fromMean = z - z.mean();
    const double gain = (fromMean * h).sum() / fromMean.square().sum();
    if (!(gain > 0.0)) return;
    const double variance = std::max((h - h.mean()).square().mean() - errors.heightVariance, 0.0);
    const double sd = std::sqrt(variance * std::max(1.0 - gain, 0.0) / gain);
    data.contactSd = std::clamp(sd, kMin, kMax);
    data.contactBias = std::clamp(h.mean() - z.mean(), -0.1, 0.1);
}

}  // namespace

Eigen::MatrixXd bodyCeilings(const Eigen::MatrixXd& features, const RobotModel& robot,
                             const Poll& poll)
{
    Eigen::MatrixXd ceilings(features.rows(), kBins);
    for (Eigen::Index u = 0; u < ceilings.rows(); ++u) {
        callPoll(poll);
        const Heights row =
            features.cols() == Eigen::Index{kSideFeatures}
                ? sideCeiling(robot, readingsOf(features.row(u).transpose()), Side::Left)
                : bodyCeiling(robot, features(u, 0), features(u, 1), features(u, 2));
        ceilings.row(u) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), kBins);
    }
    return ceilings;
}

void prepareClearance(SurfaceData& model, const Eigen::MatrixXd& ceilings)
{
    const Eigen::Index U = model.heights.rows();
    if (ceilings.rows() != U || ceilings.cols() != kBins || model.features.rows() != U || U < 1)
        throw std::invalid_argument("clearances need one row of eleven ceilings per training row");
    ClearanceData& data = model.clearance;
    Eigen::MatrixXd raw(U, model.features.cols());
    for (Eigen::Index u = 0; u < U; ++u)
        raw.row(u) = surfaceFeatures(model.features.row(u).transpose()).transpose();
    data.featureMean = raw.colwise().mean();
    data.featureSd =
        ((raw.rowwise() - data.featureMean.transpose()).array().square().colwise().sum()
         / static_cast<double>(U))
            .sqrt()
            .matrix();
    if (!(data.featureSd.array() > 1e-12).all())
        throw std::invalid_argument("a feature of s never varies");
    data.coveredBins.clear();
    for (Eigen::Index u = 0; u < U; ++u) {
        Heights ceiling{};
        for (int i = 0; i < kBins; ++i) ceiling[static_cast<std::size_t>(i)] = ceilings(u, i);
        data.coveredBins.push_back(coveredBins(ceiling));
    }
    data.residuals = Eigen::MatrixXd::Zero(U, kBins);
}

TrainedSurface trainSurface(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const TrainingOptions& options, const Poll& poll,
                            const std::vector<int>& places, Eigen::Index kept)
{
    std::vector<int> rows = rowsOf(model, bin, covered);
    const std::vector<int> firsts = firstOfPlaces(places, rows);
    if (std::min(firsts.size(), keptAmong(rows, kept)) < std::size_t{kMinTrainingRows})
        return constantSurface(model, ceilings, bin, covered, std::move(rows));

    SurfaceRows own = surfaceRows(model, ceilings, bin, std::move(rows), {});
    TrainingOptions search = options;
    search.seed += static_cast<std::uint64_t>(bin);
    search.fullEvaluations = 0;
    const Eigen::VectorXd variance =
        own.variance.size() > 0 ? Eigen::VectorXd(own.variance(firsts)) : Eigen::VectorXd();
    Hyperparameters hyper = maximiseLikelihood(own.X(firsts, Eigen::all), own.y(firsts),
                                               searchStart(own.X.cols(), rootMeanSquare(own.y)),
                                               search, {.mostNoise = kMaxNoise}, poll, variance)
                                .hyper;
    return fitted(std::move(own), std::move(hyper), poll, places, kept);
}

void keepRows(SurfaceData& model, Eigen::Index rows)
{
    if (rows >= model.heights.rows()) return;
    model.heights.conservativeResize(rows, Eigen::NoChange);
    if (model.heightSd.rows() > 0) model.heightSd.conservativeResize(rows, Eigen::NoChange);
    if (!model.unknownBins.empty()) {
        model.unknownBins.resize(static_cast<std::size_t>(rows));
        if (std::ssize(completeRows(model)) == rows) model.unknownBins.clear();
    }
    model.features.conservativeResize(rows, Eigen::NoChange);
    model.clearance.residuals.conservativeResize(rows, Eigen::NoChange);
    model.clearance.coveredBins.resize(static_cast<std::size_t>(rows));
}

TrainedSurface refitSurface(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const Hyperparameters& known, AbsentFeatures without,
                            const Poll& poll, const std::vector<int>& places)
{
    std::vector<int> rows = rowsOf(model, bin, covered);
    if (std::ssize(rows) < kMinTrainingRows || known.lengthScale.size() == 0)
        return constantSurface(model, ceilings, bin, covered, std::move(rows));
    return fitted(surfaceRows(model, ceilings, bin, std::move(rows), without), known, poll, places,
                  0);
}

void store(SurfaceData& model, const TrainedSurface& trained, int bin, bool covered)
{
    ClearanceData& data = model.clearance;
    auto& processes = covered ? data.covered : data.open;
    processes[static_cast<std::size_t>(bin)] = trained.process;
    for (std::size_t k = 0; k < trained.rows.size(); ++k)
        data.residuals(trained.rows[k], bin) = trained.residuals[static_cast<Eigen::Index>(k)];
}

void finishClearance(SurfaceData& model, const Eigen::MatrixXd& ceilings, const RobotModel& robot,
                     const Poll& poll, AbsentFeatures without)
{
    model.clearance.noveltyScale = ClearanceModel::noveltyScale(model, poll, without);
    calibrateContacts(model, ceilings, robot, poll);
}

}  // namespace terratact
