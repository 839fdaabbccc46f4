#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/link/acquisition.h"
#include "app/link/can_source.h"
#include "app/mission/estimation.h"
#include "app/mission/passive_exploration.h"
#include "app/mission/preconditions.h"
#include "app/mission/probe_proposals.h"
#include "core/atem/atem_machine.h"
#include "core/atem/drive_watch.h"
#include "core/limits.h"
#include "core/robot/robot_model.h"
#include "drivers/measurement_source.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {

/// Joins the exploration's state machine to the world: telemetry, the operator and the estimation go in,
/// commands go out.  Over a link that takes no commands none do, and what the robot does for somebody else is
/// followed instead.  GUI thread only; it looks at the world when tick() is called.  Source, worker and
/// link must outlive it.
class Exploration final : public QObject {
    Q_OBJECT
public:
    struct Options : Estimation::Options {
        AtemLimits limits;
        ProbePolicy probes = ProbePolicy::Variance;
        double pressTorque = 18.0;              ///< [N m] sum of both front flippers
        double driveSpeed = 0.2;                ///< [m/s]
        double linkLostAfter = kLinkLostAfter;  ///< [s] without telemetry
        double staleAfter =
            kStaleAfter;             ///< [s] older telemetry is none of now: no verdict, no ghost
        double probeSeconds = 45.0;  ///< what a probe costs, as told to the operator
        std::string groundFile;      ///< of the built-in robot; empty: its ground is from no file
    };

    /// link: the source again where its robot has to be armed; else null.
    Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                const Options& options, CanSource* link = nullptr);

    // What the operator did.
    void request();
    void abort();
    /// Takes what is doubtful now upon the operator, until it is so no more or has become worse.
    void overrideDoubts();
    void approve(quint64 proposal);
    void refuse(quint64 proposal);
    void choose(quint64 proposal, int bin);  ///< asks for another bin of the ranking instead
    /// A probe of this bin, whatever the advice says of it: in place of the question that stands, or by exploring anew at
    /// this pose, after which it is what is asked.  It is approved and sent like any other.
    void askProbe(int bin);
    QString whyNotAsking(int bin) const;  ///< a probe of it; empty: askProbe() may
    void forgetResult();   ///< takes estimate and ghost off the screen, while nothing is explored
    void restoreResult();  ///< brings back what forgetResult() took
    void setStepLimit(double metres);  ///< what counts as an obstacle
    /// Probes are offered by it from the next estimate on; what bestProbe() ranks by changes at once.
    void setProbePolicy(ProbePolicy policy) { options_.probes = policy; }
    void setEstimateSeconds(double seconds) { options_.seconds = seconds; }  ///< 0: no limit
    /// Estimated beside the first; empty: none.
    void setSecondMethod(std::optional<Method> method);
    void drive(int direction);  ///< as soon as the robot has ended what it explored
    void halt();                ///< ends drive(); does nothing when not driving
    /// Goes out at once and again until the robot confirms it; over a link that takes no commands it only says so.
    void stop();
    void stopFrom(const QString& where);  ///< likewise, with a word about who pressed it
    void releaseStop();
    void setSettings(const Settings& settings);  ///< of the estimates from now on; the seed stays
    void leave();  ///< the window closes: halts what was set in motion from here

    /// now: [s] on the steady clock.
    void tick(double now, const std::optional<Received>& latest);

    // What there is to see.
    const Estimation& estimation() const { return estimation_; }
    const AtemState& state() const { return state_; }
    std::optional<PhaseTime> time() const;
    /// Where more is known than the state itself says: why it has failed, whether STOP is confirmed.  Else empty.
    QString stateWords() const;
    double secondsInPhase() const { return now_ - state_.since; }
    /// The estimate of a captured scene is under way.
    bool estimating() const
    {
        return state_.phase == AtemPhase::Estimating || state_.phase == AtemPhase::EstimatingAgain;
    }
    StopViewState stopViewState() const;
    bool linkAlive() const { return linkAlive_; }
    bool armed() const;  ///< true without a link: such a source needs no arming
    bool following() const { return following_ != nullptr; }
    bool ended() const { return ended_; }  ///< a log that is replayed
    bool canRestore() const { return estimation_.isAside() && !estimation_.scene(); }
    QString whyNoEstimate() const;  ///< and what brings one
    const std::optional<ProbeProposal>& proposal() const { return probes_.current(); }
    /// What a probe would buy by the estimate that stands, whether or not one is proposed; empty: nothing can be told.
    std::optional<ProbeProposal> bestProbe() const { return probes_.best(); }
    /// Why none was offered for it; empty: one was, or would be where commands leave.
    QString whyNotOffered() const;
    /// Fingerprint of what the proposal rests on.
    const std::string& proposedOn() const { return probes_.proposedOn(); }
    std::optional<int> probingBin() const;
    QString whyNotDriving() const { return firstMissing(toDrive()); }  ///< empty: it is allowed
    QList<Precondition> preconditions() const;                         ///< of exploring
    QList<Precondition> toDrive() const;
    QList<Precondition> toProbe() const;  ///< to approve what is proposed
    QList<Precondition> toReleaseStop() const;
    /// What the operator has overridden, in words, as it was then; empty: nothing.
    QString overridden() const { return ground_.overridden().join(QStringLiteral("; ")); }
    const Options& options() const { return options_; }

