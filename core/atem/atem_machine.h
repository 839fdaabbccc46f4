#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/atem/loop_end.h"
#include "core/base/message.h"
#include "core/limits.h"

namespace terratact {

/// Algorithm 1 of the paper as named states. Every fault and refusal leads to a named state.
///
///                 requested        halted          pressed           estimateReady, probeWanted
///   Idle ───────────────▶ Halting ──────▶ Pressing ──────▶ Estimating ─────────────▶ ProposingProbe
///    ▲                                                         │ estimateReady         │ approved
///    │ poseChanged                                             ▼   refused, time's up  ▼
///   (drove on) ◀──────────────────────────────────────── Presenting ◀──┘            Probing
///                                                              ▲ estimateReady        │ probeDone
///                                                              └── EstimatingAgain ◀──┘
///   any state: stop ▶ Stopped, stopReleased ▶ Idle.   any but Stopped: aborted ▶ Idle.
///   while exploring: a lost link, a disarmed robot, an unsent command, a time limit, a refusal, an error,
///   a moved robot ▶ Failed.
///   an approval whose grounds have changed ▶ Failed.
///   Presenting and Failed: requested ▶ Halting.
///
/// Feel forward is the same as a loop, while the operator holds a control (dead-man):
///
///   Idle, Presenting, Failed ── loopRequested, held ──▶ Halting, Pressing, Estimating, Presenting
///        Presenting ── nothing forbids it ──▶ Advancing ── advanced ──▶ Halting …
///   A result that forbids the advance, or a proposed probe, ends the loop. The exploration goes on.
///   Released: Halting, Pressing and Advancing ▶ Idle. Elsewhere nothing moves, and only the loop ends.
///   Each end of the loop has a reason: AtemState::loopEnd.
enum class AtemPhase : std::uint8_t {
    Idle,             ///< nothing requested
    Halting,          ///< the robot is stopping
    Pressing,         ///< front flippers press down until the torque threshold
    Estimating,       ///< the scene is captured, the first reconstruction runs
    ProposingProbe,   ///< some sd exceeds the probe threshold: the operator decides
    Probing,          ///< the arm moves, for about 45 s
    EstimatingAgain,  ///< reconstruction with the arm's reading
    Presenting,       ///< the result is shown; the operator may drive on or ask again
    Stopped,          ///< STOP was pressed
    Failed,           ///< see AtemState::failure
    Advancing,        ///< feel forward: the robot drives a short way, then halts
};

/// Reason why an exploration ended in Failed.
enum class AtemFailure : std::uint8_t {
    None,
    HaltTimeout,
    PressTimeout,
    EstimateTimeout,
    EstimateError,
    ProbeTimeout,
    ProbeRefused,
    PressRefused,
    LinkLost,
    PoseChanged,
    ApprovalVoid,  ///< given for another scene, other settings or another model
    Disarmed,
    AdvanceTimeout,
    AdvanceRefused,
    NotMoved,  ///< the tracks moved less than commanded
    RanOn,     ///< the tracks moved further than commanded
    NotSent,   ///< a command could not leave, so the robot was never asked
    BeginTimeout,
};

struct AtemState {
    AtemPhase phase = AtemPhase::Idle;
    AtemFailure failure = AtemFailure::None;  ///< not None only in Failed
    double since = 0.0;                       ///< time at which the phase began [s]
    bool probed = false;                      ///< the arm has measured in this exploration
    /// Approval expiry: the last proposal got no answer in time, which means no.
    bool approvalExpired = false;
    bool followed = false;  ///< another console commands the robot, see core/atem/following.h
    bool loops = false;     ///< feel forward: the robot goes on by itself
    /// Reason why the last feel forward ended; None: it goes on, or was never requested.
    LoopEnd loopEnd = LoopEnd::None;
    bool operator==(const AtemState&) const = default;
};

/// Events since the last tick.
struct AtemInput {
    double now = 0.0;           ///< [s] any monotonic clock
    bool requested = false;     ///< the operator asked for an exploration
    bool aborted = false;       ///< the operator ended it
    bool stop = false;          ///< STOP is pressed
    bool stopReleased = false;  ///< the operator released STOP
    bool approved = false;      ///< operator approved the proposed probe
    double approvalAge = 0.0;   ///< [s] with approved: age of the approval
    std::string approvedFor{};  ///< with approved: fingerprint of its grounds
    std::string
        grounds{};  ///< fingerprint of the present grounds, see core/atem/probe/probe_grounds.h
    bool refused = false;  ///< the operator refused the probe
    bool linkAlive = true;
    bool armed = true;     ///< the robot accepts motion commands from this console
    bool notSent = false;  ///< the command of the present phase could not leave
    bool halted = false;   ///< the robot stands still, and has begun the exploration
    bool unbegun = false;  ///< the robot stands still, and has not begun it
    bool pressed = false;  ///< the torque threshold is reached and the scene is captured
    bool pressRefused = false;
    bool estimateReady = false;
    bool estimateFailed = false;
    /// With estimateReady: some sd in the arm's reach exceeds the probe threshold.
    bool probeWanted = false;
    bool probeDone = false;
    bool probeRefused = false;
    bool poseChanged = false;  ///< the robot moved since the scene was captured

    // Feel forward.
    bool loopRequested = false;  ///< the operator has begun to hold the control
    bool held = false;           ///< the operator holds it now
    /// Reason that forbids an advance at this pose, see whyNotAdvancing(); None: nothing does.
    LoopEnd forbids = LoopEnd::NoVerdict;
    bool telemetryFresh = true;
    bool advanced = false;        ///< the robot has moved as commanded, and stands still
    bool advanceRefused = false;  ///< by the robot
    bool notMoved = false;
    bool ranOn = false;
    bool tilted = false;      ///< pitch or roll is beyond its limit
    bool noOdometry = false;  ///< the odometry is missing
};

/// Time limits [s].
struct AtemLimits {
    double halt = 3.0;
    double press = 15.0;
    double estimate = 30.0;
    double approval = kApprovalExpiry;
    double probe = 90.0;
    double advance = 10.0;
};

/// Computes one tick of Algorithm 1 with faults and time limits. It has no clock, no I/O and no
/// threads. Priorities within a tick: stop, abort, faults, success, time limit. A late approval
/// counts as a refusal, and so does an approval together with a refusal. Letting go comes after abort.
/// Throws
/// std::invalid_argument unless in.now is finite.
AtemState nextState(const AtemState& now, const AtemInput& in, const AtemLimits& limits);

/// Returns the time at which the current phase expires [s on the input's clock]; empty if it does
/// not.
std::optional<double> deadline(const AtemState& state, const AtemLimits& limits);

/// Returns true from Halting to EstimatingAgain, and in Advancing: the robot is busy.
bool exploring(AtemPhase phase);

/// Return a text for the operator.
SourceText describe(AtemPhase phase);
SourceText describe(AtemFailure failure);

/// Return the names that a session file holds, and the values of these names.
std::string_view name(AtemPhase phase);
std::string_view name(AtemFailure failure);
std::optional<AtemPhase> atemPhaseFromName(std::string_view text);
std::optional<AtemFailure> atemFailureFromName(std::string_view text);

}  // namespace terratact
