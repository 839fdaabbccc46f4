#include "app/scene_estimates.h"

#include <fmt/format.h>

#include <memory>

#include "app/parallel.h"
#include "app/progress.h"
#include "app/time_budget.h"
#include "core/atem/arm_choice.h"

namespace terratact {

namespace {

std::string joined(const std::vector<std::string>& warnings)
{
    return fmt::format("{}", fmt::join(warnings, "; "));
}

SceneEstimate withArm(const Scene& scene, const Toolbox& toolbox, const Settings& settings,
                      double seconds, TerrainEstimate first)
{
    const std::optional<int> bin = proposeProbe(first, toolbox.robot);
    if (!bin) return {first, joined(first.warnings)};
    const auto truth = scene.truth[static_cast<std::size_t>(*bin)];
    if (!truth) {
        first.warnings.push_back(fmt::format(
            "arm not simulated: the truth of bin {:+.1f} m is unknown", binCentre(*bin)));
        return {first, joined(first.warnings)};
    }
    const ArmReading reading{*bin, *truth, toolbox.robot.armSd};
    const TerrainEstimate second = estimateWith(scene, {&reading, 1}, toolbox, settings, seconds);
    return {second, joined(second.warnings)};
}

}  // namespace

Result<std::unique_ptr<Toolbox>> openToolbox(const std::string& robotPath,
                                             const std::string& modelPath)
{
    auto robot = readRobotModel(robotPath);
    if (!robot) return robot.error();
    auto model = readModel(modelPath);
    if (!model) return model.error();
    return std::make_unique<Toolbox>(std::move(*robot), std::move(*model));
}

TerrainEstimate estimateWith(const Scene& scene, std::span<const ArmReading> arm,
                             const Toolbox& toolbox, const Settings& settings, double seconds)
{
    return estimateTerrain(scene.s, arm, toolbox.robot, toolbox.models, settings,
                           endingAfter(seconds));
}

SceneEstimate estimateScene(const Scene& scene, const Toolbox& toolbox, const Settings& settings,
                            double seconds)
{
    const FeatureSet set = toolbox.models.featuresOf(settings.method);
    if (const std::string_view missing = missingFeature(set, scene.s); !missing.empty())
        return {std::nullopt, fmt::format("{} is unknown, and method {} needs it", missing,
                                          name(settings.method))};
    try {
        TerrainEstimate first = estimateWith(scene, {}, toolbox, settings, seconds);
        if (!usesArm(settings.method)) return {first, joined(first.warnings)};
        return withArm(scene, toolbox, settings, seconds, std::move(first));
    } catch (const NotLearnt& error) {
        return {std::nullopt, error.what()};
    }
}

std::vector<SceneEstimate> estimateScenes(const std::vector<Scene>& scenes, const Toolbox& toolbox,
                                          const Settings& settings, double seconds)
{
    std::vector<SceneEstimate> estimates(scenes.size());
    Progress progress(fmt::format("{}: scene", name(settings.method)),
                      static_cast<int>(scenes.size()));
    parallelFor(static_cast<int>(scenes.size()), [&](int k) {
        Settings own = settings;
        own.seed += static_cast<std::uint64_t>(k);
        estimates[static_cast<std::size_t>(k)] =
            estimateScene(scenes[static_cast<std::size_t>(k)], toolbox, own, seconds);
        progress.tick();
    });
    return estimates;
}

}  // namespace terratact
