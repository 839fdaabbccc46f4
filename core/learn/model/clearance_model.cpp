#include "core/learn/model/clearance_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/learn/data/scene_copies.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

namespace {

constexpr Eigen::Index kNonForces = 5;  // pitch, two angles and two currents come before the forces
constexpr double kModelForceScale = 3.0;  // [N]
constexpr int kNoveltyNeighbour = 10;
constexpr double kNoveltyShare = 0.99;

/// Returns D² of the n-th nearest, n from 1; of the last if there are fewer.
double nthSmallest(const Eigen::VectorXd& values, int n)
{
    std::vector<double> least(static_cast<std::size_t>(std::min<Eigen::Index>(n, values.size())));
    std::partial_sort_copy(values.begin(), values.end(), least.begin(), least.end());
    return least.back();
}

/// Returns the standardised features of all rows times the metric: d × U.
Eigen::MatrixXd scenesInMetric(const ModelData& model, const Eigen::VectorXd& metric,
                               MissingFeatures without)
{
    Eigen::MatrixXd scenes(model.features.cols(), model.features.rows());
    for (Eigen::Index u = 0; u < scenes.cols(); ++u)
        scenes.col(u) = standardisedFeatures(model.clearance.featureMean, model.clearance.featureSd,
                                             model.features.row(u).transpose(), without)
                            .cwiseProduct(metric);
    return scenes;
}

/// Pairs from different scenes need not form a covariance. Negative eigenvalues become a small
/// positive one; the variances stay.
Eigen::MatrixXd nearestCovariance(const Eigen::MatrixXd& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    const Eigen::VectorXd& values = solver.eigenvalues();
    const double least = 1e-6 * values.maxCoeff();
    if (values.minCoeff() >= least) return symmetric;
    const Eigen::MatrixXd& vectors = solver.eigenvectors();
    const Eigen::MatrixXd clipped =
        vectors * values.cwiseMax(least).asDiagonal() * vectors.transpose();
    const Eigen::VectorXd scale =
        (symmetric.diagonal().array() / clipped.diagonal().array()).sqrt().matrix();
    return scale.asDiagonal() * clipped * scale.asDiagonal();
}

/// Returns 1 / number of rows of the same place, for each row.
std::vector<double> sharesOfPlaces(const std::vector<int>& places)
{
    std::map<int, double> rows;
    for (const int place : places) rows[place] += 1.0;
    std::vector<double> shares;
    shares.reserve(places.size());
    for (const int place : places) shares.push_back(1.0 / rows[place]);
    return shares;
}

/// Returns the first row of each place, in order, at most `wanted`. sorted: rows.
std::vector<int> onePerPlace(const std::vector<int>& sorted, const std::vector<int>& places,
                             std::size_t wanted)
{
    std::set<int> known;
    std::vector<int> chosen;
    for (const int row : sorted) {
        if (chosen.size() == wanted) break;
        if (known.insert(places[static_cast<std::size_t>(row)]).second) chosen.push_back(row);
    }
    return chosen;
}

void check(const ModelData& model)
{
    const ClearanceData& data = model.clearance;
    const Eigen::Index U = model.features.rows();
    if (data.residuals.rows() != U || data.residuals.cols() != kBins
        || data.coveredBins.size() != static_cast<std::size_t>(U)
        || data.featureMean.size() != model.features.cols()
        || data.featureSd.size() != model.features.cols() || !(data.noveltyScale > 0.0))
        throw std::invalid_argument("the model has no trained clearances");
}

}  // namespace

Eigen::VectorXd surfaceFeatures(const Eigen::VectorXd& features)
{
    Eigen::VectorXd x = features;
    for (Eigen::Index d = kNonForces; d < x.size(); ++d)
        x[d] = std::log1p(std::max(x[d], 0.0) / kModelForceScale);
    return x;
}

Eigen::VectorXd standardisedFeatures(const Eigen::VectorXd& mean, const Eigen::VectorXd& sd,
                                     const Eigen::VectorXd& features, MissingFeatures without)
{
    Eigen::VectorXd x = (surfaceFeatures(features) - mean).cwiseQuotient(sd);
    for (std::size_t d = 0; d < without.size(); ++d)
        if (without[d]) x[static_cast<Eigen::Index>(d)] = 0.0;
    return x;
}

unsigned coveredBins(const Heights& ceiling)
{
    unsigned mask = 0;
    for (std::size_t i = 0; i < kBins; ++i)
        if (std::isfinite(ceiling[i])) mask |= 1U << i;
    return mask;
}

std::vector<int> rowsOf(const std::vector<unsigned>& coveredBins, int bin, bool covered)
{
    std::vector<int> rows;
    for (std::size_t u = 0; u < coveredBins.size(); ++u)
        if (isCovered(coveredBins[u], bin) == covered) rows.push_back(static_cast<int>(u));
    return rows;
}

std::vector<int> placesOf(const ModelData& model)
{
    if (model.repeats > 0) return placesOf(model.features, model.heights);
    std::vector<int> own(static_cast<std::size_t>(model.heights.rows()));
    std::iota(own.begin(), own.end(), 0);
    return own;
}

