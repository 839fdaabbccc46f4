#include "app/modelling/training/model_training.h"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/modelling/scene_kind.h"
#include "app/modelling/training/mix_judges.h"
#include "app/modelling/training/scene_mixing.h"
#include "app/modelling/training/training_files.h"
#include "app/modelling/training/training_run.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/training.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

/// Returns "3, 7, 12 and 4 more".
std::string someOf(const std::set<std::string>& runs)
{
    constexpr std::size_t kShown = 3;
    std::string text;
    std::size_t count = 0;
    for (const std::string& run : runs)
        if (++count <= kShown) text += (text.empty() ? "" : ", ") + run;
    if (count > kShown) text += fmt::format(" and {} more", count - kShown);
    return text;
}

/// Generated scenes of a plan, by their kind.
struct GeneratedFiles {
    std::vector<std::string> planes{}, tracks{};
};

Result<GeneratedFiles> generatedOf(const TrainingPlan& plan)
{
    GeneratedFiles files;
    for (const std::string& path : plan.generated) {
        const auto kind = sceneKindOf(path);
        if (!kind) return kind.error();
        if (kind->isPlane && !plan.plane.empty())
            return fileError(path, "holds scenes of one plane, which the model of --plane does not "
                                   "learn: give scenes of left and right, or train with --data");
        if (!kind->isPlane && plan.tracks.empty())
            return fileError(path, "holds scenes of left and right, and training has no --tracks: "
                                   "give these, or generated scenes of one plane");
        (kind->isPlane ? files.planes : files.tracks).push_back(path);
    }
    return files;
}

/// Mixes generated scenes to the real ones of `file` by held-out error. chosen: receives the mix.
template <class SceneType, class Judge>
Status addGenerated(const std::string& file, TrainingScenes<SceneType>& real,
                    const TrainingScenes<SceneType>& generated, Judge judge,
                    const std::function<void(const CardMix&)>& chosen)
{
    const auto mix = chooseMix(real.scenes, heldOutFolds(real.scenes, real.begins),
                               generated.scenes, MixJudge<SceneType>(std::move(judge)));
    if (!mix) return fileError(file, "its scenes " + mix.error().text);
    if (chosen) chosen(*mix);
    real.scenes = mixedScenes(real.scenes, generated.scenes, mix->weight);
    real.hash = sha256Hex(real.hash + generated.hash);
    return Done{};
}

