#include "app/modelling/model_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/modelling/scene_mixing.h"
#include "app/modelling/two_track_evaluation.h"
#include "app/runtime/parallel.h"
#include "core/infer/estimator.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/learn/model/clearance_conditionals.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/model_file.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/training.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"

namespace terratact {

namespace {

constexpr int kRowsOfSurfaceSearch = 800;
constexpr int kRowsOfMixSearch = 300;  // of models that are only compared

/// Returns the approximate cost of a hyperparameter search over `rows` rows; every likelihood needs a factorisation.
double searchCost(Eigen::Index rows, const TrainingOptions& options)
{
    const auto cube = [rows](int most) {
        return std::pow(static_cast<double>(most > 0 ? std::min<Eigen::Index>(rows, most) : rows),
                        3.0);
    };
    const bool thinned = options.subset < rows || options.fullEvaluations == 0;
    return (thinned ? options.subsetEvaluations * cube(options.subset) : 0.0)
         + options.fullEvaluations * cube(options.fullRows);
}

/// A running training. The jobs of a stage run in parallel; the stages run one after another.
class Training {
public:
    Training(ModelData& model, const TrainingPlan& plan, const TrainingWatch& watch)
        : model_(model), plan_(plan), watch_(watch), bins_(binsOf(plan.bins.value_or(kAllBins))),
          ceilings_(bodyCeilings(model.features, plan.robot, poll_))
    {
        conditional_.seed = surface_.seed = clearance_.seed = plan.seed;
        if (plan.inducing > 0) conditional_.fullRows = kRowsOfSparseSearch;
        surface_.subset = kRowsOfSurfaceSearch;
        surface_.fullEvaluations = 0;
        if (!plan.plane.empty()) {
            total_ = static_cast<double>(bins_.size()) * 2.0 * costOf(TrainingKind::SideOpen);
            return;
        }
        total_ =
            static_cast<double>(bins_.size())
            * (costOf(TrainingKind::Paf) + costOf(TrainingKind::Pa)
               + 2.0 * costOf(TrainingKind::SurfaceOpen) + 2.0 * costOf(TrainingKind::ClearanceOpen)
               + (model.hasSides() ? 2.0 * costOf(TrainingKind::SideOpen) : 0.0));
    }

    /// Searches hyper-parameters of surfaces on at most so many rows.
    void searchSurfacesOn(int rows) { surface_.subset = rows; }

    void run()
    {
        if (!plan_.plane.empty()) return trainSides();
        trainConditionals();
        trainSurfaces(model_, ceilings_,
                      {TrainingKind::SurfaceCovered, TrainingKind::SurfaceOpen, 0});
        trainClearances();
        callPoll(poll_);
        if (!plan_.bins) finishClearance(model_, ceilings_, plan_.robot, poll_);
        if (model_.hasSides()) trainSides();
    }

private:
    /// Result of a job.
    struct Outcome {
        TrainingEvent event = TrainingEvent::Done;
        std::optional<double> logLikelihood{};
    };

    int jobs() const { return 2 * static_cast<int>(bins_.size()); }

    double costOf(TrainingKind kind) const
    {
        switch (kind) {
        case TrainingKind::Paf:
        case TrainingKind::Pa: return searchCost(model_.scannedHeights.rows(), conditional_);
        case TrainingKind::SurfaceCovered:
        case TrainingKind::SurfaceOpen: return searchCost(model_.heights.rows(), surface_);
        case TrainingKind::ClearanceCovered:
        case TrainingKind::ClearanceOpen:
            return searchCost(std::min<Eigen::Index>(model_.heights.rows(), kMaxClearanceRows),
                              clearance_);
        case TrainingKind::SideCovered:
        case TrainingKind::SideOpen: return searchCost(model_.sides.heights.rows(), surface_);
        }
        return 0.0;
    }

    void report(TrainingKind kind, int bin, const Outcome& outcome)
    {
        const std::scoped_lock lock(mutex_);
        if (outcome.event != TrainingEvent::Begun) done_ += costOf(kind);
        if (!watch_.progress) return;
        watch_.progress({.kind = kind,
                         .bin = bin,
                         .event = outcome.event,
                         .logLikelihood = outcome.logLikelihood,
                         .stageTotal = jobs(),
                         .share = std::min(1.0, done_ / total_)});
    }

    /// Runs work(job, kind, bin) for all bins, first of one kind and then of the other.
    template <class Work>
    void runStage(TrainingKind first, TrainingKind second, Work work)
    {
        const auto count = static_cast<int>(bins_.size());
        parallelFor(
            jobs(),
            [&](int job) {
                callPoll(poll_);
                const TrainingKind kind = job < count ? first : second;
                const int bin = bins_[static_cast<std::size_t>(job % count)];
                report(kind, bin, {.event = TrainingEvent::Begun});
                const Outcome outcome = work(job, kind, bin);
                report(kind, bin, outcome);
            },
            plan_.threads);
    }

