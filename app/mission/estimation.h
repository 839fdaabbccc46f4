#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "app/link/acquisition.h"
#include "app/mission/estimator_worker.h"
#include "core/atem/pose_watch.h"
#include "core/eval/calibration_ledger.h"
#include "core/infer/verdict/ghost_track.h"
#include "core/infer/verdict/verdict.h"
#include "core/robot/robot_model.h"
#include "widgets/signals/event_list.h"

namespace terratact {

/// The scene an estimate rests on.
struct CapturedScene {
    Measurement measurement;
    std::optional<Heights> truth;
};

/// The model that the estimator works with, in words.
struct ModelInUse {
    QString name{}, details{};  ///< empty: none was loaded yet
    QString content{};          ///< LoadedModel::content
    QString trouble{};          ///< why there is none
};

/// What is estimated of the terrain: of the scene captured last and what the arm has measured there, by the method of
/// the settings and by a second one beside it; before, of the flippers' way down, a preview; afterwards, where
/// the last estimate lies now that the robot has moved on.  It is told what to estimate, lets the worker do it, and
/// does not take an answer that something newer has overtaken.  GUI thread only.
class Estimation final : public QObject {
    Q_OBJECT
public:
    struct Options {
        Settings settings;
        double stepLimit = kStepLimit;  ///< [m] what counts as an obstacle
        double seconds = 0.0;           ///< EstimateRequest::seconds
    };

    /// options: as they are whenever something is asked of them.  All three must outlive it.
    Estimation(EstimatorWorker& worker, const RobotModel& robot, const Options& options);

    // What to estimate.
    /// The newest telemetry and whether it is fresh, every tick, before all else.
    void poll(const std::optional<Received>& latest, bool heard);
    /// What an exploration will need of the model, made while nothing else is under way.
    void prepare();
    /// A preview by the local method, as often as the estimator keeps up with the telemetry; stays until one fails, an
    /// estimate stands, or endPreview().
    void preview(const Received& latest);
    void endPreview() { live_.reset(); }
    /// Captures a scene and estimates it: the first line of the press, so that everybody who sees it captures the
    /// same; where that did not come after line `since`, the newest line.
    void begin(const Received& latest, std::uint64_t since);
    /// What the arm has measured in the scene of the estimate that stands: scores that, and estimates again.
    void take(const ArmReading& reading);
    void setSecondMethod(std::optional<Method> method);  ///< empty: none
    void cancel();                                       ///< all that is under way
    void adviseAnew();  ///< for the limit of now, where it is another
    /// The scene, its readings and estimates, and an answer that is still to come; not the ghost, nor a preview.
    void forget(const QString& why);
    void forgetGhost() { track_.reset(); }
    /// forget() and forgetGhost(), which restore() takes back as long as the robot has not left the place, another scene
    /// was not captured and the model is the same.
    void setAside(const QString& why);
    bool isAside() const { return aside_ && !aside_->pose.hasLeft(); }
    bool restore();  ///< false: nothing is aside

