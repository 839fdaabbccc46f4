#include "app/mission/estimator_worker.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/text/model_text.h"
#include "app/runtime/parallel.h"
#include "app/runtime/time_budget.h"
#include "app/runtime/vector_registers.h"
#include "core/infer/two_track_estimator.h"
#include "core/learn/model/bin_models.h"
#include "core/learn/model/file/model_file.h"
#include "core/sim/two_track_check.h"
#include "core/store/sha256.h"

namespace terratact {

ModelLoader modelFileLoader(std::string path, RobotModel robot)
{
    return [path = std::move(path), robot = std::move(robot)]() -> Result<LoadedModel> {
        auto stored = readModel(path);
        if (!stored) return stored.error();
        // Shared, because an Estimator must be copyable and models are not.
        const auto loaded = std::make_shared<Models>(stored->data, robot);
        LoadedTrail trail = trailBeside(path, robot);
        loaded->trail = std::move(trail.model);
        const std::shared_ptr<const Models> models = loaded;

        LoadedModel model;
        model.hasTwoTracks = models->sides.has_value();
        model.trail = std::move(trail.about);
        model.name = format::fileName(QString::fromStdString(path));
        model.content = QString::fromStdString(stored->contentHash);
        model.details = ModelWords::card(factsOf(path, *stored));
        if (const auto hash = sha256OfFile(path)) model.hash = QString::fromStdString(*hash);
        model.estimate = [models, robot](const EstimateRequest& request, const Watch& watch) {
            if (request.prepares) {
                makeProcesses(*models, request.settings, watch);
                return TwoTrackEstimate{};
            }
            TwoTrackEstimate estimate =
                estimateMeasured(request.measurement, request.arm, robot, *models, request.settings,
                                 watch, request.memory ? &*request.memory : nullptr);
            writePosteriorCheck(estimate, request.measurement, robot, pollOf(watch));
            return estimate;
        };
        return model;
    };
}

EstimatorWorker::EstimatorWorker(ModelLoader load) : load_(std::move(load))
{
    thread_.setObjectName(QStringLiteral("estimator"));
    moveToThread(&thread_);
    connect(&thread_, &QThread::started, this, [this] { loadModel(load_); });
    connect(this, &EstimatorWorker::loadRequested, this, &EstimatorWorker::loadModel,
            Qt::QueuedConnection);
    connect(this, &EstimatorWorker::requested, this, &EstimatorWorker::run, Qt::QueuedConnection);
    connect(this, &EstimatorWorker::adviceRequested, this, &EstimatorWorker::answer,
            Qt::QueuedConnection);
}

void EstimatorWorker::start()
{
    thread_.start();
}

EstimatorWorker::~EstimatorWorker()
{
    cancel();
    ++newestAdvice_;
    thread_.quit();
    thread_.wait();
}

int EstimatorWorker::request(const EstimateRequest& request)
{
    const int job = ++newest_;
    progress_ = 0.0;
    emit requested(job, request);
    return job;
}

void EstimatorWorker::cancel()
{
    ++newest_;
    progress_ = -1.0;
}

void EstimatorWorker::advise(int job, const TwoTrackEstimate& estimate, const RobotModel& prober,
                             double stepLimit)
{
    emit adviceRequested(++newestAdvice_, job, estimate, prober, stepLimit);
}

void EstimatorWorker::answer(int number, int job, const TwoTrackEstimate& estimate,
                             const RobotModel& prober, double stepLimit)
{
    giveAdvice(job, estimate, prober, stepLimit, [this, number] {
        if (number != newestAdvice_) throw Cancelled{};
    });
}

void EstimatorWorker::giveAdvice(int job, const TwoTrackEstimate& estimate,
                                 const RobotModel& prober, double stepLimit, const Poll& poll)
{
    try {
        emit advised(job, adviseProbe(estimate, prober, stepLimit, poll));
    } catch (const Cancelled&) {
        return;
    } catch (const std::exception&) {  // the estimate is valid without advice
        ProbeAdvice none;
        none.stepLimit = stepLimit;
        emit advised(job, none);
    }
}

std::optional<double> EstimatorWorker::progress() const
{
    const double share = progress_;
    return share < 0.0 ? std::nullopt : std::optional(share);
}

void EstimatorWorker::load(const ModelLoader& load)
{
    cancel();
    emit loadRequested(load);
}

void EstimatorWorker::loadModel(const ModelLoader& load)
{
    Message why;
    try {
        auto model = load();
        if (model) {
            estimate_ = model->estimate;
            emit modelLoaded(model->name, model->details, model->hash, model->content,
                             model->hasTwoTracks, model->trail);
            return;
        }
        why = model.error().message;
    } catch (const std::exception& error) {
        why = messageOf(error);
    }
    if (estimate_) {
        emit modelKept(why);
        return;
    }
    trouble_ = why;
    emit modelFailed(why);
}

void EstimatorWorker::run(int job, const EstimateRequest& request)
{
    if (overtaken(job)) return;
    clearUpperVectorHalves();
    const std::optional<TwoTrackEstimate> result = estimateFor(job, request);
    // Runs here, because the window's thread paints the estimate meanwhile.
    if (result && request.prober)
        giveAdvice(job, *result, *request.prober, request.stepLimit, [this, job] {
            if (overtaken(job)) throw Cancelled{};
        });
}

/// Computes a request and emits its result; returns empty if it gave no estimate.
std::optional<TwoTrackEstimate> EstimatorWorker::estimateFor(int job,
                                                             const EstimateRequest& request)
{
    Message why;
    try {
        if (!estimate_) throw Failure(trouble_);
        Watch watch = endingAfter(request.seconds);
        watch.cancelled = [this, job] { return overtaken(job); };
        watch.progress = [this, job](double share) {
            if (!overtaken(job)) progress_ = share;
        };
        lendProcessors(watch);
        QElapsedTimer timer;
        timer.start();
        TwoTrackEstimate result = estimate_(request, watch);
        const double seconds = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
        if (overtaken(job)) return std::nullopt;
        progress_ = -1.0;
        emit estimated(job, result, seconds);
        return result;
    } catch (const Cancelled&) {
        return std::nullopt;
    } catch (const std::exception& error) {
        why = messageOf(error);
    } catch (...) {
        why = TR_NOOP("core", "unknown error");
    }
    if (overtaken(job)) return std::nullopt;
    progress_ = -1.0;
    emit failed(job, why);
    return std::nullopt;
}

}  // namespace terratact
