#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/result.h"
#include "core/learn/data/scene.h"
#include "core/learn/data/two_track_scene.h"
#include "core/learn/model/model_card.h"

namespace terratact {

// SceneType: Scene of one plane, or TwoTrackScene.

/// Weights of generated scenes that are tried: the share of them that training keeps beside all real scenes.
inline constexpr std::array kMixWeights{0.0, 0.25, 0.5, 1.0};

/// Returns the real scenes, and behind them this share of the generated ones, evenly spread. weight: 0 … 1.
template <class SceneType>
std::vector<SceneType> mixedScenes(const std::vector<SceneType>& real,
                                   const std::vector<SceneType>& generated, double weight);

/// Groups of real scenes that are held out in turn, so that no place is learnt and judged at once.
struct HeldOutFolds {
    /// Fold of each scene; `count` for an exact copy, which is neither learnt nor judged.
    std::vector<std::size_t> of;
    std::size_t count = 0;
    std::string
        by{};  ///< "2 files", "4 groups of 9 runs" or "4 parts of one run", for the model card
};

/// Returns the folds: one for each file if there are several, else runs in at most four groups. A single run is split
/// into parts, in the order of its scenes. A near copy is in the fold of the first scene of its place
/// (core/learn/data/scene_copies.h). Files and runs with near copies only do not count. filesBegin: first scene of each
/// file.
template <class SceneType>
HeldOutFolds heldOutFolds(const std::vector<SceneType>& real,
                          const std::vector<std::size_t>& filesBegin);

/// Returns the |errors| [m] on the scenes `judged` of a model trained on `learnt`. Empty: they are too few to train
/// one.
template <class SceneType>
using MixJudge = std::function<std::vector<double>(const std::vector<SceneType>& learnt,
                                                   const std::vector<SceneType>& judged)>;

/// Returns the weight with the smallest mean |error| over all folds. A model that did not learn a fold judges it. Of
/// equal errors the larger weight counts. A weight that cannot be trained for a fold is not tried. An error states that
/// none can.
template <class SceneType>
Result<CardMix> chooseMix(const std::vector<SceneType>& real, const HeldOutFolds& folds,
                          const std::vector<SceneType>& generated,
                          const std::type_identity_t<MixJudge<SceneType>>& judge);

/// Returns lines about the choice for the terminal. of: their first words, such as "one plane: ".
std::string mixText(const CardMix& mix, std::string_view of = {});

}  // namespace terratact
