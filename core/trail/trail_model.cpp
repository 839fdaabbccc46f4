#include "core/trail/trail_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "core/base/message.h"
#include "core/learn/model/surface_rows.h"
#include "core/trail/trail_inputs.h"

namespace terratact {
namespace {

using SideMasks = std::array<unsigned, 2>;

/// Standardised inputs farther than this count as this far: training held none.
constexpr double kFarthestInput = 10.0;
constexpr float kFarthestSizeInput = 4.0F;  // the same for the size of errors
constexpr float kMaxLogSize = 3.0F;         // and as far below 0

void requireOfTrail(bool holds, const char* what)
{
    if (!holds) throw std::invalid_argument(fmt::format("trail networks: {}", what));
}

void requireErrors(const TrailErrors& errors, Eigen::Index rows)
{
    requireOfTrail(errors.predicted.rows() == rows && errors.residual.rows() == rows
                       && errors.predicted.cols() == errors.residual.cols()
                       && std::ssize(errors.covered) == errors.predicted.cols()
                       && errors.drive.size() == errors.covered.size(),
                   "sizes of the errors disagree");
    requireOfTrail(errors.predicted.cols() >= kTrailNeighbours,
                   "too few scenes tell of the errors");
    requireOfTrail(errors.predicted.allFinite() && errors.residual.allFinite(),
                   "an error is not finite");
}

const TrailScale& scaleOf(const TrailNetworks& networks, int bin, unsigned covered)
{
    const auto i = static_cast<std::size_t>(bin);
    return isCovered(covered, bin) ? networks.covered[i] : networks.open[i];
}

/// A scene of the errors, as it is or mirrored.
struct Similar {
    Eigen::Index scene = 0;
    bool isMirrored = false;
    double squared = 0.0;
};

/// Returns the nearest scenes, kTrailNeighbours of as many drives as possible.
std::vector<Similar> nearestOfDrives(const std::vector<Similar>& all, const std::vector<int>& drive)
{
    std::vector<int> places;
    places.reserve(all.size());
    for (const Similar& scene : all)
        places.push_back(2 * drive[static_cast<std::size_t>(scene.scene)]
                         + (scene.isMirrored ? 1 : 0));
    const auto isNearer = [&](int a, int b) {
        return all[static_cast<std::size_t>(a)].squared < all[static_cast<std::size_t>(b)].squared;
    };
    std::vector<int> rows;
    for (int each = 1; std::ssize(rows) < kTrailNeighbours && each <= kTrailNeighbours; ++each)
        rows = nearestOfPlaces(places, isNearer, std::size_t{kTrailNeighbours}, each);
    std::vector<Similar> nearest;
    nearest.reserve(rows.size());
    for (const int row : rows) nearest.push_back(all[static_cast<std::size_t>(row)]);
    return nearest;
}

/// Returns a column with the upper and the lower half exchanged.
Eigen::VectorXf exchanged(const Eigen::VectorXf& column)
{
    Eigen::VectorXf other(column.size());
    const Eigen::Index half = column.size() / 2;
    other << column.tail(half), column.head(half);
    return other;
}

double otherRegimes(const SideMasks& a, const SideMasks& b, Eigen::Index sides)
{
    int bins = std::popcount(a[0] ^ b[0]);
    if (sides == 2) bins += std::popcount(a[1] ^ b[1]);
    return TrailModel::kOtherRegime * bins;
}

std::vector<Similar> nearestScenes(const TrailErrors& errors, const Eigen::VectorXf& predicted,
                                   const SideMasks& covered)
{
    const Eigen::Index sides = predicted.size() / kBins;
    std::vector<Similar> all;
    all.reserve(errors.covered.size() * static_cast<std::size_t>(sides));
    for (Eigen::Index k = 0; k < sides; ++k) {
        const bool mirror = k == 1;
        const Eigen::VectorXf own = mirror ? exchanged(predicted) : predicted;
        const SideMasks masks = mirror ? SideMasks{covered[1], covered[0]} : covered;
        const Eigen::VectorXf squared =
            (errors.predicted.colwise() - own).colwise().squaredNorm().transpose();
        for (Eigen::Index u = 0; u < squared.size(); ++u)
            all.push_back(
                {u, mirror,
                 static_cast<double>(squared[u])
                     + otherRegimes(errors.covered[static_cast<std::size_t>(u)], masks, sides)});
    }
    return nearestOfDrives(all, errors.drive);
}

/// Returns the mean and the errors in y of a prediction in sd of TrailScale.
TrailPrediction inSurfaceCoordinates(const TrailNetworks& networks,
                                     const Eigen::VectorXf& predicted, const Eigen::VectorXf& size,
                                     const SideMasks& covered)
{
    const std::vector<Similar> similar = nearestScenes(networks.errors, predicted, covered);
    Eigen::VectorXd squared(std::ssize(similar));
    Eigen::MatrixXd residual(predicted.size(), squared.size());
    for (Eigen::Index k = 0; k < squared.size(); ++k) {
        const Similar& scene = similar[static_cast<std::size_t>(k)];
        const Eigen::VectorXf own = networks.errors.residual.col(scene.scene);
        residual.col(k) =
            (scene.isMirrored ? exchanged(own) : own).cwiseProduct(size).cast<double>();
        squared[k] = scene.squared;
    }
    const Eigen::VectorXd weight = residualWeights(squared);
    const Eigen::VectorXd middle = residual * weight;
    residual.colwise() -= middle;
    TrailPrediction prediction{Eigen::VectorXd(predicted.size()), {weight, std::move(residual)}};
    for (Eigen::Index i = 0; i < predicted.size(); ++i) {
        const TrailScale& scale = scaleOf(networks, static_cast<int>(i % kBins),
                                          covered[static_cast<std::size_t>(i / kBins)]);
        prediction.mean[i] = scale.mean + scale.sd * static_cast<double>(predicted[i]);
        prediction.errors.residual.row(i) *= scale.sd;
    }
    return prediction;
}

}  // namespace

void requireTrailNetworks(const TrailNetworks& networks, Eigen::Index inputs, Eigen::Index sides)
{
    requireOfTrail(networks.inputMean.size() == inputs && networks.inputSd.size() == inputs,
                   "another number of inputs");
    requireOfTrail(networks.inputMean.allFinite() && networks.inputSd.allFinite()
                       && (networks.inputSd.array() > 0.0).all(),
                   "an input's mean or sd is out of range");
    for (const auto& scales : {networks.open, networks.covered})
        for (const TrailScale& scale : scales)
            requireOfTrail(std::isfinite(scale.mean) && std::isfinite(scale.sd) && scale.sd >= 0.0,
                           "a bin's mean or sd is out of range");
    requireOfTrail(!networks.networks.empty(), "there is none");
    for (const Network& network : networks.networks) {
        requireNetwork(network);
        requireOfTrail(network.inputs() == inputs && network.outputs() == Eigen::Index{kBins},
                       "a network has another number of inputs or outputs");
    }
    requireNetwork(networks.size);
    requireOfTrail(std::ssize(networks.size.layers) == 1 && networks.size.inputs() == kBins + inputs
                       && networks.size.outputs() == Eigen::Index{kBins},
                   "the size of errors has another number of inputs or outputs");
    requireErrors(networks.errors, sides * kBins);
    for (const DriveMarks& marks : networks.drives)
        requireOfTrail(!marks.empty() && marks.size() <= kMaxDriveMarks
                           && std::ranges::adjacent_find(marks, std::greater_equal())
                                  == marks.end(),
                       "a training drive has no marks, too many, or not in order");
}

TrailOutput outputOf(const TrailNetworks& networks, const Eigen::VectorXd& inputs)
{
    if (inputs.size() != networks.inputMean.size() || !inputs.allFinite())
        throw std::invalid_argument("trail networks need all inputs, finite");
    const Eigen::VectorXf x = (inputs - networks.inputMean)
                                  .cwiseQuotient(networks.inputSd)
                                  .cwiseMax(-kFarthestInput)
                                  .cwiseMin(kFarthestInput)
                                  .cast<float>();
    Eigen::MatrixXf each(Eigen::Index{kBins}, std::ssize(networks.networks));
    for (Eigen::Index k = 0; k < each.cols(); ++k)
        each.col(k) = networks.networks[static_cast<std::size_t>(k)].output(x);
    if (!each.allFinite())
        throw RefusedInput(TR_NOOP("core", "the networks of method trail give no finite number"));
    TrailOutput output{each.rowwise().mean(), Eigen::VectorXf(kBins + x.size())};
    each.colwise() -= output.mean;
    const Eigen::ArrayXf spread = each.array().square().rowwise().mean().sqrt();
    output.sizeInputs << (spread + static_cast<float>(kMinSpread)).log().matrix(),
        x.cwiseMax(-kFarthestSizeInput).cwiseMin(kFarthestSizeInput);
    return output;
}

Eigen::VectorXf errorSize(const TrailNetworks& networks, const TrailOutput& output)
{
    return networks.size.output(output.sizeInputs)
        .cwiseMax(-kMaxLogSize)
        .cwiseMin(kMaxLogSize)
        .array()
        .exp();
}

bool TrailNetworks::knows(unsigned mask) const
{
    if (isEmpty()) return false;
    for (int bin = 0; bin < kBins; ++bin)
        if (!(scaleOf(*this, bin, mask).sd > 0.0)) return false;
    return true;
}

TrailModel::TrailModel(TrailData data) : data_(std::move(data))
{
    if (hasPlane()) requireTrailNetworks(data_.plane, kPlaneInputs, 1);
    if (hasSides()) requireTrailNetworks(data_.side, kSideInputs, 2);
}

TrailPrediction TrailModel::plane(const Eigen::VectorXd& inputs, unsigned covered) const
{
    if (!hasPlane()) throw std::invalid_argument("no trail networks of one plane");
    const TrailOutput output = outputOf(data_.plane, inputs);
    return inSurfaceCoordinates(data_.plane, output.mean, errorSize(data_.plane, output),
                                {covered, covered});
}

TrailPrediction TrailModel::sides(const std::array<Eigen::VectorXd, 2>& inputs,
                                  const std::array<unsigned, 2>& covered) const
{
    if (!hasSides()) throw std::invalid_argument("no trail networks of both sides");
    const TrailOutput left = outputOf(data_.side, inputs[0]);
    const TrailOutput right = outputOf(data_.side, inputs[1]);
    Eigen::VectorXf predicted(Eigen::Index{2} * kBins), size(Eigen::Index{2} * kBins);
    predicted << left.mean, right.mean;
    size << errorSize(data_.side, left), errorSize(data_.side, right);
    return inSurfaceCoordinates(data_.side, predicted, size, covered);
}

}  // namespace terratact
