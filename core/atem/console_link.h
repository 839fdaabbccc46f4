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

/// What a console shows of its link.
struct LinkView {
    LinkState state = LinkState::Unknown;
    std::optional<double> statusAge, answerAge;  ///< [s]
    double goodFor = 0.0;                        ///< [s] see ArmingInput
    bool foreignSender = false;
    ArmingState arming;
    std::optional<RobotStatus> robot;
};

/// The console's end of the link: takes the robot's frames, beats the heart, arms, repeats a drive as long
/// as it is wanted, and lets nothing out that the command gate refuses.  No clock and no bus: `now` is any
/// monotonic clock [s], and the frames it returns have to be sent at once.
class ConsoleLink {
public:
    static constexpr double kHeartbeatPeriod = 0.1;  ///< [s]
    static constexpr double kDrivePeriod = 0.02;     ///< [s]
    static constexpr double kDisarmPeriod =
        0.1;  ///< [s] to a robot that is armed and should not be
    static constexpr double kWaits = kLinkLostAfter;  ///< [s] at most, of a command for a challenge
    static constexpr double kForeignFor = 5.0;        ///< [s] a foreign sender is remembered
    static constexpr double kMotionShows =
        0.5;  ///< [s] after which the robot's status shows a motion

    struct Options {
        GateLimits gate{};
        ArmingLimits arming{};
        std::uint64_t seed = 1;  ///< of the tokens: drawn anew at every start
    };
    ConsoleLink(RobotModel robot, const Options& options);

    /// Takes a frame from the bus; `echo` is one that left from here.  The measurement it completes.
    std::optional<Measurement> receive(const CanFrame& frame, bool echo, double now);

    /// Window and panel have both answered just now.  Without an answer for 0.1 s a drive is halted, and the robot is
    /// disarmed where anything moves or was told to.  Where nothing does, only commands are refused, for up to 1 s:
    /// heartbeats go on, and the arming stands.
    void operatorAlive(double now);

    // The operator's actions, see core/atem/arming.h; they take effect at the next tick.
    void wantArming() { wanted_ = true; }
    void confirmArming() { confirmed_ = true; }
    void disarm() { disarmed_ = true; }

    /// The operator's word for one probe at `now`; it ends with the next probe, halt, stop or abort.
    void approve(int bin, double now);

    /// All that keeps a command from leaving is that the robot has voided its challenge, for what made safe before
    /// it.  It leaves in tick() with the next answer, unless another command comes, or none of kWaits.
    struct Waits {};

    /// The frame of a command, or why it may not leave.  A drive goes on in tick() until another command.
    /// Stop latches until ReleaseStop is sent, or refused because a robot over a good link is not stopped.
    /// Arming is not for here but for wantArming.
    std::variant<CanFrame, GateRefusal, Waits> send(const Command& command, double now);

    /// What is due; to be called at least every 20 ms.
    std::vector<CanFrame> tick(double now);

    LinkView view(double now) const;
    const TelemetryListener& telemetry() const { return listener_; }
    bool stopLatched() const { return stopLatched_; }

private:
    GateView gateView(double now) const;
    bool moves(double now)
        const;  ///< the robot, as far as is known; once nobody answered, it counts as moving
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
    bool owesDisarm_ =
        false;  ///< this console asked to arm, and the robot has not said since that it is not
    std::uint16_t challenge_ = 0;  ///< of the newest answer; 0: none since the robot voided them
    std::optional<double> disarmSent_;
    std::optional<double> operatorSeen_, foreignSeen_, goodSince_, lastBeat_, motionSent_;
    struct Approved {
        int bin;
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
