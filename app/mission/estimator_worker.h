#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/mission/trail_networks.h"
#include "core/atem/probe/arm_choice.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/sampling/watch.h"
#include "core/infer/verdict/obstacle.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/trail/trail_history.h"

namespace terratact {

/// A captured scene and the settings of its estimate.
struct EstimateRequest {
    Measurement measurement;
    std::vector<ArmReading> arm;
    Settings settings;
    /// Robot whose arm may probe: advised() follows; empty: no advice.
    std::optional<RobotModel> prober{};
    double stepLimit = kStepLimit;  ///< [m] obstacle height for the advice
    double seconds = 0.0;           ///< time limit of the sampling; 0: no limit
    /// Only prepares the Gaussian processes of a sampling method; the estimate is empty.
    bool prepares = false;
    /// Memory of the way before the scene, for the method Trail.
    std::optional<TrailHistory> memory{};
};

/// Computes an estimate; throws the exceptions of estimateMeasured().
using Estimator = std::function<TwoTrackEstimate(const EstimateRequest&, const Watch&)>;

/// An estimator with texts about its model.
struct LoadedModel {
    Estimator estimate;
    QString name;               ///< "default.ttm"
    QString details;            ///< its card as text
    QString hash{};             ///< SHA-256 of its file
    QString content{};          ///< StoredModel::contentHash
    bool hasTwoTracks = false;  ///< it can estimate both sides
    TrailInUse trail{};         ///< its networks for the method trail
};
using ModelLoader = std::function<Result<LoadedModel>()>;

/// Returns a loader of a model file and of the networks beside it (trailBeside()). The Gaussian processes of sampling
/// methods are factorised on first use.
ModelLoader modelFileLoader(std::string path, RobotModel robot);

/// Loads the model and estimates in its own thread. The newest request replaces and cancels the running one. Every
/// request ends in exactly one of estimated or failed; replaced or cancelled requests emit nothing. request(),
/// cancel(), load() and progress() may be called from any thread.
class EstimatorWorker final : public QObject {
    Q_OBJECT
public:
    explicit EstimatorWorker(ModelLoader load);
    ~EstimatorWorker() override;

    void start();  ///< loads the model; call once, after connecting the signals
    /// Loads another model for the following requests and cancels the running one, which the caller must repeat. Ends
    /// in modelLoaded; if loading fails, in modelKept or modelFailed.
    void load(const ModelLoader& load);

    int request(const EstimateRequest& request);  ///< returns the job's number
    void cancel();
    /// Recomputes the probe advice for that job's estimate after the pending requests. It cancels no request. It ends
    /// in advised(), unless advise() is called again before that.
    void advise(int job, const TwoTrackEstimate& estimate, const RobotModel& prober,
                double stepLimit);
    /// Returns 0 … 1 for the running job; empty: none. Clients poll it; there is no signal.
    std::optional<double> progress() const;

signals:
    void requested(int job, const terratact::EstimateRequest& request);  ///< to the worker's thread
    void loadRequested(const terratact::ModelLoader& load);              ///< to the worker's thread
    void adviceRequested(int number, int job, const terratact::TwoTrackEstimate& estimate,
                         const terratact::RobotModel& prober,
                         double stepLimit);  ///< to the worker's thread
    void modelLoaded(const QString& name, const QString& details, const QString& hash,
                     const QString& content, bool hasTwoTracks, const terratact::TrailInUse& trail);
    void modelFailed(const terratact::Message& why);  ///< there is no model
    void modelKept(const terratact::Message& why);    ///< the previous model stays
    /// seconds: computation time. Estimation::accept() keeps it; MainWindow::poll() then shows it.
    void estimated(int job, const terratact::TwoTrackEstimate& estimate, double seconds);
    void failed(int job, const terratact::Message& why);
    /// Probe advice for that job's estimate, with its expected gain. Not emitted if a newer request, cancel() or load()
    /// came after the estimate.
    void advised(int job, const terratact::ProbeAdvice& advice);

private:
    void loadModel(const ModelLoader& load);
    void run(int job, const EstimateRequest& request);
    std::optional<TwoTrackEstimate> estimateFor(int job, const EstimateRequest& request);
    void answer(int number, int job, const TwoTrackEstimate& estimate, const RobotModel& prober,
                double stepLimit);
    void giveAdvice(int job, const TwoTrackEstimate& estimate, const RobotModel& prober,
                    double stepLimit, const Poll& poll);
    bool overtaken(int job) const { return job != newest_; }

    ModelLoader load_;
    Estimator estimate_;  // used in the worker's thread only
    Message trouble_;     // why there is no model; used in the worker's thread only
    std::atomic<int> newest_ = 0, newestAdvice_ = 0;
    std::atomic<double> progress_ = -1.0;
    QThread thread_;
};

}  // namespace terratact
