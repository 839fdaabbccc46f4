#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/learn/data/scene.h"

namespace terratact {

/// Scenes that training takes once.  A copy tells nothing new, but residuals that leave out one row at a time, and the
/// likelihood, would take it for a second witness: σ_n and the bands would shrink to nothing.
struct SceneCopies {
    std::vector<const Scene*> kept;  ///< the first of each, in order
    std::size_t exact = 0;           ///< left out: features and heights are those of a kept scene
    std::size_t near = 0;            ///< left out: the same within the sensors' noise (isNearCopy)
    std::set<std::string> runs;      ///< that the near ones are of
};

/// scenes: complete ones.
SceneCopies withoutCopies(const std::vector<const Scene*>& scenes);

/// Whether one pose on one ground explains both: every feature differs by at most kCopySd √2 standard deviations of its
/// noise (core/sim/sensor_noise.h), and the root mean square of the heights' differences is at most 26 mm, which a
/// scanner's noise of 12 mm exceeds once in a hundred times.
bool isNearCopy(const Scene& a, const Scene& b);
inline constexpr double kCopySd = 3.5;

/// How many scenes are training rows, whatever number format they went through: no feature differs by more than
/// kRewrittenSd of its noise, which three decimals do, and their root mean square by at most kRewrittenRms.
/// features: U × 11 as in ModelData.
std::size_t trainingScenes(const std::vector<Scene>& scenes, const Eigen::MatrixXd& features);
inline constexpr double kRewrittenSd = 0.31, kRewrittenRms = 0.13;

}  // namespace terratact
