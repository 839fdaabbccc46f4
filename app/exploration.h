#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "app/acquisition.h"
#include "app/can_source.h"
#include "app/estimator_worker.h"
#include "core/atem/atem_machine.h"
#include "core/atem/following.h"
#include "core/eval/calibration_ledger.h"
#include "core/infer/ghost_track.h"
#include "core/infer/quality.h"
#include "core/infer/verdict.h"
#include "core/robot/robot_model.h"
#include "drivers/measurement_source.h"
#include "widgets/atem_panel.h"
#include "widgets/event_list.h"
#include "widgets/probe_card.h"

namespace terratact {

/// The scene an estimate rests on.
struct CapturedScene {
    Measurement measurement;
    std::optional<Heights> truth;
};

/// Joins the exploration's state machine to the world: telemetry, the operator and the estimator go in,
/// commands go out.  Over a link that takes no commands none do, and it follows instead what the robot does
/// for somebody else: every press is captured and estimated, every reading of the arm estimated again and
/// scored.  GUI thread only; it looks at the world when tick() is called.  Source, worker and
/// link must outlive it.
class Exploration final : public QObject {
    Q_OBJECT
public:
    struct Options {
        Settings settings;
        AtemLimits limits;
        double pressTorque = 18.0;      ///< [N m] sum of both front flippers
        double driveSpeed = 0.2;        ///< [m/s]
        double linkLostAfter = 0.25;    ///< [s] without telemetry
        double probeSeconds = 45.0;     ///< what a probe costs, as told to the operator
        double stepLimit = kStepLimit;  ///< [m] what counts as an obstacle
    };

    /// link: the source again where its robot has to be armed; else null.
    Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                const Options& options, CanSource* link = nullptr);

    // What the operator did.
    void request();
    void abort();
    /// Takes what is doubtful now upon the operator, until it is so no more.
    void overrideDoubts();
    void approve(quint64 proposal);
    void refuse(quint64 proposal);
    void choose(quint64 proposal, int bin);  ///< asks for another bin of the ranking instead
    void setStepLimit(double metres);        ///< what counts as an obstacle
    void
    setSecondMethod(std::optional<Method> method);  ///< estimated beside the first; empty: none
    void drive(int direction);
    void halt();  ///< ends drive(); does nothing when not driving
    void stop();  ///< goes out at once and again until the robot confirms it
    void releaseStop();
    void setSettings(const Settings& settings);  ///< of the estimates from now on; the seed stays
    void leave();  ///< the window closes: halts what was set in motion from here

    /// now: [s] on the steady clock.
    void tick(double now, const std::optional<Received>& latest);