std::vector<int> inducingRows(const std::vector<int>& rows)
{
    if (rows.size() <= std::size_t{kInducing}) return rows;
    std::vector<int> chosen;
    for (std::size_t k = 0; k < std::size_t{kInducing}; ++k)
        chosen.push_back(rows[k * rows.size() / std::size_t{kInducing}]);
    return chosen;
}

ClearanceModel::ClearanceModel(const ModelData& model, MissingFeatures without,
                               std::vector<int> places)
    : without_(without), places_(std::move(places))
{
    check(model);
    if (places_.empty()) places_ = placesOf(model);
    if (std::ssize(places_) != model.features.rows())
        throw std::invalid_argument("clearances need one place per training row");
    const ClearanceData& data = model.clearance;
    featureMean_ = data.featureMean;
    featureSd_ = data.featureSd;
    metric_ = metric(data, without_);
    scenes_ = scenesInMetric(model, metric_, without_);
    coveredBins_ = data.coveredBins;
    residuals_ = data.residuals.transpose();
    noveltyScale_ = data.noveltyScale;
    contactBias_ = data.contactBias;
    contactSd_ = data.contactSd;
    const Eigen::MatrixXd X =
        scenesInMetric(model, Eigen::VectorXd::Ones(metric_.size()), without_);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        open_[i] = prepare(data.open[i], X, rowsOf(coveredBins_, bin, false));
        covered_[i] = prepare(data.covered[i], X, rowsOf(coveredBins_, bin, true));
    }
    const std::vector<double> share = sharesOfPlaces(places_);
    for (Eigen::Index u = 0; u < residuals_.cols(); ++u) {
        ResidualProducts& products = products_[coveredBins_[static_cast<std::size_t>(u)]];
        const double weight = share[static_cast<std::size_t>(u)];
        products.sum += weight * residuals_.col(u) * residuals_.col(u).transpose();
        products.count += weight;
    }
}

ClearanceModel::Process ClearanceModel::prepare(const SurfaceProcess& data,
                                                const Eigen::MatrixXd& X,
                                                const std::vector<int>& rows)
{
    Process process{data.mean, data.residualSd, 0.0, {}, {}, data.weights};
    if (data.weights.size() == 0) return process;
    const std::vector<int> chosen = inducingRows(rows);
    if (static_cast<Eigen::Index>(chosen.size()) != data.weights.size())
        throw std::invalid_argument("a surface process has not one weight per inducing row");
    process.signal2 = data.hyper.signalSd * data.hyper.signalSd;
    process.perLength = data.hyper.lengthScale.cwiseInverse();
    process.inducing = X(Eigen::all, chosen);
    return process;
}

const ClearanceModel::Process& ClearanceModel::process(int bin, bool covered) const
{
    const auto i = static_cast<std::size_t>(bin);
    return covered ? covered_[i] : open_[i];
}

Eigen::VectorXd ClearanceModel::standardised(const Eigen::VectorXd& features) const
{
    if (features.size() != featureMean_.size() || !features.allFinite())
        throw std::invalid_argument("clearances need all eleven features, finite");
    return standardisedFeatures(featureMean_, featureSd_, features, without_);
}

Heights ClearanceModel::predict(const Eigen::VectorXd& features, unsigned covered) const
{
    const Eigen::VectorXd x = standardised(features);
    Heights y{};
    for (int bin = 0; bin < kBins; ++bin) {
        const Process& p = process(bin, isCovered(covered, bin));
        double& mean = y[static_cast<std::size_t>(bin)];
        mean = p.mean;
        if (p.weights.size() == 0) continue;
        // Differences are scaled, not inputs, as in covariance_block.h.
        const Eigen::ArrayXd distance = (p.perLength.asDiagonal() * (p.inducing.colwise() - x))
                                            .colwise()
                                            .squaredNorm()
                                            .transpose()
                                            .array();
        mean += p.signal2 * ((-0.5 * distance).exp() * p.weights.array()).sum();
    }
    return y;
}

Eigen::VectorXd ClearanceModel::squaredDistances(const Eigen::VectorXd& features) const
{
    const Eigen::VectorXd x = standardised(features).cwiseProduct(metric_);
    return (scenes_.colwise() - x).colwise().squaredNorm().transpose();
}

std::vector<int> ClearanceModel::nearest(const Eigen::VectorXd& squaredDistance,
                                         unsigned covered) const
{
    std::vector<int> rows(coveredBins_.size());
    std::iota(rows.begin(), rows.end(), 0);
    const auto before = [&](int a, int b) {
        const bool differsA = coveredBins_[static_cast<std::size_t>(a)] != covered;
        const bool differsB = coveredBins_[static_cast<std::size_t>(b)] != covered;
        if (differsA != differsB) return differsB;
        return squaredDistance[a] < squaredDistance[b];
    };
    std::ptrdiff_t sorted = kNeighbours;
    while (true) {
        const auto end = rows.begin() + std::min<std::ptrdiff_t>(sorted, std::ssize(rows));
        std::partial_sort(rows.begin(), end, rows.end(), before);
        std::vector<int> chosen = onePerPlace({rows.begin(), end}, places_, kNeighbours);
        if (std::ssize(chosen) == kNeighbours || end == rows.end()) return chosen;
        sorted *= 2;
    }
}

