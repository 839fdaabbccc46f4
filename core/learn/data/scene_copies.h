#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

/// Scenes sorted for training. An exact copy adds no information and is left out. A near copy
/// measures a place again: it is a training row, but no second place. A likelihood over all rows
/// would count it as a second place. So would a residual that leaves out one row only. σ_n and the
/// bands would then shrink.
struct SceneCopies {
    std::vector<const Scene*> kept;     ///< first scene of each place, in order
    std::vector<const Scene*> repeats;  ///< near copies of a kept scene (isNearCopy), in order
    /// Left out: equal to an earlier scene, except for digits that a number format dropped.
    std::size_t exact = 0;
    std::set<std::string> runs;  ///< drives of the repeats
};

/// Removes copies. scenes: with all features, and at least one known height each.
SceneCopies withoutCopies(const std::vector<const Scene*>& scenes);

/// Scenes of two tracks, one for each place. A mirror image is a copy: both sides are training rows
/// of one set of processes.
struct TrackCopies {
    std::vector<const TwoTrackScene*> kept;  ///< first scene of each place, in order
    std::size_t exact = 0;                   ///< left out, as in SceneCopies
    std::size_t near = 0;                    ///< left out: they measure a place again
    std::set<std::string> runs;              ///< drives of the near ones
};

/// Removes copies, exact and near ones (isNearCopy, with the heights of both sides). scenes: with
/// all features, and at least one known height each.
TrackCopies withoutCopies(const std::vector<const TwoTrackScene*>& scenes);

/// What a scene repeats.
struct SceneRepeat {
    int first = 0;         ///< number of the first scene of its place; its own: it repeats none
    bool isExact = false;  ///< equal to an earlier scene, as SceneCopies::exact
    bool operator==(const SceneRepeat&) const = default;
};

/// Finds what scenes repeat that come one after another: exact copies and near ones (isNearCopy). On two
/// tracks a mirror image is a copy, too. SceneType: Scene or TwoTrackScene.
template <class SceneType>
class SceneRepeats {
public:
    SceneRepeats();
    ~SceneRepeats();
    SceneRepeats(const SceneRepeats&) = delete;
    SceneRepeats& operator=(const SceneRepeats&) = delete;

    /// Compares a scene with the first ones of all places, and remembers it. Of several places the
    /// first one counts. A scene that lacks a feature or every height repeats none. number: of the
    /// scene, larger than those before.
    SceneRepeat add(const SceneType& scene, int number);

private:
    struct Known;
    std::unique_ptr<Known> known_;
};

/// Returns the place of each row: the number of the first row that it repeats (isNearCopy), or its
/// own. Rows are compared with first rows of places only. features: U × 11, heights: U × 11,
/// unknownBins: as in ModelData. Throws std::invalid_argument if sizes disagree.
std::vector<int> placesOf(const Eigen::MatrixXd& features, const Eigen::MatrixXd& heights,
                          const std::vector<unsigned>& unknownBins = {});

/// Returns true if one pose on one ground can explain both scenes. Every feature differs by at most
/// kCopySd √2 standard deviations of its noise (core/sim/sensor_noise.h). The root mean square of
/// the height differences is at most 26 mm, over the bins that both know. Without a common bin they
/// are two places. A scanner's noise of 12 mm exceeds that once in a hundred times.
bool isNearCopy(const Scene& a, const Scene& b);
inline constexpr double kCopySd = 3.5;

/// Returns the number of scenes that are training rows or near copies of one. Scenes that lack a
/// feature do not count.
///   training row  in any number format. No feature differs by more than kRewrittenSd of its noise,
///                 which rounding to three decimals stays below. The root mean square of these
///                 differences is at most kRewrittenRms.
///   near copy     isNearCopy, and the ground shows that it is one place. Over the bins that both
///                 know, Σ ((difference of height)² + kRewrittenHeight²)
///                 < kSameGround² Σ (row's height − least-squares line of its side)².
///                 Ground that is even to 3 mm shows nothing.
/// Among thousands of rows, isNearCopy alone also holds for scenes of other places.
/// A pose pressed again is recognised only if its heights are nearly the same, too.
/// features, heights, unknownBins: as in SurfaceData.
std::size_t trainingScenes(const std::vector<Scene>& scenes, const Eigen::MatrixXd& features,
                           const Eigen::MatrixXd& heights,
                           const std::vector<unsigned>& unknownBins);

/// Returns the same of two tracks. Counted are scenes whose left side is a training row, and near copies with the
/// heights of both sides. features: U × kSideFeatures, rounded to its steps.
std::size_t trainingScenes(const std::vector<TwoTrackScene>& scenes,
                           const Eigen::MatrixXd& features, const Eigen::MatrixXd& heights,
                           const std::vector<unsigned>& unknownBins);

inline constexpr double kSameGround = 0.2;
inline constexpr double kRewrittenSd = 0.31, kRewrittenRms = 0.13;
/// Largest height difference [m] that rounding to three decimals makes.
inline constexpr double kRewrittenHeight = 0.0006;

}  // namespace terratact
