#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/modelling/evaluation/model_cards.h"
#include "app/modelling/findings.h"
#include "app/modelling/scene_estimates.h"
#include "core/base/result.h"
#include "core/eval/groups.h"
#include "core/infer/estimate/settings.h"
#include "core/learn/data/scene_file.h"

namespace terratact {

/// Files, methods and settings of an evaluation.
struct EvaluateOptions {
    std::string robot, model, data, out;
    std::vector<Method> methods;
    Settings settings;
    double seconds = 0.0;               ///< time limit of each sampling; 0: no limit
    double stepLimit = 0.10;            ///< [m] obstacle height (hasStep())
    std::string classes;                ///< index file; empty: no table by class
    std::string classColumn = "class";  ///< column in the index file
    bool probes = false;                ///< also simulates probes with three rules
    bool missing = false;               ///< evaluates missing sensors instead
    bool tracks = false;                ///< evaluates scenes of two tracks (two_track_evaluation.h)
    std::optional<Shard> shard;         ///< writes only the findings of this part
    std::string drives;                 ///< file of drives to evaluate instead of scenes
    std::string trail;                  ///< networks of the method trail
    bool card = false;                  ///< also writes the scores into the model's card
    std::string command;                ///< command line without --shard and --out
};

/// Contents of the files that an evaluation reads.
struct EvaluationInput {
    std::unique_ptr<EstimatorBundle> bundle;
    std::optional<Classes> classes;  ///< empty if no index file was given
    SceneFile file;                  ///< scenes with a known height
    std::size_t trained = 0;         ///< number of scenes that are training scenes or near copies
};
Result<EvaluationInput> readEvaluationInput(const EvaluateOptions& options);

/// Evaluates the methods and then the baselines on the scenes of options.shard, on all cores. ended: called after each
/// run. The origin is set only for a part. Errors: too few scenes for the parts, or a file that cannot be hashed.
/// Without parts also: no scene that any method can estimate.
Result<Findings> evaluateScenes(const EvaluationInput& input, const EvaluateOptions& options,
                                const std::function<void(const MethodRun&)>& ended);

/// Returns the scores of the methods, without baselines, for the model's card. trained: see EvaluationInput.
std::vector<CardScores> cardScores(const Findings& findings, std::size_t trained);

}  // namespace terratact
