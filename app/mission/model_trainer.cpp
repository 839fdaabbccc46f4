#include "app/mission/model_trainer.h"

#include <sys/resource.h>

#include <QFileInfo>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/modelling/evaluation/model_cards.h"
#include "app/runtime/parallel.h"
#include "app/runtime/steady_now.h"
#include "app/runtime/vector_registers.h"
#include "core/infer/sampling/watch.h"
#include "core/learn/model/file/model_file.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"

namespace terratact {
namespace {

constexpr double kPaceFrom = 0.02;  // share of the work below which the pace is unknown

TrainingProgress::State stateAfter(TrainingEvent event)
{
    switch (event) {
    case TrainingEvent::Begun: return TrainingProgress::State::Running;
    case TrainingEvent::Done: return TrainingProgress::State::Done;
    case TrainingEvent::Skipped: return TrainingProgress::State::Skipped;
    }
    return TrainingProgress::State::Waiting;
}

Status nothingAt(const std::string& path)
{
    if (!QFileInfo::exists(QString::fromStdString(path))) return Done{};
    return fileError(path, "exists already; choose another name");
}

Status trainInto(const std::string& path, const TrainingPlan& plan, const TrainingWatch& watch,
                 int& scenes)
{
    if (Status nothing = nothingAt(path); !nothing) return nothing;
    const auto model = trainModel(plan, watch);
    if (!model) return model.error();
    if (watch.cancelled()) throw Cancelled{};
    if (Status nothing = nothingAt(path); !nothing) return nothing;
    const QString directory = QFileInfo(QString::fromStdString(path)).path();
    if (Status made = makeDirectory(directory.toStdString(), Access::Owner); !made) return made;
    scenes = static_cast<int>(model->heights.rows());
    if (Status written = writeModel(path, *model); !written) return written;
    return writeNewCard(path, *model, plan.data);
}

/// Writes the new model's errors into its card.
Status keepInCard(const ComparisonPlan& plan, const ModelComparison& comparison)
{
    const ErrorStatistics& all = comparison.after.all;
    return keepScores(plan.newModel, comparison.newContent, plan.data, comparison.dataHash,
                      {{.method = std::string(name(plan.settings.method)),
                        .date = {},
                        .data = {},
                        .dataHash = {},
                        .scenes = comparison.scenes,
                        .trainingScenes = comparison.newTrained,
                        .meanError = all.mean,
                        .coverage = all.coverage}});
}

}  // namespace

TrainingLoad politeLoad()
{
    return {.threads = std::max(1, processors() - 1), .nice = 19};
}

std::optional<double> TrainingProgress::secondsLeft() const
{
    if (share < kPaceFrom) return std::nullopt;
    return seconds * (1.0 - share) / share;
}

ModelTrainer::ModelTrainer(TrainingLoad load, QObject* parent) : QObject(parent), load_(load)
{
    thread_.setObjectName(QStringLiteral("trainer"));
    there_.moveToThread(&thread_);
    // Linux keeps a nice value per thread, and new threads inherit it.
    connect(
        &thread_, &QThread::started, &there_,
        [nice = load_.nice] {
            setpriority(PRIO_PROCESS, 0, std::max(nice, getpriority(PRIO_PROCESS, 0)));
            clearUpperVectorHalves();
        },
        Qt::DirectConnection);
    thread_.start();
}

ModelTrainer::~ModelTrainer()
{
    cancel();
    thread_.quit();
    thread_.wait();
}

void ModelTrainer::cancel()
{
    cancelled_ = true;
}

TrainingProgress ModelTrainer::progress() const
{
    // Never blocks, because the thread with the lock may have the lowest priority.
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) {
        seen_ = progress_;
        seen_.seconds = steadyNow() - began_;
    }
    return seen_;
}

void ModelTrainer::train(TrainingPlan plan, const QString& path)
{
    plan.threads = load_.threads;
    {
        const std::scoped_lock lock(mutex_);
        progress_ = {};
    }
    begin([this, plan = std::move(plan), path] { doTrain(plan, path); });
}

void ModelTrainer::compare(ComparisonPlan plan)
{
    plan.threads = load_.threads;
    begin([this, plan = std::move(plan)] { doCompare(plan); });
}

void ModelTrainer::begin(std::function<void()> work)
{
    busy_ = true;
    cancelled_ = false;
    {
        const std::scoped_lock lock(mutex_);
        progress_.share = 0.0;
        began_ = steadyNow();
    }
    QMetaObject::invokeMethod(
        &there_,
        [this, work = std::move(work)] {
            try {
                work();
            } catch (const Cancelled&) {
                end([this] { emit cancelled(); });
            } catch (const std::exception& error) {
                end([this, why = QString::fromUtf8(error.what())] { emit failed(why); });
            }
        },
        Qt::QueuedConnection);
}

void ModelTrainer::end(std::function<void()> report)
{
    QMetaObject::invokeMethod(
        this,
        [this, report = std::move(report)] {
            busy_ = false;
            report();
        },
        Qt::QueuedConnection);
}

void ModelTrainer::doTrain(const TrainingPlan& plan, const QString& path)
{
    TrainingWatch watch;
    watch.cancelled = [this] { return cancelled_.load(); };
    watch.progress = [this](const TrainingStep& step) {
        const std::scoped_lock lock(mutex_);
        progress_.share = step.share;
        progress_.cells[static_cast<std::size_t>(step.bin)][static_cast<std::size_t>(step.kind)] = {
            stateAfter(step.event), step.logLikelihood};
    };
    watch.notice = [this](const Message& notice) { emit noticed(translated(notice)); };
    int scenes = 0;
    const Status written = trainInto(path.toStdString(), plan, watch, scenes);
    if (!written) {
        end([this, why = translated(written.error().message)] { emit failed(why); });
        return;
    }
    end([this, path, scenes] { emit trained(path, scenes); });
}

void ModelTrainer::doCompare(const ComparisonPlan& plan)
{
    ComparisonWatch watch;
    watch.cancelled = [this] { return cancelled_.load(); };
    watch.progress = [this](double share) {
        const std::scoped_lock lock(mutex_);
        progress_.share = share;
    };
    const auto comparison = compareModels(plan, watch);
    if (!comparison) {
        end([this, why = translated(comparison.error().message)] { emit failed(why); });
        return;
    }
    if (const Status kept = keepInCard(plan, *comparison); !kept)
        emit noticed(translated(kept.error().message));
    end([this, comparison = *comparison] { emit compared(comparison); });
}

}  // namespace terratact