    // What there is.
    const std::optional<CapturedScene>& scene() const { return scene_; }
    bool hasMoved() const { return pose_ && pose_->hasMoved(); }  ///< the robot, since scene()
    bool hasLeft() const { return pose_ && pose_->hasLeft(); }    ///< the place of scene()
    /// For so long, since scene(), that the robot may have moved all the same: only another scene tells.
    bool wasUnheard() const { return wasUnheard_; }
    /// A sensor was suspected while the robot stood at scene().
    bool wasSuspected() const { return wasSuspected_; }
    const Settings& wanted() const { return options_.settings; }           ///< of the next estimate
    const std::vector<ArmReading>& readings() const { return readings_; }  ///< in scene()
    const std::optional<TerrainEstimate>& estimate() const { return estimate_; }
    double seconds() const { return seconds_; }  ///< that estimate() took
    /// Why there was no estimate() when that was last asked for; empty: no reason of a scene's.
    QString whyNone() const { return whyNone_; }
    const ProbeAdvice& advice() const { return advice_; }  ///< of estimate()
    /// What estimate() says about driving on, for the limit of now; empty without an estimate.
    std::optional<Verdict> verdict() const;
    std::optional<Method> secondMethod() const { return secondMethod_; }
    const std::optional<TerrainEstimate>& second() const { return second_; }
    const std::optional<TerrainEstimate>& live() const { return live_; }  ///< the preview
    /// Where the last estimate lies now, until there is a new one; it decides nothing.
    std::optional<Ghost> ghost() const;
    QString whyNoGhost() const;  ///< of the last estimate; empty: there is, or was none
    /// Every probe beside the band shown before it, since the console started.
    const CalibrationLedger& ledger() const { return ledger_; }
    const ModelInUse& model() const { return model_; }

signals:
    void happened(const QString& text, terratact::Weight weight);
    void modelChanged();  ///< an estimate that stands rests on the one before
    void captured(const terratact::CapturedScene& scene);
    void stands(bool second);  ///< an estimate, of the second method or not, as soon as it does
    void offered();            ///< advice() of estimate() for the limit of now, for the first time
    void failed();             ///< the estimate of scene()
    void advised();            ///< anew, for another limit
    void unheard();            ///< wasUnheard() has become true, or the ghost has ended for that
    void forgotten(const QString& why);  ///< the estimate that stood

private:
    /// What a sampling method's processes depend on besides the model.
    struct Processes {
        Method method;
        int inducing;
        Precision precision;
        bool operator==(const Processes&) const = default;
    };

    /// An estimate that the operator has taken off the screen.
    struct Aside {
        CapturedScene scene;
        PoseWatch pose;
        std::uint64_t capturedAt;
        bool wasUnheard;
        std::vector<ArmReading> readings;
        TerrainEstimate estimate;
        std::optional<TerrainEstimate> second;
        std::optional<GhostTrack> track;
    };

    void listenToModels();
    void takeAdvice(int job, const ProbeAdvice& advice);
    void offer();
    void accept(int job, const TerrainEstimate& estimate, double seconds);
    void refuse(int job, const QString& why);
    /// Has the worker make the processes of a sampling method, so that nobody waits for them once the flippers rest.
    /// False where it has done so, or the method needs none.
    bool warmUp(Method method);
    Processes processesOf(Method method) const;
    void endWarmUp();  ///< something overtakes it
    void start();
    void startSecond();
    void resume();  ///< what the worker has given up to load a model
    EstimateRequest requestFor(Method method) const;
    void tellOf(const TerrainEstimate& estimate);
    bool wantsGhost() const { return track_ && !estimate_ && !live_; }

    EstimatorWorker& worker_;
    const RobotModel& robot_;
    const Options& options_;
    ModelInUse model_;
    bool heard_ = false;

    std::optional<CapturedScene> scene_;
    std::optional<PoseWatch> pose_;  ///< of scene_
    std::uint64_t capturedAt_ = 0;   ///< count of the telemetry that is scene_
    bool wasUnheard_ = false;
    bool wasSuspected_ = false;
    std::vector<ArmReading> readings_;
    std::optional<Aside> aside_;

    // Of the worker's jobs; 0: none is under way.
    int job_ = 0, secondJob_ = 0, liveJob_ = 0, warmUpJob_ = 0;
    int estimateJob_ = 0;  ///< of estimate_
    std::optional<TerrainEstimate> estimate_, second_, live_;
    double seconds_ = 0.0;
    double askedLimit_ = 0.0;  ///< [m] of the request that is under way or came last
    ProbeAdvice advice_;
    bool unadvised_ = false;  ///< offered() of estimate_ waits for advice of the limit of now
    QString whyNone_;
    std::optional<Method> secondMethod_;
    std::vector<Processes>
        made_;  ///< by the worker; where warmUpJob_ is not 0, the last of them is under way
    std::uint64_t previewed_ = 0;  ///< count of the telemetry that the newest preview is about

    CalibrationLedger ledger_;
    std::optional<GhostTrack> track_;  ///< of the last estimate
    std::uint64_t tracked_ = 0;        ///< count of the telemetry it has taken last
};

/// Why no ghost of an estimate is shown: it has none, or the robot is not heard.  Empty: it is shown.
QString noGhostWords(std::optional<NoGhost> why, bool heard);

}  // namespace terratact
