#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/learn/data/scene_copies.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Returns s as input of the surface processes: the features of FeatureSet::Paf or of one side
/// (side_features.h), each force F [N] as log(1 + F / 3).
Eigen::VectorXd surfaceFeatures(const Eigen::VectorXd& features);

/// Returns (surfaceFeatures − mean) / sd, and 0 for the features in `without`.
Eigen::VectorXd standardisedFeatures(const Eigen::VectorXd& mean, const Eigen::VectorXd& sd,
                                     const Eigen::VectorXd& features, AbsentFeatures without = {});

/// Returns a bit mask. Bit i is set if ceiling i is finite: the robot is above bin i.
unsigned coveredBins(const Heights& ceiling);

constexpr bool isCovered(unsigned mask, int bin)
{
    return (mask >> static_cast<unsigned>(bin) & 1U) != 0;
}

/// Returns the training rows of the bin in that regime whose height is known, in order.
/// unknownBins: as in SurfaceData.
std::vector<int> rowsOf(const std::vector<unsigned>& coveredBins,
                        const std::vector<unsigned>& unknownBins, int bin, bool covered);
std::vector<int> rowsOf(const SurfaceData& model, int bin, bool covered);

/// Returns true if the height of that bin is known in that row. unknownBins: as in SurfaceData.
inline bool isKnown(const std::vector<unsigned>& unknownBins, std::size_t row, int bin)
{
    return unknownBins.empty() || !isCovered(unknownBins[row], bin);
}

/// Returns the rows whose eleven heights are known, in order.
std::vector<int> completeRows(const SurfaceData& model);

/// Returns the place of each training row: the number of the first row that it repeats
/// (scene_copies.h), or its own. Without repeats in the model, each row has its own. Both sides of a
/// scene have one place.
std::vector<int> placesOf(const SurfaceData& model);

/// Returns the number of scenes that the model was trained on, and near copies of them
/// (scene_copies.h). SceneType: Scene for one plane, TwoTrackScene for sides.
template <class SceneType>
std::size_t trainingScenes(const std::vector<SceneType>& scenes, const SurfaceData& model)
{
    return trainingScenes(scenes, model.features, model.heights, model.unknownBins);
}

/// Returns the row of the other side of the same scene.
constexpr int otherSideRow(int row)
{
    return row ^ 1;
}

/// Returns true for rows of one side each, two per scene.
bool holdsSides(const SurfaceData& model);

/// Returns at most kInducing of the rows, evenly spread.
inline constexpr int kInducing = 600;
std::vector<int> inducingRows(const std::vector<int>& rows);

}  // namespace terratact