    void trainConditionals()
    {
        // The larger jobs begin first.
        runStage(TrainingKind::Paf, TrainingKind::Pa, [&](int /*job*/, TrainingKind kind, int bin) {
            const FeatureSet set = kind == TrainingKind::Paf ? FeatureSet::Paf : FeatureSet::Pa;
            const TrainedBin trained = trainBin(model_, set, bin, conditional_, poll_);
            BinModelData& data = set == FeatureSet::Pa ? model_.pa : model_.paf;
            data.bins[static_cast<std::size_t>(bin)] = trained.hyper;
            data.logLikelihood[static_cast<std::size_t>(bin)] = trained.logLikelihood;
            return Outcome{.logLikelihood = trained.logLikelihood};
        });
    }

    /// Surface processes of one stage.
    struct SurfaceStage {
        TrainingKind covered, open;
        Eigen::Index kept = 0;  ///< as in trainSurface()
    };

    void trainSurfaces(SurfaceData& data, const Eigen::MatrixXd& ceilings,
                       const SurfaceStage& stage)
    {
        prepareClearance(data, ceilings);
        const std::vector<int> places = placesOf(data);
        std::vector<TrainedSurface> trained(static_cast<std::size_t>(jobs()));
        runStage(stage.covered, stage.open, [&](int job, TrainingKind kind, int bin) {
            trained[static_cast<std::size_t>(job)] = trainSurface(
                data, ceilings, bin, kind == stage.covered, surface_, poll_, places, stage.kept);
            return Outcome{};
        });
        const auto count = static_cast<int>(bins_.size());
        for (int job = 0; job < jobs(); ++job)
            store(data, trained[static_cast<std::size_t>(job)],
                  bins_[static_cast<std::size_t>(job % count)], job < count);
    }

    /// Trains the processes of both sides.
    void trainSides()
    {
        trainSurfaces(
            model_.sides, bodyCeilings(model_.sides.features, plan_.robot, poll_),
            {TrainingKind::SideCovered, TrainingKind::SideOpen, Eigen::Index{2} * kKeptScenes});
        finishSides(model_.sides, plan_.robot, poll_);
    }

    /// Trains the conditionals over clearances in every regime with enough rows.
    void trainClearances()
    {
        const ClearanceTraining training = clearanceTraining(model_, plan_.robot);
        const ClearanceConditionalData data = prepareClearanceConditionals(training);
        runStage(TrainingKind::ClearanceCovered, TrainingKind::ClearanceOpen,
                 [&](int /*job*/, TrainingKind kind, int bin) {
                     const Regime regime =
                         kind == TrainingKind::ClearanceCovered ? Regime::Covered : Regime::Open;
                     if (data.at(bin, regime).rows < kMinTrainingRows)
                         return Outcome{.event = TrainingEvent::Skipped};
                     ClearanceData& clearance = model_.clearance;
                     auto& hypers = regime == Regime::Covered ? clearance.conditionalCovered
                                                              : clearance.conditionalOpen;
                     const TrainedBin trained =
                         trainClearanceConditional(training, data, bin, regime, clearance_, poll_);
                     hypers[static_cast<std::size_t>(bin)] = trained.hyper;
                     return Outcome{.logLikelihood = trained.logLikelihood};
                 });
    }

