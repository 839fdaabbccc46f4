#pragma once

#include <array>
#include <cstdint>
#include <optional>

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
    NotArmed,
    NoHeartbeat,  ///< arming without a console that has been alive for a second
};

/// The robot's end of the protocol: integrity, order, epoch and arming of what a console sends; whether the
/// robot can and will do it is for the robot to say.  What makes safe (Stop, Halt, AbortAtem, disarming) is
/// taken from any epoch and in any order, Stop even damaged.  No clock: `now` is monotonic time [s].
class CommandReceiver {
public:
    static constexpr double kHeartbeatLimit = 0.25;  ///< [s] without one disarm
    static constexpr double kDriveLimit = 0.25;      ///< [s] without one end a drive

    struct Answer {
        CommandVerdict verdict = CommandVerdict::NotACommand;
        std::optional<Command> command{};      ///< Accepted
        std::optional<std::uint16_t> token{};  ///< Heartbeat
        std::optional<FrameKind> kind{};       ///< of any command, accepted or not, for RobotStatus
        std::uint8_t counter = 0;              ///< of that frame
    };

    /// firstEpoch: drawn anew at every boot, so that frames of the life before do not fit.
    /// Throws std::invalid_argument for 0, which no frame may carry.
    explicit CommandReceiver(std::uint8_t firstEpoch);

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

private:
    Answer judge(const Unpacked& content, const ReceivedCommand& received, double now);
    Answer heartbeat(const CanFrame& frame, const Unpacked& content, double now);
    std::optional<CommandVerdict> refusalOf(FrameKind kind, const ReceivedCommand& received,
                                            double now);
    std::optional<CommandVerdict> outOfOrder(const Unpacked& content);
    void obey(const Command& command, double now);

    std::uint8_t epoch_;
    bool armed_ = false;
    E2eReceiver heartbeat_;
    std::array<std::optional<std::uint8_t>, kFrameKinds> counters_{};  ///< of this epoch
    std::optional<double> lastDrive_;                                  ///< while driving [s]
};

}  // namespace terratact
