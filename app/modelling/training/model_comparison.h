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

/// Two models to compare on the same scenes.
struct ComparisonPlan {
    RobotModel robot;
    std::string oldModel, newModel;  ///< *.ttm files
    std::string data;                ///< CSV of scenes with heights
    Settings settings;               ///< options of the estimates; scene k uses seed + k
    std::size_t mostScenes = 300;    ///< larger sets are thinned evenly
    int threads = 0;                 ///< maximum; 0: one per processor
};

/// Results of both models on the scenes that both could estimate. Errors are defined in core/eval/evaluation.h.
struct ModelComparison {
    MethodSummary before, after;  ///< of the old model, of the new model
    std::size_t scenes = 0;       ///< scenes that both could estimate
    std::size_t tried = 0;        ///< scenes picked from the file
    std::size_t inFile = 0;       ///< scenes with a known height
    std::size_t onlyBefore = 0;   ///< scenes that only the old model could estimate
    std::size_t onlyAfter = 0;
    Message whyNot;  ///< reason for the first scene that one model could not estimate
    /// 95 % interval of the difference new − old of the mean |error| near the robot [m], bootstrapped over drives.
    /// Empty for fewer than kMinRuns drives.
    std::optional<Interval> nearDifference;
    std::string newContent;      ///< contentHash() of the new model
    std::string dataHash;        ///< hash of the scene file as read
    std::size_t newTrained = 0;  ///< `scenes` that the new model was trained on, or near copies
    std::size_t oldTrained = 0;
};

/// Callbacks of a comparison; each may be empty.
struct ComparisonWatch {
    std::function<bool()> cancelled;             ///< any thread, before every scene
    std::function<void(double share)> progress;  ///< 0 … 1, one thread at a time
};

/// Returns at most `most` indices of `count` items, evenly spaced: ⌊k count / most⌋.
std::vector<std::size_t> evenlyPicked(std::size_t count, std::size_t most);

/// Estimates the picked scenes with both models. Plans that differ only in threads give the same result. Errors name
/// the file and, if known, the line. Causes are an unreadable file, no known height, or no scene that both models can
/// estimate. Throws Cancelled once watch.cancelled() returns true.
Result<ModelComparison> compareModels(const ComparisonPlan& plan,
                                      const ComparisonWatch& watch = {});

}  // namespace terratact
