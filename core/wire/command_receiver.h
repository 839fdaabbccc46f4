#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/limits.h"
#include "core/wire/can_codec.h"
#include "core/wire/e2e.h"

namespace terratact {

/// What a robot's end of the link makes of a frame.
enum class CommandVerdict : std::uint8_t {
    Accepted,
    Heartbeat,    ///< a sound ConsoleHeartbeat: answer its token
    NotACommand,  ///< somebody else's frame, or a robot's
    Malformed,
    Repeated,       ///< the counter of its kind stood still
    WrongSequence,  ///< over two of its kind are missing, or it is an old one
    WrongEpoch,     ///< of an earlier arming: a frame that waited somewhere
    TooLate,        ///< its challenge is none, too old, or from before a halt
    NotArmed,
    NoHeartbeat,  ///< arming without a console that has been alive for a second
};

/// The robot's end of the protocol: integrity, order, epoch, freshness and arming of what a console sends;
/// whether the robot can and will do it is for the robot to say.  What makes safe (Stop, Halt, AbortAtem,
/// disarming) is taken from any epoch and in any order, Stop even damaged.
///
/// Freshness is challenge and response: each answer to a heartbeat carries a number, the challenge, and every
/// other command must carry one that the robot gave out at most kChallengeLife ago.  What makes safe, arming,
/// and a drive that ran out void all challenges given out before.  So no command that was sent before a halt
/// is obeyed after it, however late, often or out of order it comes.  A number is given out again only after
/// 65 534 others, of which each takes at least kChallengePeriod: 54 minutes.
///
/// No clock: `now` is monotonic time [s].
class CommandReceiver {
public:
    static constexpr double kHeartbeatLimit = kLinkLostAfter;  ///< [s] without one disarm
    static constexpr double kDriveLimit = kLinkLostAfter;      ///< [s] without one end a drive
    static constexpr double kChallengeLife = 0.5;              ///< [s] so old a challenge is void
    static constexpr double kChallengePeriod = 0.05;           ///< [s] it is given out again within

    struct Answer {
        CommandVerdict verdict = CommandVerdict::NotACommand;
        std::optional<Command> command{};      ///< Accepted
        std::optional<std::uint16_t> token{};  ///< Heartbeat
        std::uint16_t challenge = 0;           ///< Heartbeat: to send beside the token
        std::optional<FrameKind> kind{};       ///< of any command, accepted or not, for RobotStatus
        std::uint8_t counter = 0;              ///< of that frame
    };

    /// firstEpoch, firstChallenge: drawn anew at every boot, so that frames of the life before do not fit.
    /// Throws std::invalid_argument for 0, which no frame may carry.
    explicit CommandReceiver(std::uint8_t firstEpoch, std::uint16_t firstChallenge = 1);

    Answer receive(const CanFrame& frame, double now);

    enum class Silence : std::uint8_t {
        None,
        OfDrive,    ///< a robot that drives must halt
        OfConsole,  ///< disarmed: the robot must halt, whatever it is doing
    };
    /// Who has fallen silent since the last call.  To be called at least every 50 ms.
    Silence tick(double now);

    /// For the robot's own reasons.  Begins a new epoch.
    void disarm();

    bool armed() const { return armed_; }
    std::uint8_t epoch() const { return epoch_; }
    std::uint16_t nextChallenge() const
    {
        return nextChallenge_;
    }  ///< that no answer has carried yet

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
    std::array<std::optional<std::uint8_t>, kFrameKinds> counters_{};  ///< since forget()
    std::vector<Challenge> challenges_;  ///< since forget(), from the oldest to the newest
    std::uint16_t nextChallenge_;
    std::optional<double> lastDrive_;  ///< while driving [s]
};

}  // namespace terratact
