#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/display/event_severity.h"
#include "app/display/precondition.h"
#include "app/display/stop_view_state.h"
#include "app/link/can_source.h"
#include "app/link/robot_moment.h"
#include "app/mission/estimation.h"
#include "app/mission/passive_exploration.h"
#include "app/mission/preconditions.h"
#include "app/mission/probe_proposals.h"
#include "core/atem/advance_watch.h"
#include "core/atem/atem_machine.h"
#include "core/atem/drive_watch.h"
#include "core/atem/feel_forward.h"
#include "core/atem/phase_time.h"
#include "core/atem/probe/probe_proposal.h"
#include "core/base/message.h"
#include "core/limits.h"
#include "core/robot/attitude.h"
#include "core/robot/robot_model.h"
#include "drivers/measurement_source.h"

namespace terratact {

/// Connects the exploration's state machine with telemetry, operator, estimation and command link. On a receive-only
/// link it sends nothing and follows another console's exploration. GUI thread only; tick() polls all inputs. Source,
/// worker and link must outlive it.
class Exploration final : public QObject {
    Q_OBJECT
public:
    struct Options : Estimation::Options {
        AtemLimits limits;
        ProbePolicy probes = ProbePolicy::Variance;
        double pressTorque = 18.0;  ///< [N m] sum of both front flippers
        double driveSpeed = 0.2;    ///< [m/s] of keys; the gate allows GateLimits::speed
        AttitudeLimits attitude;    ///< beyond amber, feel forward ends
        /// [s] telemetry watchdog: longer silence means a lost link.
        double linkLostAfter = kLinkLostAfter;
        double staleAfter =
            kStaleAfter;  ///< [s] older telemetry is stale: no verdict, nothing remembered
        double probeSeconds = 45.0;  ///< expected duration of a probe, shown to the operator
        /// Ground file of the simulated robot, or "" for the built-in step or random ground; std::nullopt: a real
        /// robot.
        std::optional<std::string> groundFile;
    };

    /// link: the same source if its robot needs arming; else null.
    Exploration(MeasurementSource& source, RobotModel robot, EstimatorWorker& worker,
                const Options& options, CanSource* link = nullptr);

    // Actions of the operator.
    void request();
    void abort();
    /// Begins feel forward: explores, advances by 0.1 m and explores again, until letGo() or something ends it. The
    /// caller is a dead-man control: it calls letGo() for any reason that ends the hold.
    void feelForward();
    void letGo();  ///< halts feel forward at once; does nothing otherwise
    /// Overrides the present doubtful preconditions. Each override ends when its reason ends or grows.
    void overrideWarnings();
    void approve(quint64 proposal);
    void refuse(quint64 proposal);
    void choose(quint64 proposal,
                ProbePlace place);  ///< proposes another place of the ranking instead
    /// Requests a probe of this place, whatever the advice. It replaces the current proposal, or starts a new
    /// exploration at this pose that proposes it. Approval is needed as for any other probe.
    void askProbe(ProbePlace place);
    /// Returns why request() has no effect, or what must be overridden first; empty: it is allowed.
    std::optional<Message> whyNotExploring() const;
    std::optional<Message>
    whyNotAsking(ProbePlace place) const;  ///< why askProbe() is refused; empty: it is allowed
    void forgetResult();                   ///< clears the estimate unless exploring
    void restoreResult();                  ///< restores what forgetResult() cleared
    void setStepLimit(double metres);      ///< obstacle height
    void setAttitudeLimits(const AttitudeLimits& limits) { options_.attitude = limits; }
    /// Sets the policy of proposals from the next estimate on; bestProbe() uses it at once.
    void setProbePolicy(ProbePolicy policy) { options_.probes = policy; }
    void setEstimateSeconds(double seconds) { options_.seconds = seconds; }  ///< 0: no limit
    /// Sets the method of the second estimate; empty: none.
    void setSecondMethod(std::optional<Method> method);
    /// Sets the speed [m/s] of drives, also of one in progress, for a control with a way; empty: options().driveSpeed.
    void setDriveSpeed(std::optional<double> speed);
    void drive(int direction);  ///< starts as soon as the robot has ended its exploration
    void halt();                ///< ends drive(); does nothing otherwise
    /// Sends STOP at once and repeats it until the robot confirms. On a receive-only link it only reports that. The
    /// path from the key to the frame stands in exploration_stop.cpp.
    void stop();
    void stopFrom(const Message& where);  ///< the same, with a text about the origin of the press
    void releaseStop();
    /// Settings of following estimates; the seed stays.
    void setSettings(const Settings& settings);
    void leave();  ///< call when the window closes: halts motion commanded from here

