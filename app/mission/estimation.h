#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/display/event_severity.h"
#include "app/link/acquisition.h"
#include "app/mission/estimator_worker.h"
#include "app/mission/way_memory.h"
#include "app/runtime/revised.h"
#include "core/atem/pose_watch.h"
#include "core/base/message.h"
#include "core/eval/calibration_ledger.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/robot/robot_model.h"
#include "core/strip/strip.h"

namespace terratact {

/// The captured scene that an estimate belongs to.
struct CapturedScene {
    Measurement measurement;
    std::optional<Heights> truth;
    std::optional<std::array<Heights, 2>> sideTruth{};  ///< left, right
    SceneMemory memory{};                               ///< of the way before
};

/// Texts about the estimator's model.
struct ModelInUse {
    QString name{}, details{};  ///< empty: no model has been loaded
    QString content{};          ///< LoadedModel::content
    Message trouble{};          ///< reason that there is no model
    bool hasTwoTracks = false;  ///< LoadedModel::hasTwoTracks
    TrailInUse trail{};         ///< LoadedModel::trail
};

/// Owns the estimates of the present scene, by the settings' method and an optional second method, with the arm's
/// readings. Before the scene it gives live previews while the flippers move down. It adds every estimate to the strip
/// of felt ground, which follows the telemetry. The method trail gets the memory of the way before the scene; without
/// a memory, local estimates. The worker computes. Answers to outdated requests are dropped. GUI thread only.
class Estimation final : public QObject {
    Q_OBJECT
public:
    struct Options {
        Settings settings;
        double stepLimit = kStepLimit;  ///< [m] obstacle height
        double seconds = 0.0;           ///< EstimateRequest::seconds
    };

    /// options: read at every request. Worker, robot and options must outlive the object.
    Estimation(EstimatorWorker& worker, const RobotModel& robot, const Options& options);

    // Requests.
    /// Passes the newest telemetry and whether it is fresh. Call at every tick, before all other calls.
    void poll(const std::optional<Received>& latest, bool telemetryFresh);
    /// Prepares the model's Gaussian processes for an exploration while the worker is idle.
    void prepare();
    /// Requests a preview with the local method, or with trail, whenever the worker is free. The preview stays until a
    /// later one fails, an estimate is ready, or endPreview().
    void preview(const Received& latest);
    void endPreview() { live_.reset(); }
    /// Captures a scene and estimates it. The scene is the first sample of the press, so that every console captures
    /// the same one. If that did not come after sample `since`, the newest sample is used. After another press in
    /// place, the arm's readings there still count (TrailRecord::armHere()).
    void begin(const Received& latest, std::uint64_t since);
    /// Scores the estimate of the reading's side against the reading, then estimates the scene again with the reading.
    /// A reading in the middle of two sides belongs to neither side and is not scored.
    void addArmReading(const ArmReading& reading);
    void setSecondMethod(std::optional<Method> method);  ///< empty: none
    void cancel();                                       ///< cancels all running jobs
    void adviseAnew();  ///< requests advice for the present step limit if it has changed
    /// Drops scene, readings, estimates and pending answers, but not a preview. The strip keeps what was felt.
    void forget(const Message& why);
    /// Takes the estimate out of the strip; without one, ends the strip's section.
    void takeBack();
    /// Does forget() and takeBack() so that restore() can undo both, and forgets the way. restore() needs the same
    /// model and pose, and no newer scene.
    void setAside(const Message& why);
    bool isAside() const { return aside_ && !aside_->pose.hasLeft(); }
    bool restore();  ///< returns false if nothing is set aside