    ModelData& model_;
    const TrainingPlan& plan_;
    const TrainingWatch& watch_;
    const Poll poll_ = pollOf({watch_.cancelled, {}, {}, {}});
    std::vector<int> bins_;
    Eigen::MatrixXd ceilings_;
    TrainingOptions conditional_, surface_, clearance_;
    std::mutex mutex_;
    double done_ = 0.0, total_ = 1.0;  // units of costOf()
};

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

/// Scenes of one or several files, and the hash of what was read.
template <class SceneType>
struct ScenesRead {
    std::vector<SceneType> scenes{};
    std::vector<Message> notices{};
    std::string hash{};  ///< SHA-256 of a file; of several, of their hashes in hexadecimal
};

Result<ScenesRead<Scene>> readScenesAndHash(const std::string& path)
{
    auto file = readScenes(path);
    if (!file) return file.error();
    return ScenesRead<Scene>{std::move(file->scenes), std::move(file->notices),
                             std::move(file->hash)};
}

Result<ScenesRead<TwoTrackScene>> readTracksAndHash(const std::string& path)
{
    auto hash = sha256OfFile(path);
    if (!hash) return hash.error();
    auto file = readTwoTrackScenes(path);
    if (!file) return file.error();
    return ScenesRead<TwoTrackScene>{std::move(file->scenes), std::move(file->notices),
                                     *std::move(hash)};
}

/// Reads scenes of all files, which may have other columns each. begins: gets the first scene of each file.
template <class Read, class Report>
auto readTogether(const std::string& first, const std::vector<std::string>& more, Read read,
                  const Report& report, std::vector<std::size_t>* begins = nullptr)
    -> decltype(read(first))
{
    auto all = read(first);
    if (!all) return all;
    if (begins) begins->assign(1, 0);
    for (const Message& notice : all->notices) report(notice);
    for (const std::string& path : more) {
        auto next = read(path);
        if (!next) return next;
        for (const Message& notice : next->notices) report(notice);
        if (begins) begins->push_back(all->scenes.size());
        all->scenes.insert(all->scenes.end(), next->scenes.begin(), next->scenes.end());
        all->hash += next->hash;
    }
    if (!more.empty()) all->hash = sha256Hex(all->hash);
    return all;
}

Result<ModelData> readTraining(const TrainingPlan& plan, const TrainingWatch& watch)
{
    const auto report = [&](const Message& notice) {
        if (watch.notice) watch.notice(notice);
    };
    const auto file = readTogether(plan.data, plan.moreData, readScenesAndHash, report);
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
    if (set.exactCopies > 0)
        report({TR_NOOP("core", "%1 scenes are there twice: their copies were left out"),
                set.exactCopies});
    if (set.nearCopies > 0)
        report(
            {TR_NOOP("core", "%1 scenes repeat a place within the sensors' noise; training counts "
                             "each place once (runs %2)"),
             set.nearCopies, someOf(set.runsWithCopies)});
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
    const auto report = [&](const Message& notice) {
        if (watch.notice) watch.notice(notice);
    };
    SideTrainingSet set = prepareSides(scenes);
    if (set.leftOut > 0)
        report({TR_NOOP("core", "%1 scenes of two tracks left out: a reading or all heights "
                                "are unknown, or there are more than %2"),
                set.leftOut, kMaxSideScenes});
    if (set.withHoles > 0)
        report({TR_NOOP("core", "%1 scenes of two tracks have unknown heights: their known "
                                "bins are learnt"),
                set.withHoles});
    model.sides = std::move(set.rows);
}

/// Judges mixes by models of two tracks: method local, bins −0.3 … 0.5 m of both sides.
class SideJudge {
public:
    SideJudge(const ModelData& plane, const TrainingPlan& plan, const TrainingWatch& watch)
        : plan_(plan), model_(plane)
    {
        plan_.plane = "kept";
        watch_.cancelled = watch.cancelled;
    }

    std::vector<double> operator()(const std::vector<TwoTrackScene>& learnt,
                                   const std::vector<TwoTrackScene>& judged)
    {
        try {
            setSides(model_, learnt, watch_);
        } catch (const std::invalid_argument&) {
            return {};
        }
        Training training(model_, plan_, watch_);
        training.searchSurfacesOn(kRowsOfMixSearch);
        training.run();
        Settings settings;
        settings.method = Method::Local;
        settings.seed = plan_.seed;
        return sideErrors(judged, plan_.robot, Models(model_, plan_.robot), settings);
    }

private:
    TrainingPlan plan_;
    TrainingWatch watch_;
    ModelData model_;
};

/// Reads the scenes of two tracks, and mixes generated ones to them by held-out error. The model has its part of one
/// plane already.
Status addSides(const TrainingPlan& plan, const TrainingWatch& watch, ModelData& model)
{
    const auto report = [&](const Message& notice) {
        if (watch.notice) watch.notice(notice);
    };
    std::vector<std::size_t> begins;
    auto real = readTogether(plan.tracks, plan.moreTracks, readTracksAndHash, report, &begins);
    if (!real) return real.error();
    if (!plan.generated.empty()) {
        const auto generated =
            readTogether(plan.generated.front(), {plan.generated.begin() + 1, plan.generated.end()},
                         readTracksAndHash, report);
        if (!generated) return generated.error();
        SideJudge judge(model, plan, watch);
        const auto mix = chooseMix(real->scenes, heldOutFolds(real->scenes, begins),
                                   generated->scenes, std::ref(judge));
        if (!mix) return fileError(plan.tracks, "its scenes " + mix.error().text);
        if (watch.mix) watch.mix(*mix);
        real->scenes = mixedScenes(real->scenes, generated->scenes, mix->weight);
        real->hash = sha256Hex(real->hash + generated->hash);
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
    auto model = plan.plane.empty() ? readTraining(plan, watch) : readPlane(plan);
    if (!model) return model;
    if (!plan.tracks.empty() && plan.bins)
        throw std::invalid_argument("a part of a model cannot have two tracks");
    const bool choosesMix = !plan.tracks.empty() && !plan.generated.empty();
    if (choosesMix && plan.plane.empty()) Training(*model, plan, watch).run();
    if (!plan.tracks.empty())
        if (Status sides = addSides(plan, watch, *model); !sides) return sides.error();
    TrainingPlan rest = plan;
    if (choosesMix) rest.plane = "kept";
    Training(*model, rest, watch).run();
    return model;
}

}  // namespace terratact