    /// Polls all inputs.
    void tick(const RobotMoment& moment);

    // State.
    const Estimation& estimation() const { return estimation_; }
    const AtemState& state() const { return state_; }
    std::optional<PhaseTime> time() const;
    /// Returns a text with more detail than the state: why it failed, whether STOP is confirmed. Empty: none.
    Message stateText() const;
    double secondsInPhase() const { return now_ - state_.since; }
    /// Returns true while the estimate of a captured scene is running.
    bool estimating() const
    {
        return state_.phase == AtemPhase::Estimating || state_.phase == AtemPhase::EstimatingAgain;
    }
    StopViewState stopViewState() const;
    bool linkAlive() const { return linkAlive_; }
    bool armed() const;  ///< true without a link, because such a source needs no arming
    bool following() const { return following_ != nullptr; }
    bool ended() const { return ended_; }  ///< end of a replayed log
    bool canRestore() const { return estimation_.isAside() && !estimation_.scene(); }
    Message whyNoEstimate() const;  ///< reason, and how to get an estimate
    const std::optional<ProbeProposal>& proposal() const { return probes_.current(); }
    /// Returns the best probe for the present estimate, proposed or not; empty: its gain is unknown.
    std::optional<ProbeProposal> bestProbe() const { return probes_.best(); }
    /// Returns why bestProbe() returns empty; empty without an estimate.
    Message whyNoBestProbe() const { return probes_.whyNoBest(); }
    /// Returns why the best probe is not proposed. Empty if it is proposed, was done or was not answered in time. Also
    /// empty if it would be proposed, but commands cannot be sent.
    std::optional<Message> whyNotOffered() const;
    /// Returns the fingerprint of the data behind the proposal.
    const std::string& proposedOn() const { return probes_.proposedOn(); }
    std::optional<ProbePlace> probingPlace() const;  ///< empty: no probe is running
    /// Returns the first unmet precondition of driving; empty: driving is allowed.
    std::optional<Message> whyNotDriving() const { return firstMissing(toDrive()); }
    QList<Precondition> preconditions() const;  ///< preconditions of exploring
    /// Preconditions of driving: STOP is released, nothing is explored, telemetry, armed, the arm is not out.
    QList<Precondition> toDrive() const;
    QList<Precondition> toFeelForward() const;
    /// Returns the first unmet or doubtful precondition of feelForward(); empty: it is allowed.
    std::optional<Message> whyNotFeelingForward() const;
    LoopPace pace() const;                ///< of the present or last feel forward
    QList<Precondition> toProbe() const;  ///< preconditions of approving the proposal
    QList<Precondition> toReleaseStop() const;
    /// Returns the overridden values; empty: none.
    std::vector<Message> overridden() const { return ground_.overridden(); }
    const Options& options() const { return options_; }

signals:
    void happened(const terratact::Message& text, terratact::EventSeverity severity);
    /// Emitted instead of happened() for an event that stateText() contains.
    void stateChanged(const terratact::Message& text, terratact::EventSeverity severity);
    void stoppedNothing(const terratact::Message& why);  ///< stop() had no effect
    // Signals for the session's record.
    void proposed();  ///< a probe was proposed
    /// A decision of the operator; SessionEventLogger records it.
    void decided(const char* what, const terratact::Message& text);

private:
    void addAdvice();
    void explore();
    bool inReach(ProbePlace place) const;
    std::optional<Message> wordsOf(NoProbe why) const;
    /// Proposes the same probe with the newest advice, as a new proposal with its own id.
    void askAnew();

    // Steps of one tick.
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
    Message failureText() const;
    void preview();