/// Returns all files in one list, `first` in front.
std::vector<std::string> joined(const std::string& first, const std::vector<std::string>& more)
{
    std::vector<std::string> all{first};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Returns a function that passes notices on.
NoticeReport reportTo(const TrainingWatch& watch)
{
    return [&watch](const Message& notice) {
        if (watch.notice) watch.notice(notice);
    };
}

/// Reports the copies among the scenes of one plane or of two tracks.
template <class AnySet>
void reportCopies(const AnySet& set, const NoticeReport& report)
{
    if (set.exactCopies > 0)
        report({TR_NOOP("core", "%1 scenes are there twice: their copies were left out"),
                set.exactCopies});
    if (set.nearCopies > 0)
        report(
            {TR_NOOP("core", "%1 scenes repeat a place within the sensors' noise; training counts "
                             "each place once (runs %2)"),
             set.nearCopies, someOf(set.runsWithCopies)});
}

/// Reads the scenes of one plane, and mixes generated ones to them.
Result<TrainingScenes<Scene>> readMixedPlanes(const TrainingPlan& plan,
                                              const std::vector<std::string>& generatedFiles,
                                              const TrainingWatch& watch)
{
    auto real = readPlanes(joined(plan.data, plan.moreData), reportTo(watch));
    if (!real || generatedFiles.empty()) return real;
    const auto generated = readPlanes(generatedFiles, reportTo(watch));
    if (!generated) return generated.error();
    if (Status added =
            addGenerated(plan.data, *real, *generated, PlaneJudge(plan, watch), watch.planeMix);
        !added)
        return added.error();
    return real;
}

Result<ModelData> readTraining(const TrainingPlan& plan,
                               const std::vector<std::string>& generatedFiles,
                               const TrainingWatch& watch)
{
    const NoticeReport report = reportTo(watch);
    const auto file = readMixedPlanes(plan, generatedFiles, watch);
    if (!file) return file.error();
    TrainingSet set;
    try {
        set = prepareTraining(file->scenes, {.conditionalRows = plan.conditionalRows,
                                             .scannerSd = plan.scannerSd,
                                             .seed = plan.seed});
    } catch (const std::invalid_argument& error) {
        return fileError(plan.data, error.what());
    }
    if (set.leftOut > 0)
        report({TR_NOOP("core", "%1 scenes with unknown values left out"), set.leftOut});
    if (set.withHoles > 0)
        report({TR_NOOP("core", "%1 scenes have unknown heights: the surfaces learn their known "
                                "bins, the conditionals leave them out"),
                set.withHoles});
    reportCopies(set, report);
    if (const auto rows = set.model.scannedHeights.rows();
        rows > kManyRows && (plan.inducing == 0 || plan.inducing > kManyRows))
        report({TR_NOOP("core",
                        "%1 scenes for each conditional, whose training grows with their cube: "
                        "--inducing 1200 predicts nearly as well and trains in a fraction of "
                        "the time"),
                rows});
    set.model.seed = plan.seed;
    set.model.inducing = plan.inducing;
    set.model.command = plan.commandLine;
    set.model.dataHash = file->hash;
    return std::move(set.model);
}

/// Returns the part of one plane of plan.plane.
Result<ModelData> readPlane(const TrainingPlan& plan)
{
    auto stored = readModel(plan.plane);
    if (!stored) return stored.error();
    ModelData model = std::move(stored->data);
    model.sides = {};
    return model;
}

/// Stores the rows of both sides in the model. Throws std::invalid_argument if there are too few.
void setSides(ModelData& model, const std::vector<TwoTrackScene>& scenes,
              const TrainingWatch& watch)
{
    const NoticeReport report = reportTo(watch);
    SideTrainingSet set = prepareSides(scenes);
    if (set.leftOut > 0)
        report({TR_NOOP("core", "%1 scenes of two tracks left out: a reading or all heights "
                                "are unknown, or there are more than %2"),
                set.leftOut, kMaxSideScenes});
    if (set.withHoles > 0)
        report({TR_NOOP("core", "%1 scenes of two tracks have unknown heights: their known "
                                "bins are learnt"),
                set.withHoles});
    reportCopies(set, report);
    model.sides = std::move(set.rows);
}

/// Reads the scenes of two tracks, and mixes generated ones to them by held-out error. The model has its part of one
/// plane already.
Status addSides(const TrainingPlan& plan, const std::vector<std::string>& generatedFiles,
                const TrainingWatch& watch, ModelData& model)
{
    auto real = readTracks(joined(plan.tracks, plan.moreTracks), reportTo(watch));
    if (!real) return real.error();
    if (!generatedFiles.empty()) {
        const auto generated = readTracks(generatedFiles, reportTo(watch));
        if (!generated) return generated.error();
        if (Status added = addGenerated(plan.tracks, *real, *generated,
                                        SideJudge(model, plan, watch), watch.mix);
            !added)
            return added;
    }
    try {
        setSides(model, real->scenes, watch);
    } catch (const std::invalid_argument& error) {
        return fileError(plan.tracks, error.what());
    }
    model.sidesHash = real->hash;
    model.sidesCommand = plan.commandLine;
    return Done{};
}

}  // namespace

std::string_view stageOf(TrainingKind kind)
{
    switch (kind) {
    case TrainingKind::Paf:
    case TrainingKind::Pa: return "Gaussian process";
    case TrainingKind::SurfaceCovered:
    case TrainingKind::SurfaceOpen: return "surface";
    case TrainingKind::ClearanceCovered:
    case TrainingKind::ClearanceOpen: return "clearance";
    case TrainingKind::SideCovered:
    case TrainingKind::SideOpen: return "side";
    }
    return "";
}

Result<ModelData> trainModel(const TrainingPlan& plan, const TrainingWatch& watch)
{
    if (!plan.tracks.empty() && plan.bins)
        throw std::invalid_argument("a part of a model cannot have two tracks");
    if (!plan.generated.empty() && plan.bins)
        throw std::invalid_argument("a part of a model cannot choose how many scenes it learns");
    const auto generated = generatedOf(plan);
    if (!generated) return generated.error();
    auto model =
        plan.plane.empty() ? readTraining(plan, generated->planes, watch) : readPlane(plan);
    if (!model) return model;
    TrainingScope rest;
    // The judge of both sides needs the part of one plane.
    if (!generated->tracks.empty() && plan.plane.empty()) runTraining(*model, plan, watch);
    if (!plan.tracks.empty())
        if (Status sides = addSides(plan, generated->tracks, watch, *model); !sides)
            return sides.error();
    if (!plan.plane.empty() || !generated->tracks.empty()) rest.parts = TrainingScope::Parts::Sides;
    runTraining(*model, plan, watch, rest);
    return model;
}

}  // namespace terratact
