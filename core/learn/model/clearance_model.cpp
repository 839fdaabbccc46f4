#include "core/learn/model/clearance_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "core/base/normal.h"
#include "core/learn/gp/symmetric_eigen.h"
#include "core/learn/kernels/hyperparameters.h"

namespace terratact {

namespace {

constexpr Eigen::Index kSideRow = Eigen::Index{kSideFeatures};
constexpr Eigen::Index kNoveltyRows = 3000;  // of sides
constexpr int kNoveltyNeighbour = 10;
constexpr double kNoveltyShare = 0.99;

/// Returns the standardised features of all rows times the metric: d × U.
Eigen::MatrixXd scenesInMetric(const SurfaceData& model, const Eigen::VectorXd& metric,
                               AbsentFeatures without)
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
    const SymmetricEigen eigen = symmetricEigen(symmetric);
    const double least = 1e-6 * eigen.values.maxCoeff();
    if (eigen.values.minCoeff() >= least) return symmetric;
    const Eigen::MatrixXd clipped =
        eigen.vectors * eigen.values.cwiseMax(least).asDiagonal() * eigen.vectors.transpose();
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

void check(const SurfaceData& model)
{
    const ClearanceData& data = model.clearance;
    const Eigen::Index U = model.features.rows();
    if (data.residuals.rows() != U || data.residuals.cols() != kBins
        || data.coveredBins.size() != static_cast<std::size_t>(U)
        || (!model.unknownBins.empty() && std::ssize(model.unknownBins) != U)
        || data.featureMean.size() != model.features.cols()
        || data.featureSd.size() != model.features.cols() || !(data.noveltyScale > 0.0))
        throw std::invalid_argument("the model has no trained clearances");
}

/// Returns w² with own and other side alike.
Eigen::VectorXd alikeForSides(const Eigen::VectorXd& squares)
{
    Eigen::VectorXd alike(squares.size());
    for (std::size_t d = 0; d < kSideFeatures; ++d)
        alike[static_cast<Eigen::Index>(d)] =
            (squares[static_cast<Eigen::Index>(d)]
             + squares[static_cast<Eigen::Index>(otherSideFeature(d))])
            / 2.0;
    return alike;
}

/// Returns 1 for each bin that both masks have in the same regime, else 0.
Eigen::Matrix<double, kBins, 1> sameRegime(unsigned a, unsigned b)
{
    Eigen::Matrix<double, kBins, 1> same;
    for (int bin = 0; bin < kBins; ++bin)
        same[bin] = isCovered(a, bin) == isCovered(b, bin) ? 1.0 : 0.0;
    return same;
}

/// Makes a bin without process, or without a complete row, independent of the others.
void isolate(Eigen::MatrixXd& covariance, Eigen::Index i, double sd)
{
    covariance.row(i).setZero();
    covariance.col(i).setZero();
    covariance(i, i) = sd * sd;
}

}  // namespace

ClearanceModel::ClearanceModel(const SurfaceData& model, AbsentFeatures without,
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
    metric_ = metric(model, without_);
    scenes_ = scenesInMetric(model, metric_, without_);
    coveredBins_ = data.coveredBins;
    unknownBins_ = model.unknownBins;
    residuals_ = data.residuals.transpose();
    noveltyScale_ = data.noveltyScale;
    contactBias_ = data.contactBias;
    contactSd_ = data.contactSd;
    const Eigen::MatrixXd X =
        scenesInMetric(model, Eigen::VectorXd::Ones(metric_.size()), without_);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        open_[i] = prepare(data.open[i], X, rowsOf(coveredBins_, unknownBins_, bin, false));
        covered_[i] = prepare(data.covered[i], X, rowsOf(coveredBins_, unknownBins_, bin, true));
    }
    const std::vector<double> share = sharesOfPlaces(places_);
    for (Eigen::Index u = 0; u < residuals_.cols(); ++u) {
        if (!isComplete(static_cast<int>(u))) continue;
        ResidualProducts& products = products_[coveredBins_[static_cast<std::size_t>(u)]];
        const double weight = share[static_cast<std::size_t>(u)];
        products.sum += weight * residuals_.col(u) * residuals_.col(u).transpose();
        products.count += weight;
    }
    if (featureMean_.size() == kSideRow) ownSides_ = productsWith(*this);
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
        throw std::invalid_argument("clearances need all features, finite");
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

template <class Differs>
std::vector<int> ClearanceModel::nearest(const Eigen::VectorXd& squaredDistance,
                                         Differs differs) const
{
    const auto isBefore = [&](int a, int b) {
        const bool differsA = differs(a);
        const bool differsB = differs(b);
        if (differsA != differsB) return differsB;
        return squaredDistance[a] < squaredDistance[b];
    };
    return nearestOfPlaces(places_, isBefore, kNeighbours);
}

ResidualSample ClearanceModel::localResiduals(const Eigen::VectorXd& features,
                                              unsigned covered) const
{
    const Eigen::VectorXd distance = squaredDistances(features);
    const std::vector<int> rows = nearest(
        distance, [&](int u) { return coveredBins_[static_cast<std::size_t>(u)] != covered; });
    ResidualSample sample{residualWeights(distance(rows)), residuals_(Eigen::all, rows)};
    borrow(sample, 0, rows, distance, covered);
    return sample;
}

bool ClearanceModel::isComplete(int row) const
{
    return unknownBins_.empty() || unknownBins_[static_cast<std::size_t>(row)] == 0;
}

void ClearanceModel::requireSidesOf(const ClearanceModel& right) const
{
    if (featureMean_.size() != kSideRow || coveredBins_ != right.coveredBins_
        || places_ != right.places_)
        throw std::invalid_argument("both sides need models of the same scenes of two tracks");
}

ResidualSample ClearanceModel::sideResiduals(const ClearanceModel& right,
                                             const Eigen::VectorXd& leftFeatures,
                                             const SideBins& covered) const
{
    requireSidesOf(right);
    const Eigen::VectorXd distance = squaredDistances(leftFeatures);
    const std::vector<int> rows = nearest(distance, [&](int u) {
        return coveredBins_[static_cast<std::size_t>(u)] != covered[0]
            || coveredBins_[static_cast<std::size_t>(otherSideRow(u))] != covered[1];
    });
    std::vector<int> others;
    others.reserve(rows.size());
    for (const int u : rows) others.push_back(otherSideRow(u));
    ResidualSample sample{residualWeights(distance(rows)),
                          Eigen::MatrixXd(2 * kBins, std::ssize(rows))};
    sample.residual << residuals_(Eigen::all, rows), right.residuals_(Eigen::all, others);
    borrow(sample, 0, rows, distance, covered[0]);
    // The distance of a scene seen from its other side.
    Eigen::VectorXd mirrored(distance.size());
    for (int u = 0; u < static_cast<int>(distance.size()); ++u)
        mirrored[u] = distance[otherSideRow(u)];
    right.borrow(sample, kBins, others, mirrored, covered[1]);
    return sample;
}

/// Gives bins whose regime differs in their row, or whose height is unknown there, the residuals of
/// other rows. first: row of the sample that holds bin 0.
void ClearanceModel::borrow(ResidualSample& sample, Eigen::Index first,
                            const std::vector<int>& rows, const Eigen::VectorXd& distance,
                            unsigned covered) const
{
    for (int bin = 0; bin < kBins; ++bin)
        borrowBin(sample, first, rows, distance, bin, isCovered(covered, bin));
}

void ClearanceModel::borrowBin(ResidualSample& sample, Eigen::Index first,
                               const std::vector<int>& rows, const Eigen::VectorXd& distance,
                               int bin, bool covered) const
{
    std::vector<Eigen::Index> lacking;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = static_cast<std::size_t>(rows[k]);
        if (isCovered(coveredBins_[row], bin) != covered || !isKnown(unknownBins_, row, bin))
            lacking.push_back(static_cast<Eigen::Index>(k));
    }
    if (lacking.empty()) return;
    std::vector<int> donors = rowsOf(coveredBins_, unknownBins_, bin, covered);
    if (process(bin, covered).weights.size() == 0) donors.clear();
    const auto wanted = std::min(std::ssize(donors), std::ssize(lacking));
    std::partial_sort(donors.begin(), donors.begin() + wanted, donors.end(),
                      [&](int a, int b) { return distance[a] < distance[b]; });
    donors.resize(static_cast<std::size_t>(wanted));
    const double sd = process(bin, covered).residualSd;
    for (std::size_t k = 0; k < lacking.size(); ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(lacking.size());
        const double quantile = normalQuantile(share);
        sample.residual(first + bin, lacking[k]) =
            donors.empty() ? sd * quantile : residuals_(bin, donors[k % donors.size()]);
    }
}

