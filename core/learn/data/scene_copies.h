#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/learn/data/scene.h"

namespace terratact {

/// Scenes without copies, for training. A copy adds no information, but leave-one-out residuals and
/// the likelihood would count it as a second observation: σ_n and the bands would shrink to
/// nothing.
struct SceneCopies {
    std::vector<const Scene*> kept;  ///< first scene of each kind, in order
    std::size_t exact = 0;       ///< copies whose features and heights equal those of a kept scene
    std::size_t near = 0;        ///< copies within the sensors' noise (isNearCopy)
    std::set<std::string> runs;  ///< drives of the near copies
};

/// Removes copies. scenes: complete ones.
SceneCopies withoutCopies(const std::vector<const Scene*>& scenes);

/// Returns true if one pose on one ground can explain both scenes. Every feature differs by at most
/// kCopySd √2 standard deviations of its noise (core/sim/sensor_noise.h). The root mean square of
/// the height differences is at most 26 mm. A scanner's noise of 12 mm exceeds that once in a
/// hundred times.
bool isNearCopy(const Scene& a, const Scene& b);
inline constexpr double kCopySd = 3.5;

/// Returns the number of scenes that are training rows, whatever their number format. No feature
/// differs by more than kRewrittenSd of its noise, which rounding to three decimals stays below.
/// The root mean square of these differences is at most kRewrittenRms. features: U × 11 as in
/// ModelData.
std::size_t trainingScenes(const std::vector<Scene>& scenes, const Eigen::MatrixXd& features);
inline constexpr double kRewrittenSd = 0.31, kRewrittenRms = 0.13;

}  // namespace terratact
