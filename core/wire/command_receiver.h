#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/limits.h"
#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"

namespace terratact {

/// The robot's verdict on a received frame.
enum class CommandVerdict : std::uint8_t {
    Accepted,
    Heartbeat,    ///< valid ConsoleHeartbeat: answer its token
    NotACommand,  ///< a frame of another protocol, or of a robot
    Malformed,
    Repeated,       ///< its counter did not change
    WrongSequence,  ///< more than two frames of its kind are missing, or it is an old one
    WrongEpoch,     ///< from an earlier arming: the frame was delayed
    TooLate,        ///< its challenge is missing, too old, or from before a halt
    NotArmed,
    NoHeartbeat,  ///< arming without a second of heartbeats before it
};

/// The robot's end of the protocol: it checks integrity, order, epoch, freshness and arming of a
/// console's commands. The robot itself decides whether it can carry them out. Safe commands (Stop,
/// Halt, AbortAtem, disarming) are accepted from any epoch and in any order, Stop even damaged.
///
/// Freshness is a challenge-response protocol. Each answer to a heartbeat carries a number, the
/// challenge. Every other command must carry a challenge that the robot gave out at most
/// kChallengeLife ago. Safe commands, arming, and a drive ended by the dead-man void all earlier
/// challenges. No command from before a halt is therefore obeyed after it, however late, often or
/// out of order it comes. A number is used again only after 65 534 others, each for at least
/// kChallengePeriod: 54 minutes.
///
/// It has no clock: `now` is monotonic time [s].
class CommandReceiver {
public:
    /// watchdog: [s] without a heartbeat that disarm
    static constexpr double kHeartbeatLimit = kLinkLostAfter;
    /// dead-man: [s] without a Drive frame that end a drive
    static constexpr double kDriveLimit = kLinkLostAfter;
    static constexpr double kChallengeLife = 0.5;  ///< [s] age at which a challenge is void
    /// [s] for which the same challenge is given out
    static constexpr double kChallengePeriod = 0.05;

    struct Answer {
        CommandVerdict verdict = CommandVerdict::NotACommand;
        std::optional<Command> command{};      ///< set with Accepted
        std::optional<std::uint16_t> token{};  ///< set with Heartbeat
        std::uint16_t challenge = 0;           ///< set with Heartbeat: to be sent with the token
        std::optional<FrameKind> kind{};  ///< kind of any command, accepted or not, for RobotStatus
        std::uint8_t counter = 0;         ///< counter of that frame
    };

    /// firstEpoch, firstChallenge: random at every boot, so that frames from before the boot do not
    /// fit. Throws std::invalid_argument for 0, which no frame may carry.
    explicit CommandReceiver(std::uint8_t firstEpoch, std::uint16_t firstChallenge = 1);

    Answer receive(const CanFrame& frame, double now);

    enum class Silence : std::uint8_t {
        None,
        OfDrive,    ///< dead-man: a driving robot must halt
        OfConsole,  ///< watchdog: disarmed; the robot must halt, whatever it does
    };
    /// Returns the timeout since the last call. Call it at least every 50 ms. A robot must
    /// halt by it, as the simulated one does in RobotOnBus::haltForSilence().
    Silence tick(double now);

    /// Disarms for the robot's own reasons. Begins a new epoch.
    void disarm();

    bool armed() const { return armed_; }
    std::uint8_t epoch() const { return epoch_; }
    /// Returns the next challenge, which no answer has carried yet.
    std::uint16_t nextChallenge() const { return nextChallenge_; }

private:
    struct Challenge {
        std::uint16_t number = 0;
        double given = 0.0;  ///< [s]
    };
    std::uint16_t give(double now);
    bool isFresh(std::optional<std::uint16_t> challenge, double now) const;
    void forget();
    Answer judge(const Unpacked& content, const ReceivedCommand& received, double now);
    Answer heartbeat(const CanFrame& frame, const Unpacked& content, double now);
    std::optional<CommandVerdict> refusalOf(FrameKind kind, const ReceivedCommand& received,
                                            double now);
    std::optional<CommandVerdict> outOfOrder(const Unpacked& content);
    void obey(const Command& command, double now);

    std::uint8_t epoch_;
    bool armed_ = false;
    E2eReceiver heartbeat_;
    std::array<std::optional<std::uint8_t>, kFrameKinds> counters_{};  ///< counters since forget()
    std::vector<Challenge> challenges_;  ///< since forget(), oldest first
    std::uint16_t nextChallenge_;
    std::optional<double> lastDrive_;  ///< time of the last Drive frame while driving [s]
};

}  // namespace terratact