    // What there is to see.
    const AtemState& state() const { return state_; }
    std::optional<double> timeLeft() const;
    bool linkAlive() const { return linkAlive_; }
    bool armed() const;  ///< true without a link: such a source needs no arming
    bool following() const { return !whyFollowing_.isEmpty(); }
    bool ended() const { return ended_; }  ///< a log that is replayed
    const std::optional<CapturedScene>& scene() const { return scene_; }
    const std::optional<TerrainEstimate>& estimate() const { return estimate_; }
    /// Every probe beside the band shown before it, since the console started.
    const CalibrationLedger& ledger() const { return ledger_; }
    double estimateSeconds() const { return estimateSeconds_; }
    /// What the estimate says about driving on, for the limit of now; empty without an estimate.
    std::optional<Verdict> verdict() const;
    /// The estimate of a captured scene is under way.
    bool estimating() const
    {
        return state_.phase == AtemPhase::Estimating || state_.phase == AtemPhase::EstimatingAgain;
    }
    /// The second method's estimate of the same scene, once there is one.
    const std::optional<TerrainEstimate>& second() const { return second_; }
    std::optional<Method> secondMethod() const { return secondMethod_; }
    /// Of telemetry while the flippers still move down, until estimate() stands: a preview by the local method,
    /// as often as the estimator keeps up with the telemetry.
    const std::optional<TerrainEstimate>& live() const { return live_; }
    /// Where the last estimate lies now that the robot has moved on, until there is a new one; it decides nothing.
    std::optional<Ghost> ghost() const;
    QString whyNoGhost() const;  ///< of the last estimate, in words; empty: there is, or was none
    const std::optional<ProbeProposal>& proposal() const { return proposal_; }
    const std::string& proposedOn() const
    {
        return proposedOn_;
    }  ///< fingerprint of what it rests on
    const std::vector<ArmReading>& readings() const
    {
        return readings_;
    }  ///< of the arm at this pose
    std::optional<int> probingBin() const;
    double secondsInPhase() const { return now_ - state_.since; }
    QString whyNoEstimate() const
    {
        return whyNoEstimate_.isEmpty() ? nothingYet() : whyNoEstimate_;
    }
    QString whyNotDriving() const;  ///< empty: driving is allowed
    QList<Precondition> preconditions() const;
    QString overridden() const;  ///< what the operator has overridden, in words; empty: nothing
    const Options& options() const { return options_; }

signals:
    void happened(const QString& text, terratact::Weight weight);
    // For whoever keeps a record.
    void captured(const terratact::CapturedScene& scene);
    void stands(bool second);            ///< an estimate, of the second method or not
    void proposed();                     ///< to the operator, a probe
    void forgotten(const QString& why);  ///< the estimate that stood
    void decided(const char* what, const QString& text);  ///< by the operator

private:
    void command(const Command& command);
    bool answered() const;  ///< the newest telemetry was measured after the last command
    void advance();         ///< the state by one tick
    void look(AtemInput& in);
    void repeatStop(AtemInput& in);
    void lookForMoves();
    bool moved() const;
    void enter(const AtemState& before);
    void follow();
    FollowInput followed() const;
    void enterFollowed();
    QString nothingYet() const;  ///< of estimates, and what brings one
    QString whyMoved() const;
    void capture();
    void startEstimate();
    void startSecond();
    EstimateRequest requestFor(Method method) const;
    ProbeProposal proposalFor(int bin) const;
    void cancelEstimate();
    void keepLive();
    void takeLive(const TerrainEstimate& estimate);
    void forget(const QString& why);
    void trackGhost(const std::optional<Received>& latest);
    std::optional<NoGhost> noGhost() const;
    void finishProbe(const ArmReading& reading);
    Precondition arming() const;  ///< of a link
    Precondition planarity() const;
    std::string grounds() const;  ///< fingerprint of what the proposal rests on now

    MeasurementSource& source_;
    CanSource* link_;
    RobotModel robot_;
    EstimatorWorker& worker_;
    Options options_;

    AtemState state_;
    AtemInput pending_;  ///< what the operator and the worker did since the last tick
    double now_ = 0.0;
    std::optional<Received> latest_;
    bool linkAlive_ = false;
    bool planarOverridden_ = false;
    bool ended_ = false;
    /// Count of the newest telemetry at the last command, or while a followed link was lost: what it and those
    /// before it say is no answer.
    std::uint64_t commandedAt_ = 0;

    QString whyFollowing_;             ///< why no command leaves, in words; empty: they do
    std::uint64_t capturedPress_ = 0;  ///< Press::count

    bool driving_ = false;
    bool releasing_ = false;
    double stopSent_ = 0.0, releaseBegan_ = 0.0;  ///< [s]

    std::optional<CapturedScene> scene_;
    std::uint64_t movedAt_ = 0;  ///< count of the telemetry that first looked like a move
    bool moved_ = false;
    std::optional<TerrainEstimate> estimate_;
    double estimateSeconds_ = 0.0;
    QString whyNoEstimate_;            ///< empty: there was none yet
    std::optional<GhostTrack> track_;  ///< of the last estimate
    ProbeAdvice advice_;               ///< of the estimate
    std::optional<ProbeProposal> proposal_;
    std::string proposedOn_;  ///< grounds() when it was proposed
    double approvedAt_ = 0.0;
    std::optional<ProbeProposal> approved_;
    std::optional<ArmReading> armBefore_;
    std::vector<ArmReading> readings_;  ///< at this pose
    CalibrationLedger ledger_;
    bool sawProbing_ = false;
    quint64 lastProposal_ = 0;
    int job_ = 0;

    std::optional<Method> secondMethod_;
    std::optional<TerrainEstimate> second_;
    int secondJob_ = 0;

    std::optional<TerrainEstimate> live_;
    int liveJob_ = 0;              ///< 0: none under way
    std::uint64_t liveCount_ = 0;  ///< telemetry that the newest live job is about

    QString modelName_, modelDetails_;
    QString modelTrouble_;
};

}  // namespace terratact