Eigen::MatrixXd ClearanceModel::residualCovariance(unsigned covered) const
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(kBins, kBins);
    Eigen::MatrixXd count = Eigen::MatrixXd::Zero(kBins, kBins);
    for (const auto& [theirs, products] : products_) {
        const Eigen::Matrix<double, kBins, 1> in = sameRegime(theirs, covered);
        const Eigen::Matrix<double, kBins, kBins> both = in * in.transpose();
        sum += products.sum.cwiseProduct(both);
        count += products.count * both;
    }
    Eigen::MatrixXd covariance = (count.array() > 0.0).select(sum.cwiseQuotient(count), 0.0);
    for (int bin = 0; bin < kBins; ++bin) {
        const Process& p = process(bin, isCovered(covered, bin));
        if (p.weights.size() == 0 || count(bin, bin) == 0.0) isolate(covariance, bin, p.residualSd);
    }
    return nearestCovariance(covariance);
}

ClearanceModel::ProductsOfSides ClearanceModel::productsWith(const ClearanceModel& right) const
{
    ProductsOfSides all;
    Eigen::Matrix<double, 2 * kBins, 1> residual;
    for (int u = 0; u < static_cast<int>(residuals_.cols()); ++u) {
        const int other = otherSideRow(u);
        if (!isComplete(u) || !isComplete(other)) continue;
        residual << residuals_.col(u), right.residuals_.col(other);
        SideProducts& products =
            all[coveredBins_[static_cast<std::size_t>(u)]
                | coveredBins_[static_cast<std::size_t>(other)] << unsigned{kBins}];
        products.sum.noalias() += residual * residual.transpose();
        products.count += 1.0;
    }
    return all;
}

