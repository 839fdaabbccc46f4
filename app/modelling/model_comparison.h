#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/eval/cluster_bootstrap.h"
#include "core/eval/evaluation.h"
#include "core/infer/estimate/settings.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Two models to be tried on the same scenes.
struct ComparisonPlan {
    RobotModel robot;
    std::string oldModel, newModel;  ///< *.ttm
    std::string data;                ///< scenes CSV with heights
    Settings settings;  ///< of the estimates; the seed of the k-th scene tried is seed + k
    std::size_t mostScenes = 300;  ///< more are thinned evenly
    int threads = 0;               ///< at most; 0: one per processor
};

/// How the two models did on the scenes that both could estimate.  Errors as in core/eval/evaluation.h.
struct ModelComparison {
    MethodSummary before, after;  ///< of the old and of the new model
    std::size_t scenes = 0;       ///< that both could estimate
    std::size_t tried = 0;        ///< picked from the file
    std::size_t inFile = 0;       ///< with a known height
    std::size_t onlyBefore = 0;   ///< that only the old model could estimate
    std::size_t onlyAfter = 0;
    std::string whyNot;  ///< of the first scene that one of them could not
    /// 95 % of the difference new − old of the mean |error| near the robot [m], by bootstrap over drives; empty
    /// for fewer than kMinRuns drives.
    std::optional<Interval> nearDifference;
    std::string newContent;       ///< contentHash() of the new model
    std::string dataHash;         ///< of the file with the scenes, as they were read
    bool newLearntThese = false;  ///< the file is the one the new model was trained on
    bool oldLearntThese = false;
};

/// How a comparison talks to whoever waits; may be empty.
struct ComparisonWatch {
    std::function<bool()> cancelled;             ///< from any thread, before every scene
    std::function<void(double share)> progress;  ///< 0 … 1, by one thread at a time
};

/// Indices of at most `most` of `count` things, evenly spread: ⌊k count / most⌋.
std::vector<std::size_t> evenlyPicked(std::size_t count, std::size_t most);

/// Estimates the picked scenes with both models.  Errors name the file, and its line where it has one: it cannot
/// be read, holds no known height, or holds no scene that both models can estimate.
/// Same plan but for threads: the same comparison.  Throws Cancelled once watch.cancelled() says so.
Result<ModelComparison> compareModels(const ComparisonPlan& plan,
                                      const ComparisonWatch& watch = {});

}  // namespace terratact
