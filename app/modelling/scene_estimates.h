#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/runtime/parallel.h"
#include "app/runtime/progress.h"
#include "core/base/message.h"
#include "core/infer/estimator.h"
#include "core/learn/data/scene.h"
#include "core/learn/model/file/model_file.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A robot, a model and the estimators of the methods.
struct EstimatorBundle {
    EstimatorBundle(RobotModel robotModel, StoredModel storedModel)
        : robot(std::move(robotModel)), model(std::move(storedModel)), models(model.data, robot)
    {
    }

    RobotModel robot;
    StoredModel model;
    Models models;
};
/// trailPath: networks of the method Trail (core/trail/trail_file.h); empty: none.
Result<std::unique_ptr<EstimatorBundle>> openEstimatorBundle(const std::string& robotPath,
                                                             const std::string& modelPath,
                                                             const std::string& trailPath = {});
/// Does the same for a robot that was read.
Result<std::unique_ptr<EstimatorBundle>> openEstimatorBundle(const RobotModel& robot,
                                                             const std::string& modelPath,
                                                             const std::string& trailPath);

/// Estimates one scene with the arm's readings, using the settings' method. Throws the exceptions of estimateTerrain().
/// seconds: time limit of the sampling; 0: no limit.
TerrainEstimate estimateWith(const Scene& scene, std::span<const ArmReading> arm,
                             const EstimatorBundle& bundle, const Settings& settings,
                             double seconds = 0.0);

/// An estimate of a scene, or the reason that there is none.
struct SceneEstimate {
    std::optional<TerrainEstimate> estimate{};
    std::string note{};             ///< in English: warnings, or why there is no estimate
    Message whyNone{};              ///< why there is no estimate; empty: there is one
    std::vector<ArmReading> arm{};  ///< readings of the simulated arm
};

/// Estimates one scene. Pafac simulates the arm as in the paper. If an sd exceeds the probe threshold, the bin with the
/// largest sd in reach is probed. The other bins are then sampled again. A reading is the scene's truth plus normal
/// noise with the robot file's arm sd. The scene's seed determines the noise. seconds: time limit of each sampling.
SceneEstimate estimateScene(const Scene& scene, const EstimatorBundle& bundle,
                            const Settings& settings, double seconds = 0.0);

/// Estimates all scenes on all cores. Each core runs several at a time (EstimateBatch), unless `seconds` limits them.
/// Scene k uses settings.seed + k. The results are bit-identical to estimateScene(). progress: counts the scenes.
std::vector<SceneEstimate> estimateScenes(std::span<const Scene> scenes,
                                          const EstimatorBundle& bundle, const Settings& settings,
                                          double seconds, Progress& progress);
/// Does the same and shows sceneProgress().
std::vector<SceneEstimate> estimateScenes(std::span<const Scene> scenes,
                                          const EstimatorBundle& bundle, const Settings& settings,
                                          double seconds = 0.0);
/// Returns the progress of a method over all scenes.
Progress sceneProgress(Method method, std::size_t scenes);

/// Calls work(first, part) for parts of the scenes, in order. first: number of the part's first scene. The draws of an
/// estimate need 90 kB. The estimates of a large file therefore do not fit in memory at once.
template <class AnyScene, class Work>
void forParts(const std::vector<AnyScene>& scenes, Work work)
{
    const auto most = static_cast<std::size_t>(std::max(32, 4 * processors()));
    for (std::size_t first = 0; first < scenes.size(); first += most)
        work(first, std::span(scenes).subspan(first, std::min(most, scenes.size() - first)));
}

/// Places the robot on every estimate's ground (core/sim/posterior_check.h), on all cores. An estimate that contradicts
/// its scene's readings gets a warning and a note. Returns the number of contradictions.
std::size_t checkEstimates(std::span<const Scene> scenes, const RobotModel& robot,
                           std::vector<SceneEstimate>& estimates);

}  // namespace terratact