signals:
    void happened(const QString& text, terratact::Weight weight);
    void stoppedNothing(const QString& why);  ///< stop() could do nothing
    // For whoever keeps a record.
    void proposed();                                      ///< to the operator, a probe
    void decided(const char* what, const QString& text);  ///< by the operator

private:
    void takeAdvice();
    void explore();
    bool inReach(int bin) const;
    QString wordsOf(NoProbe why) const;
    /// The same probe by the newest advice: another question, with an id of its own.
    void askAnew();

    // The state by one tick.
    void advance();
    void follow();
    void poll(AtemInput& in);
    void repeatStop(AtemInput& in);
    void sendStop();
    void confirmStop(bool latched);
    void enter(const AtemState& before);
    void probe();
    void present(bool unprobed);
    void end(bool aborted);
    void fail();
    QString failureWords() const;
    void preview();

    void driveOn();
    void watchDrive();
    void command(const Command& command);
    bool answered() const;    ///< the newest telemetry was measured after the last command
    bool hasPressed() const;  ///< the flippers, as they were last commanded to
    void endOverrides();
    bool armIsOut() const;
    void forget(const QString& why);  ///< the estimate and what is proposed on it
    QString whyNotArmed() const;      ///< of a link; empty: it is

    MeasurementSource& source_;
    CanSource* link_;
    RobotModel robot_;
    Options options_;
    Estimation estimation_;
    ProbeProposals probes_;
    bool offered_ = false;  ///< a probe, when the estimate that stands came
    std::optional<int>
        askedBin_;  ///< of the operator, before the estimate that it is to be asked with
    std::unique_ptr<PassiveExploration> following_;  ///< null: commands leave

    AtemState state_;
    AtemInput pending_;  ///< what the operator and the worker did since the last tick
    double now_ = 0.0;
    std::optional<Received> latest_;
    bool linkAlive_ = false;
    bool ended_ = false;
    PlanarGround ground_;
    /// Count of the newest telemetry at the last command: what it and those before it say is no answer.
    std::uint64_t commandedAt_ = 0;

    bool driving_ = false;
    DriveWatch driveWatch_;
    std::optional<DriveCommand> driveWanted_;  ///< that has not been sent yet
    double driveBegan_ = 0.0;                  ///< [s]
    bool releasing_ = false;
    double stopBegan_ = 0.0, stopSent_ = 0.0, releaseBegan_ = 0.0;  ///< [s]
    bool stopConfirmed_ = false;  ///< by the robot; telemetry that fails to come takes nothing back
    QString stopTrouble_;         ///< why the newest STOP did not leave

    double approvedAt_ = 0.0;              ///< [s]
    std::optional<double> pressTook_;      ///< [s] the last press of this run
    Refusal refusal_ = Refusal::None;      ///< with which the robot refused
    int probing_ = 0;                      ///< bin of the probe under way
    std::optional<ArmReading> armBefore_;  ///< the newest reading before
    bool sawProbing_ = false;
};

}  // namespace terratact