    // Feel forward.
    FeltAhead feltAhead() const;
    ProbeOffer loopOffer() const;  ///< what to propose while the loop goes on
    void pollLoop(AtemInput& in);
    void pollAdvance(AtemInput& in);
    void beginAdvance();
    void sendAdvance();  ///< as soon as the robot has ended its exploration
    void endAdvance();
    void showLoop(const AtemState& before);
    Message loopText() const;
    bool reportsExploring() const;  ///< false also without a bus
    bool hasBegun() const;          ///< in Halting
    Message whyNotBegun() const;    ///< empty: not known
    /// Ends the exploration before, then begins the next one; repeats both until the robot reports them.
    void beginOn();
    /// Returns true if the robot still reports the exploration that ended at this time, for a second at most.
    bool isRobotStillExploring(double endedAt) const;

    DriveCommand driveCommand() const;
    void driveOn();
    void watchDrive();
    std::optional<Message>
    unsent(const Command& command);  ///< sends it; returns why it was not sent
    std::optional<Message> command(const Command& command);  ///< the same, and reports it
    /// Sends the command that the present phase waits for. Unsent, it ends the exploration; returns false then.
    bool ask(const Command& wanted);
    bool answered() const;    ///< the newest sample was measured after the last command
    bool hasPressed() const;  ///< the flippers have executed the last press command
    void endOverrides();
    bool armIsOut() const;
    bool isBeyondTipping() const;
    void forget(const Message& why);             ///< drops the estimate and the proposal on it
    std::optional<Message> whyNotArmed() const;  ///< reason on a link; empty: armed

    MeasurementSource& source_;
    CanSource* link_;
    RobotModel robot_;
    Options options_;
    Estimation estimation_;
    ProbeProposals probes_;
    bool offered_ = false;  ///< a probe was proposed for the present estimate
    std::optional<ProbePlace>
        asked_;  ///< place requested by the operator, until its estimate is ready
    std::unique_ptr<PassiveExploration> following_;  ///< null: this console sends commands

    AtemState state_;
    AtemInput pending_;  ///< actions of operator and worker since the last tick
    double now_ = 0.0;
    std::optional<Received> latest_;
    std::optional<CanView> bus_;  ///< empty without a link, or before the first tick
    bool linkAlive_ = false;
    bool telemetryFresh_ = false;
    bool ended_ = false;
    PlanarGround ground_;
    /// Count of the newest sample at the last command; earlier samples cannot be its answer.
    std::uint64_t commandedAt_ = 0;

    bool held_ = false;                    ///< the operator holds the control of feel forward
    LoopPace pace_;                        ///< way of the finished advances
    std::optional<AdvanceWatch> advance_;  ///< since the command was sent

    bool driving_ = false;
    int direction_ = 0;                 ///< of the drive
    std::optional<double> driveSpeed_;  ///< [m/s]
    DriveWatch driveWatch_;
    /// Halting: time [s] of the newest begin, or of the newest abort of the exploration before.
    std::optional<double> askedToBegin_;
    bool beginWasAsked_ = false;               ///< Halting: a begin was tried
    std::optional<DriveCommand> driveWanted_;  ///< drive command that is not sent yet
    double driveBegan_ = 0.0;                  ///< [s]
    bool releasing_ = false;
    double stopBegan_ = 0.0, stopSent_ = 0.0, releaseBegan_ = 0.0;  ///< [s]
    /// The robot has confirmed STOP; missing telemetry does not revoke it.
    bool stopConfirmed_ = false;
    Message stopTrouble_;  ///< reason that the newest STOP was not sent
    Message notSent_;      ///< reason of NotSent and BeginTimeout; empty: not known

    double approvedAt_ = 0.0;          ///< [s]
    std::optional<double> pressTook_;  ///< [s] duration of the last press in this run
    Refusal refusal_ = Refusal::None;  ///< reason of the robot's last refusal
    /// What had disarmed the robot when the exploration failed.
    DisarmCause disarmedBy_ = DisarmCause::None;
    ProbeCommand probing_;                 ///< running probe
    std::optional<ArmReading> armBefore_;  ///< newest reading before the probe
    bool sawProbing_ = false;
};

}  // namespace terratact