Eigen::MatrixXd ClearanceModel::sideCovariance(const ClearanceModel& right,
                                               const SideBins& covered) const
{
    requireSidesOf(right);
    constexpr Eigen::Index kBoth = Eigen::Index{2} * kBins;
    const bool alike = &right == this;
    const ProductsOfSides made = alike ? ProductsOfSides{} : productsWith(right);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(kBoth, kBoth);
    Eigen::MatrixXd count = sum;
    Eigen::Matrix<double, 2 * kBins, 1> in;
    for (const auto& [theirs, products] : alike ? ownSides_ : made) {
        in << sameRegime(theirs & ((1U << unsigned{kBins}) - 1U), covered[0]),
            sameRegime(theirs >> unsigned{kBins}, covered[1]);
        const Eigen::Matrix<double, 2 * kBins, 2 * kBins> both = in * in.transpose();
        sum += products.sum.cwiseProduct(both);
        count += products.count * both;
    }
    Eigen::MatrixXd covariance = (count.array() > 0.0).select(sum.cwiseQuotient(count), 0.0);
    for (int bin = 0; bin < kBins; ++bin) {
        const Process& own = process(bin, isCovered(covered[0], bin));
        const Process& others = right.process(bin, isCovered(covered[1], bin));
        if (own.weights.size() == 0 || count(bin, bin) == 0.0)
            isolate(covariance, bin, own.residualSd);
        if (others.weights.size() == 0 || count(kBins + bin, kBins + bin) == 0.0)
            isolate(covariance, kBins + bin, others.residualSd);
    }
    return nearestCovariance(covariance);
}

double ClearanceModel::novelty(const Eigen::VectorXd& features) const
{
    return std::sqrt(nthSmallest(squaredDistances(features), kNoveltyNeighbour)) / noveltyScale_;
}

Eigen::VectorXd ClearanceModel::metric(const SurfaceData& model, AbsentFeatures without)
{
    const ClearanceData& data = model.clearance;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(data.featureMean.size());
    double count = 0.0;
    for (const bool covered : {false, true})
        for (int bin = 0; bin < kBins; ++bin) {
            const SurfaceProcess& p =
                (covered ? data.covered : data.open)[static_cast<std::size_t>(bin)];
            if (p.weights.size() == 0) continue;
            const double weight =
                without.none() ? 1.0 : static_cast<double>(rowsOf(model, bin, covered).size());
            sum += weight * p.hyper.lengthScale.array().square().inverse().matrix();
            count += weight;
        }
    if (count == 0.0) throw std::invalid_argument("the model has no surface process");
    if (sum.size() == kSideRow) return (alikeForSides(sum) / count).cwiseSqrt();
    return (sum / count).cwiseSqrt();
}

double ClearanceModel::noveltyScale(const SurfaceData& model, const Poll& poll,
                                    AbsentFeatures without)
{
    const Eigen::MatrixXd scenes = scenesInMetric(model, metric(model, without), without);
    std::vector<double> distance;
    const Eigen::Index every =
        holdsSides(model) ? std::max<Eigen::Index>(1, scenes.cols() / kNoveltyRows) : 1;
    for (Eigen::Index u = 0; u < scenes.cols(); u += every) {
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