    // Results.
    const std::optional<CapturedScene>& scene() const { return scene_; }
    /// Returns true if the robot has moved since scene().
    bool hasMoved() const { return pose_ && pose_->hasMoved(); }
    /// Returns true if the robot has left the pose of scene().
    bool hasLeft() const { return pose_ && pose_->hasLeft(); }
    /// Returns true if telemetry was missing so long since scene() that the robot may have moved. Only a new scene
    /// resets it.
    bool hadTelemetryGap() const { return hadTelemetryGap_; }
    /// Returns true if a sensor was suspected while the robot was at scene().
    bool wasSuspected() const { return wasSuspected_; }
    /// Returns true if the pitch was suspected. It places the bins, and the arm with them.
    bool wasPitchSuspected() const { return wasPitchSuspected_; }
    const Settings& wanted() const { return options_.settings; }  ///< settings of the next estimate
    /// Returns the arm readings in scene().
    const std::vector<ArmReading>& readings() const { return readings_; }
    const std::optional<TwoTrackEstimate>& estimate() const { return estimate_.value(); }
    double seconds() const { return seconds_; }  ///< computation time of estimate() [s]
    /// Returns how much of the way estimate() remembers, or why nothing. Empty: another method than trail was wanted.
    Message memoryText() const;
    /// Returns why the last request gave no estimate(); empty: no reason that concerns a scene.
    const Message& whyNone() const { return whyNone_; }
    const ProbeAdvice& advice() const { return advice_; }  ///< probe advice for estimate()
    /// Returns the verdict of estimate() for the present step limit; empty without an estimate.
    std::optional<TwoTrackVerdict> verdict() const;
    std::optional<Method> secondMethod() const { return secondMethod_; }
    const std::optional<TwoTrackEstimate>& second() const { return second_.value(); }
    const std::optional<TwoTrackEstimate>& live() const
    {
        return live_.value();
    }  ///< the live preview
    /// Revisions of estimate(), second() and live(): an unchanged number means an unchanged estimate.
    struct Revisions {
        std::uint64_t estimate = 0, second = 0, live = 0;
    };
    Revisions revisions() const
    {
        return {estimate_.revision(), second_.revision(), live_.revision()};
    }
    /// Returns true if the next estimate of such a line may be of both sides. Roll and different flippers then give no
    /// warning.
    bool estimatesBothSides(const Measurement& line) const;
    /// Returns the ground felt along the way, as seen from the newest telemetry; empty while that is missing. It
    /// affects no decision.
    SeenStrip remembered() const;
    /// Returns why nothing is remembered here; empty: there is something, or nothing was felt yet.
    std::optional<Message> whyNothingRemembered() const;
    const Strip& strip() const { return strip_; }
    /// Number of finished estimates of scenes, and of those that contradict their readings
    /// (core/sim/posterior_check.h), since the console started.
    struct Counts {
        std::uint64_t estimates = 0, contradicting = 0;
    };
    const Counts& counts() const { return counts_; }
    /// Returns every probe with the band shown before it, since the console started.
    const CalibrationLedger& ledger() const { return ledger_; }
    const ModelInUse& model() const { return model_; }

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);
    void modelChanged();  ///< an existing estimate still belongs to the previous model
    void captured(const terratact::CapturedScene& scene);
    void estimateReady(bool second);  ///< a new estimate is ready; second: of the second method
    void offered();       ///< the first advice for estimate() with the present step limit is ready
    void failed();        ///< the estimate of scene() failed
    void advised();       ///< new advice for another step limit is ready
    void telemetryGap();  ///< hadTelemetryGap() became true, or the strip ended for that reason
    void forgotten(const terratact::Message& why);  ///< the estimate was dropped

private:
    /// Key of a sampling method's Gaussian processes besides the model.
    struct Processes {
        Method method;
        int inducing;
        Precision precision;
        bool operator==(const Processes&) const = default;
    };
    void suspect(const std::vector<SensorSuspicion>& suspicions);

    /// An estimate that the operator has cleared.
    struct Aside {
        CapturedScene scene;
        PoseWatch pose;
        std::uint64_t capturedAt;
        bool hadTelemetryGap;
        std::vector<ArmReading> readings;
        TwoTrackEstimate estimate;
        std::optional<TwoTrackEstimate> second;
        Message memoryText;
        WayMemory memory;
    };

    void listenToModels();
    void addAdvice(int job, const ProbeAdvice& advice);
    void offer();
    void accept(int job, const TwoTrackEstimate& estimate, double seconds);
    void refuse(int job, const Message& why);
    /// Makes the worker prepare the Gaussian processes of a sampling method, so that no estimate waits for them.
    /// Returns false if that is done already or the method needs none.
    bool warmUp(Method method);
    Processes processesOf(Method method) const;
    void endWarmUp();  ///< another request replaces it
    void start();
    void startSecond();
    void resume();  ///< repeats the request that the worker dropped to load a model
    EstimateRequest requestFor(Method method) const;
    void announceMemory();
    void announce(const TwoTrackEstimate& estimate);
    void score(const ArmReading& reading);

    EstimatorWorker& worker_;
    const RobotModel& robot_;
    const Options& options_;
    ModelInUse model_;
    bool telemetryFresh_ = false;

    std::optional<CapturedScene> scene_;
    std::optional<PoseWatch> pose_;  ///< watches the pose of scene_
    std::uint64_t capturedAt_ = 0;   ///< count of the sample that became scene_
    bool hadTelemetryGap_ = false;
    bool wasSuspected_ = false, wasPitchSuspected_ = false;
    std::vector<ArmReading> readings_;
    std::optional<Aside> aside_;

    // Numbers of the worker's jobs; 0: not running.
    int job_ = 0, secondJob_ = 0, liveJob_ = 0, warmUpJob_ = 0;
    int estimateJob_ = 0;  ///< job of estimate_
    Revised<TwoTrackEstimate> estimate_, second_, live_;
    double seconds_ = 0.0;
    double askedLimit_ = 0.0;  ///< [m] step limit of the current or last request
    ProbeAdvice advice_;
    bool unadvised_ = false;  ///< offered() waits for advice with the present step limit
    Message whyNone_;
    std::optional<Method> secondMethod_;
    /// Processes made by the worker; while warmUpJob_ runs, the last entry is in progress.
    std::vector<Processes> made_;
    std::uint64_t previewed_ = 0;  ///< count of the sample in the newest preview

    Counts counts_;
    CalibrationLedger ledger_;
    Strip strip_;
    WayMemory memory_;
    Message askedMemory_;        ///< text about the memory of the current or last request
    Message memoryText_;         ///< of the request of estimate_
    Message memoryLogged_;       ///< newest reason that nothing is remembered
    std::uint64_t tracked_ = 0;  ///< count of the last sample it used
};

}  // namespace terratact
