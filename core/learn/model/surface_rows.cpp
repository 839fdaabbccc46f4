#include "core/learn/model/surface_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/learn/data/scene_copies.h"

namespace terratact {
namespace {

constexpr Eigen::Index kNonForces = 5;  // pitch, two angles and two currents come before the forces
constexpr Eigen::Index kInputsOfSide = Eigen::Index{kSideFeatures};
constexpr double kModelForceScale = 3.0;  // [N]

}  // namespace

Eigen::VectorXd surfaceFeatures(const Eigen::VectorXd& features)
{
    Eigen::VectorXd x = features;
    const Eigen::Index first =
        x.size() == kInputsOfSide ? Eigen::Index{kFirstSideForce} : kNonForces;
    for (Eigen::Index d = first; d < x.size(); ++d)
        x[d] = std::log1p(std::max(x[d], 0.0) / kModelForceScale);
    return x;
}

Eigen::VectorXd standardisedFeatures(const Eigen::VectorXd& mean, const Eigen::VectorXd& sd,
                                     const Eigen::VectorXd& features, AbsentFeatures without)
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

std::vector<int> rowsOf(const std::vector<unsigned>& coveredBins,
                        const std::vector<unsigned>& unknownBins, int bin, bool covered)
{
    std::vector<int> rows;
    for (std::size_t u = 0; u < coveredBins.size(); ++u)
        if (isCovered(coveredBins[u], bin) == covered && isKnown(unknownBins, u, bin))
            rows.push_back(static_cast<int>(u));
    return rows;
}

std::vector<int> rowsOf(const SurfaceData& model, int bin, bool covered)
{
    return rowsOf(model.clearance.coveredBins, model.unknownBins, bin, covered);
}

std::vector<int> completeRows(const SurfaceData& model)
{
    std::vector<int> rows;
    for (Eigen::Index u = 0; u < model.heights.rows(); ++u)
        if (model.unknownBins.empty() || model.unknownBins[static_cast<std::size_t>(u)] == 0)
            rows.push_back(static_cast<int>(u));
    return rows;
}

bool holdsSides(const SurfaceData& model)
{
    return model.features.cols() == kInputsOfSide;
}

std::vector<int> placesOf(const SurfaceData& model)
{
    if (model.repeats > 0) return placesOf(model.features, model.heights, model.unknownBins);
    std::vector<int> own(static_cast<std::size_t>(model.heights.rows()));
    std::iota(own.begin(), own.end(), 0);
    if (holdsSides(model))
        for (int& place : own) place = std::min(place, otherSideRow(place));
    return own;
}

std::vector<int> inducingRows(const std::vector<int>& rows)
{
    if (rows.size() <= std::size_t{kInducing}) return rows;
    std::vector<int> chosen;
    chosen.reserve(std::size_t{kInducing});
    for (std::size_t k = 0; k < std::size_t{kInducing}; ++k)
        chosen.push_back(rows[k * rows.size() / std::size_t{kInducing}]);
    return chosen;
}

}  // namespace terratact
