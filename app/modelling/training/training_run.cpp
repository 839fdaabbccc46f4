#include "app/modelling/training/training_run.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "app/runtime/parallel.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/clearance_conditionals.h"
#include "core/learn/model/clearance_model.h"
#include "core/learn/model/clearance_training.h"
#include "core/learn/model/side_training.h"
#include "core/learn/model/training.h"

namespace terratact {
namespace {

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
class TrainingRun {
public:
    TrainingRun(ModelData& model, const TrainingPlan& plan, const TrainingWatch& watch,
                const TrainingScope& scope)
        : model_(model), plan_(plan), watch_(watch), scope_(scope),
          bins_(binsOf(plan.bins.value_or(kAllBins))),
          ceilings_(bodyCeilings(model.features, plan.robot, poll_))
    {
        conditional_.seed = surface_.seed = clearance_.seed = plan.seed;
        if (plan.inducing > 0) conditional_.fullRows = kRowsOfSparseSearch;
        surface_.subset = scope.surfaceRows;
        surface_.fullEvaluations = 0;
        total_ = static_cast<double>(bins_.size()) * costOfBin();
    }

    void run()
    {
        using Parts = TrainingScope::Parts;
        if (scope_.parts == Parts::Sides) return trainSides();
        if (scope_.parts == Parts::All) trainConditionals();
        trainSurfaces(model_, ceilings_,
                      {TrainingKind::SurfaceCovered, TrainingKind::SurfaceOpen, 0});
        if (scope_.parts == Parts::All) trainClearances();
        callPoll(poll_);
        if (!plan_.bins) finishClearance(model_, ceilings_, plan_.robot, poll_);
        if (scope_.parts == Parts::All && model_.hasSides()) trainSides();
    }

private:
    /// Result of a job.
    struct Outcome {
        TrainingEvent event = TrainingEvent::Done;
        std::optional<double> logLikelihood{};
    };

    double costOfBin() const
    {
        const double sides = 2.0 * costOf(TrainingKind::SideOpen);
        const double surfaces = 2.0 * costOf(TrainingKind::SurfaceOpen);
        if (scope_.parts == TrainingScope::Parts::Sides) return sides;
        if (scope_.parts == TrainingScope::Parts::Surfaces) return surfaces;
        return costOf(TrainingKind::Paf) + costOf(TrainingKind::Pa) + surfaces
             + 2.0 * costOf(TrainingKind::ClearanceOpen) + (model_.hasSides() ? sides : 0.0);
    }

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
    const TrainingScope scope_;
    const Poll poll_ = pollOf({watch_.cancelled, {}, {}, {}});
    std::vector<int> bins_;
    Eigen::MatrixXd ceilings_;
    TrainingOptions conditional_, surface_, clearance_;
    std::mutex mutex_;
    double done_ = 0.0, total_ = 1.0;  // units of costOf()
};

}  // namespace

void runTraining(ModelData& model, const TrainingPlan& plan, const TrainingWatch& watch,
                 const TrainingScope& scope)
{
    TrainingRun(model, plan, watch, scope).run();
}

}  // namespace terratact
