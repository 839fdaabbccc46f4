#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/learn/data/two_track_scene.h"
#include "core/learn/model/model_card.h"

namespace terratact {

/// Weights of generated scenes that are tried: the share of them that training keeps beside all real scenes.
inline constexpr std::array kMixWeights{0.0, 0.25, 0.5, 1.0};

/// Returns the real scenes, and behind them this share of the generated ones, evenly spread. weight: 0 … 1.
std::vector<TwoTrackScene> mixedScenes(const std::vector<TwoTrackScene>& real,
                                       const std::vector<TwoTrackScene>& generated, double weight);

/// Groups of real scenes that are held out in turn, so that no place is learnt and judged at once.
struct HeldOutFolds {
    std::vector<std::size_t> of;  ///< fold of each scene
    std::size_t count = 0;
    std::string
        by{};  ///< "2 files", "4 groups of 9 runs" or "4 parts of one run", for the model card
};

/// Returns the folds: one for each file if there are several, else runs in at most four groups. Several parts of one
/// run, in the order of its scenes, where there is one run only. filesBegin: first scene of each file.
HeldOutFolds heldOutFolds(const std::vector<TwoTrackScene>& real,
                          const std::vector<std::size_t>& filesBegin);

/// Returns the |errors| [m] on the scenes `judged` of a model trained on `learnt`. Empty if they
/// are too few to train one.
using MixJudge = std::function<std::vector<double>(const std::vector<TwoTrackScene>& learnt,
                                                   const std::vector<TwoTrackScene>& judged)>;

/// Returns the weight with the smallest mean |error| over all folds. A model that did not learn a fold judges it. Of
/// equal errors the larger weight counts. A weight that cannot be trained for a fold is not tried. An error states that
/// none can.
Result<CardMix> chooseMix(const std::vector<TwoTrackScene>& real, const HeldOutFolds& folds,
                          const std::vector<TwoTrackScene>& generated, const MixJudge& judge);

/// Returns lines about the choice for the terminal.
std::string mixText(const CardMix& mix);

}  // namespace terratact
