#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/limits.h"

namespace terratact {

/// Algorithm 1 of the paper as named states.  Faults and refusals end in a named state, never in silence.
///
///                 requested        halted          pressed           estimateReady, probeWanted
///   Idle ───────────────▶ Halting ──────▶ Pressing ──────▶ Estimating ─────────────▶ ProposingProbe
///    ▲                                                         │ estimateReady         │ approved
///    │ poseChanged                                             ▼   refused, time's up  ▼
///   (drove on) ◀──────────────────────────────────────── Presenting ◀──┘            Probing
///                                                              ▲ estimateReady        │ probeDone
///                                                              └── EstimatingAgain ◀──┘
///   any state: stop ▶ Stopped, stopReleased ▶ Idle.   any but Stopped: aborted ▶ Idle.
///   while exploring: a lost link, a disarmed robot, a time limit, a refusal, an error, a moved robot ▶ Failed.
///   an approval that is not of what stands ▶ Failed.
///   Presenting and Failed: requested ▶ Halting.
enum class AtemPhase : std::uint8_t {
    Idle,             ///< nothing requested
    Halting,          ///< robot told to stop driving
    Pressing,         ///< front flippers go down until the torque threshold
    Estimating,       ///< scene captured, first reconstruction runs
    ProposingProbe,   ///< some sd above the limit: the operator decides
    Probing,          ///< arm on its way, about 45 s
    EstimatingAgain,  ///< reconstruction with the arm's height
    Presenting,       ///< result stands; the operator may drive on or ask again
    Stopped,          ///< STOP was pressed
    Failed,           ///< see AtemState::failure
};

/// Why an exploration ended in Failed.
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
};

struct AtemState {
    AtemPhase phase = AtemPhase::Idle;
    AtemFailure failure = AtemFailure::None;  ///< other than None exactly in Failed
    double since = 0.0;                       ///< [s] when the phase began
    bool probed = false;                      ///< the arm has measured in this exploration
    bool approvalExpired = false;  ///< the last proposal was not answered in time, which means no
    bool followed = false;  ///< the robot does it for somebody else, see core/atem/following.h
    bool operator==(const AtemState&) const = default;
};

/// What happened since the last tick.
struct AtemInput {
    double now = 0.0;           ///< [s] any monotonic clock
    bool requested = false;     ///< operator asked for ATEM
    bool aborted = false;       ///< operator ended it
    bool stop = false;          ///< STOP is pressed
    bool stopReleased = false;  ///< the operator released STOP
    bool approved = false;      ///< operator approved the proposed probe
    double approvalAge = 0.0;   ///< [s] with approved: since the operator said so
    std::string approvedFor{};  ///< with approved: fingerprint of what it was said of
    std::string grounds{};      ///< fingerprint of what stands now, see core/atem/probe_grounds.h
    bool refused = false;       ///< operator refused it
    bool linkAlive = true;
    bool armed = true;     ///< the robot takes motion commands from here
    bool halted = false;   ///< robot stands still
    bool pressed = false;  ///< torque threshold reached, scene captured
    bool pressRefused = false;
    bool estimateReady = false;
    bool estimateFailed = false;
    bool probeWanted = false;  ///< with estimateReady: some sd above the limit in reach of the arm
    bool probeDone = false;
    bool probeRefused = false;
    bool poseChanged = false;  ///< robot moved since the scene was captured
};

/// Time limits [s].
struct AtemLimits {
    double halt = 3.0;
    double press = 15.0;
    double estimate = 30.0;
    double approval = kApprovalExpiry;
    double probe = 90.0;
};

/// One tick, no clock, no I/O, no threads: Algorithm 1 plus faults and time limits.  Within a tick stop
/// outranks abort, abort outranks faults, a fault outranks success, a late success outranks the time
/// limit; only a late approval counts as no, and so does an approval together with a refusal.
/// Throws std::invalid_argument unless in.now is finite.
AtemState nextState(const AtemState& now, const AtemInput& in, const AtemLimits& limits);

/// When the current phase runs out [s on the input's clock]; empty where it does not.
std::optional<double> deadline(const AtemState& state, const AtemLimits& limits);

/// From Halting to EstimatingAgain: the robot is busy with an exploration.
bool exploring(AtemPhase phase);

/// The robot may be driven by hand: nothing is explored and STOP is not latched.
bool mayDrive(AtemPhase phase);

/// In words for the operator.
std::string describe(AtemPhase phase);
std::string describe(AtemFailure failure);

}  // namespace terratact
