#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/atem/arm_choice.h"
#include "core/base/result.h"
#include "core/infer/estimate/estimate.h"
#include "core/infer/sampling/watch.h"
#include "core/infer/verdict/obstacle.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// A captured scene and how to estimate it.
struct EstimateRequest {
    Measurement measurement;
    std::vector<ArmReading> arm;
    Settings settings;
    std::optional<RobotModel>
        prober{};  ///< whose arm might probe: advised() follows; empty: it does not
    double stepLimit = kStepLimit;  ///< [m] of the question what a probe would tell
    double seconds = 0.0;           ///< after which sampling ends with what there is; 0: no limit
    /// Only what a sampling method will need of the model is made, whatever the scene; the estimate is empty.
    bool prepares = false;
};

/// Computes an estimate; throws what reconstruct() throws.
using Estimator = std::function<TerrainEstimate(const EstimateRequest&, const Watch&)>;

/// An estimator with its model's name as the operator reads it.
struct LoadedModel {
    Estimator estimate;
    QString name;       ///< "default.ttm"
    QString details;    ///< its card, in words
    QString hash{};     ///< SHA-256 of its file
    QString content{};  ///< StoredModel::contentHash
};
using ModelLoader = std::function<Result<LoadedModel>()>;

/// Reads a model file.  A Gaussian process of the sampling methods is factorised when it is first needed.
ModelLoader modelFileLoader(std::string path, RobotModel robot);

/// Estimates in its own thread, where it also loads the model first.  The newest request wins: it
/// cancels the one in flight.  Every request ends in exactly one of estimated, failed or, when a newer
/// one, cancel() or load() overtook it, nothing.  request(), cancel(), load() and progress() may be called from
/// any thread.
class EstimatorWorker final : public QObject {
    Q_OBJECT
public:
    explicit EstimatorWorker(ModelLoader load);
    ~EstimatorWorker() override;

    void start();  ///< loads the model; call once, when everybody listens
    /// Another model for the requests that follow; cancels the one in flight, which is to be made again.  Ends in
    /// modelLoaded or, where it cannot be loaded, in modelKept or modelFailed.
    void load(const ModelLoader& load);

    int request(const EstimateRequest& request);  ///< the job's number
    void cancel();
    /// Asks anew what `prober` should touch in the estimate of that job, once the requests before it are done;
    /// cancels no request, and ends in advised() unless it is asked once more before that.
    void advise(int job, const TerrainEstimate& estimate, const RobotModel& prober,
                double stepLimit);
    /// 0 … 1 of the job in flight; empty when there is none.  To be looked at, not to be signalled.
    std::optional<double> progress() const;

signals:
    void requested(int job, const terratact::EstimateRequest& request);  ///< to its own thread
    void loadRequested(const terratact::ModelLoader& load);              ///< likewise
    void adviceRequested(int number, int job, const terratact::TerrainEstimate& estimate,
                         const terratact::RobotModel& prober, double stepLimit);  ///< likewise
    void modelLoaded(const QString& name, const QString& details, const QString& hash,
                     const QString& content);
    void modelFailed(const QString& why);  ///< there is none
    void modelKept(const QString& why);    ///< the one before stays
    /// seconds: it took.
    void estimated(int job, const terratact::TerrainEstimate& estimate, double seconds);
    void failed(int job, const QString& why);
    /// What the prober of a request, or of advise(), should touch in that job's estimate, and what that buys; does not
    /// come where a newer request, cancel() or load() overtook a request after its estimate.
    void advised(int job, const terratact::ProbeAdvice& advice);

private:
    void take(const ModelLoader& load);
    void run(int job, const EstimateRequest& request);
    std::optional<TerrainEstimate> estimateFor(int job, const EstimateRequest& request);
    void answer(int number, int job, const TerrainEstimate& estimate, const RobotModel& prober,
                double stepLimit);
    void giveAdvice(int job, const TerrainEstimate& estimate, const RobotModel& prober,
                    double stepLimit, const Poll& poll);
    bool overtaken(int job) const { return job != newest_; }

    ModelLoader load_;
    Estimator estimate_;  // used in the worker's thread only
    QString trouble_;     // why there is no model; likewise
    std::atomic<int> newest_ = 0, newestAdvice_ = 0;
    std::atomic<double> progress_ = -1.0;
    QThread thread_;
};

}  // namespace terratact