ResidualSample ClearanceModel::localResiduals(const Eigen::VectorXd& features,
                                              unsigned covered) const
{
    const Eigen::VectorXd distance = squaredDistances(features);
    const std::vector<int> rows = nearest(distance, covered);
    const auto K = static_cast<Eigen::Index>(rows.size());
    const Eigen::VectorXd own = distance(rows);
    const double least = own.minCoeff();
    const double width = std::max(
        nthSmallest(own, static_cast<int>(std::max<Eigen::Index>(K / 2, 1))) - least, 1e-9);
    ResidualSample sample{(-0.5 * (own.array() - least) / width).exp().matrix(),
                          residuals_(Eigen::all, rows)};
    sample.weight /= sample.weight.sum();
    for (int bin = 0; bin < kBins; ++bin)
        borrow(sample, rows, distance, bin, isCovered(covered, bin));
    return sample;
}

void ClearanceModel::borrow(ResidualSample& sample, const std::vector<int>& rows,
                            const Eigen::VectorXd& distance, int bin, bool covered) const
{
    std::vector<Eigen::Index> lacking;
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (isCovered(coveredBins_[static_cast<std::size_t>(rows[k])], bin) != covered)
            lacking.push_back(static_cast<Eigen::Index>(k));
    if (lacking.empty()) return;
    std::vector<int> donors = rowsOf(coveredBins_, bin, covered);
    if (process(bin, covered).weights.size() == 0) donors.clear();
    std::sort(donors.begin(), donors.end(),
              [&](int a, int b) { return distance[a] < distance[b]; });
    const double sd = process(bin, covered).residualSd;
    for (std::size_t k = 0; k < lacking.size(); ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(lacking.size());
        const double quantile = std::numbers::sqrt2 * boost::math::erf_inv(2.0 * share - 1.0);
        sample.residual(bin, lacking[k]) =
            donors.empty() ? sd * quantile : residuals_(bin, donors[k % donors.size()]);
    }
}

Eigen::MatrixXd ClearanceModel::residualCovariance(unsigned covered) const
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(kBins, kBins);
    Eigen::MatrixXd count = Eigen::MatrixXd::Zero(kBins, kBins);
    for (const auto& [theirs, products] : products_) {
        Eigen::Matrix<double, kBins, 1> in;
        for (int bin = 0; bin < kBins; ++bin)
            in[bin] = isCovered(theirs, bin) == isCovered(covered, bin) ? 1.0 : 0.0;
        const Eigen::Matrix<double, kBins, kBins> both = in * in.transpose();
        sum += products.sum.cwiseProduct(both);
        count += products.count * both;
    }
    Eigen::MatrixXd covariance = (count.array() > 0.0).select(sum.cwiseQuotient(count), 0.0);
    for (int bin = 0; bin < kBins; ++bin) {
        const Process& p = process(bin, isCovered(covered, bin));
        if (p.weights.size() > 0) continue;
        covariance.row(bin).setZero();
        covariance.col(bin).setZero();
        covariance(bin, bin) = p.residualSd * p.residualSd;
    }
    return nearestCovariance(covariance);
}

double ClearanceModel::novelty(const Eigen::VectorXd& features) const
{
    return std::sqrt(nthSmallest(squaredDistances(features), kNoveltyNeighbour)) / noveltyScale_;
}

Eigen::VectorXd ClearanceModel::metric(const ClearanceData& data, MissingFeatures without)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(data.featureMean.size());
    double count = 0.0;
    for (const bool covered : {false, true})
        for (int bin = 0; bin < kBins; ++bin) {
            const SurfaceProcess& p =
                (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)];
            if (p.weights.size() == 0) continue;
            const double weight =
                without.none() ? 1.0
                               : static_cast<double>(rowsOf(data.coveredBins, bin, covered).size());
            sum += weight * p.hyper.lengthScale.array().square().inverse().matrix();
            count += weight;
        }
    if (count == 0.0) throw std::invalid_argument("the model has no surface process");
    return (sum / count).cwiseSqrt();
}

double ClearanceModel::noveltyScale(const ModelData& model, const Poll& poll,
                                    MissingFeatures without)
{
    const Eigen::MatrixXd scenes = scenesInMetric(model, metric(model.clearance, without), without);
    std::vector<double> distance;
    for (Eigen::Index u = 0; u < scenes.cols(); ++u) {
        callPoll(poll);
        // The row itself is the nearest of all.
        const Eigen::VectorXd squared =
            (scenes.colwise() - scenes.col(u)).colwise().squaredNorm().transpose();
        distance.push_back(std::sqrt(nthSmallest(squared, kNoveltyNeighbour + 1)));
    }
    const auto at =
        distance.begin()
        + static_cast<std::ptrdiff_t>(kNoveltyShare * static_cast<double>(distance.size() - 1));
    std::nth_element(distance.begin(), at, distance.end());
    return std::max(*at, 1e-12);
}

}  // namespace terratact
