#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <variant>
#include <vector>

#include "core/atem/arming.h"
#include "core/atem/command_gate.h"
#include "core/limits.h"
#include "core/robot/robot_model.h"
#include "core/wire/freshness.h"
#include "core/wire/telemetry_listener.h"

namespace terratact {

/// State of the link for display.
struct LinkView {
    LinkState state = LinkState::Unknown;
    std::optional<double> statusAge, answerAge;  ///< [s]
    double goodFor = 0.0;                        ///< see ArmingInput::linkGoodFor [s]
    bool foreignSender = false;
    ArmingState arming;
    std::optional<RobotStatus> robot;
    bool moves = true;  ///< see ConsoleLink::moves()
};

/// Console's end of the link. It receives the robot's frames and arms. It sends heartbeats for the
/// robot's watchdog and repeats a drive for its dead-man. It sends nothing that the command gate
/// refuses. It has no clock and no bus. `now` is any monotonic clock [s]. The caller must send the
/// returned frames at once.
class ConsoleLink {
public:
    static constexpr double kHeartbeatPeriod = 0.1;  ///< [s] between heartbeats
    static constexpr double kDrivePeriod = 0.02;     ///< [s] between repeated Drive frames
    /// [s] between Disarm frames to a robot that should not be armed.
    static constexpr double kDisarmPeriod = 0.1;
    /// [s] longest wait of a command for a challenge
    static constexpr double kWaits = kLinkLostAfter;
    static constexpr double kForeignFor = 5.0;  ///< [s] for which a foreign sender is remembered
    /// [s] after which the robot's status shows a motion.
    static constexpr double kMotionShows = 0.5;

    struct Options {
        GateLimits gate{};
        ArmingLimits arming{};
        std::uint64_t seed = 1;  ///< seed of the tokens: must be new at every start
    };
    ConsoleLink(RobotModel robot, const Options& options);

    /// Receives a frame from the bus; `echo`: this console sent it. Returns the measurement that it
    /// completes.
    std::optional<Measurement> receive(const CanFrame& frame, bool echo, double now);

    /// Reports that window and panel have both responded now. After 0.1 s without a report a drive is
    /// halted. The robot is also disarmed if anything moves or was commanded to move. A latched STOP
    /// and an unknown status count as moving. Otherwise only commands are refused, for up to 1 s:
    /// heartbeats continue, and the robot stays armed.
    void operatorAlive(double now);

    // Actions of the operator, see core/atem/arming.h; they take effect at the next tick.
    void wantArming() { wanted_ = true; }
    void confirmArming() { confirmed_ = true; }
    void disarm() { disarmed_ = true; }

    /// Approves one probe at `now`. The approval ends with the next probe, halt, stop or abort.
    void approve(const ProbeCommand& probe, double now);

    /// Result of send(): the command waits for a new challenge. An earlier safe command made the
    /// robot void the old one. tick() sends the command with the next answer. It is dropped if
    /// another command comes, or if no answer comes within kWaits.
    struct Waits {};

    /// Returns the frame of a command, or the reason of a refusal. tick() repeats a drive until
    /// another command comes. Stop stays latched until ReleaseStop is sent, or is refused because a
    /// robot over a good link is not stopped. send() never arms; wantArming() does.
    std::variant<CanFrame, GateRefusal, Waits> send(const Command& command, double now);

    /// Returns the frames that are due. Must be called at least every 20 ms.
    std::vector<CanFrame> tick(double now);

    LinkView view(double now) const;
    const TelemetryListener& telemetry() const { return listener_; }
    bool stopLatched() const { return stopLatched_; }

private:
    GateView gateView(double now) const;
    /// Returns true if the robot moves as far as is known. A robot whose operator stopped
    /// responding counts as moving.
    bool moves(double now) const;
    bool linkGood(double now) const;
    bool foreignSender(double now) const;
    std::optional<CanFrame> passed(const Command& command, double now);
    GateRefusal refusalOf(const Command& command, std::uint16_t challenge, double now) const;
    CanFrame frameOfNext(const Command& command, std::uint16_t challenge) const;
    void left(const Command& command, double now);
    void sendWaiting(double now, std::vector<CanFrame>& out);
    void arm(double now, std::vector<CanFrame>& out);
    void disarmRobot(double now, std::vector<CanFrame>& out);
    void beat(double now, std::vector<CanFrame>& out);
    void keepDriving(double now, std::vector<CanFrame>& out);

    TelemetryListener listener_;
    Options options_;
    std::mt19937_64 rng_;
    Freshness freshness_;
    ArmingState arming_;
    bool wanted_ = false, confirmed_ = false, disarmed_ = false;
    bool stopLatched_ = false;
    /// This console asked to arm, and the robot has not reported "not armed" since.
    bool owesDisarm_ = false;
    /// From the newest answer; 0: none since the robot voided the last one.
    std::uint16_t challenge_ = 0;
    std::optional<double> disarmSent_;
    std::optional<double> operatorSeen_, foreignSeen_, goodSince_, lastBeat_, motionSent_;
    struct Approved {
        ProbeCommand probe;
        double at;
    };
    std::optional<Approved> approved_;
    struct Driving {
        DriveCommand command;
        double sent;
    };
    std::optional<Driving> driving_;
    struct Waiting {
        Command command;
        double since;
    };
    std::optional<Waiting> waiting_;
    std::array<std::uint8_t, kFrameKinds> counters_{};
};

}  // namespace terratact
