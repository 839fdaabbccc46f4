#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_layout.h"

namespace terratact {

// Frames <-> numbers, as resources/dbc/terratact.dbc has it.  Numbers are physical values in SI units; a
// value is sent as the nearest raw one.  Whoever encodes what does not fit (beyond its range, NaN, a wrong
// enumerator) gets std::invalid_argument.

/// Why a frame is not one of ours.
enum class FrameFault : std::uint8_t {
    UnknownId,
    NotClassicData,  ///< extended, remote, error or FD: never ours, even with an identifier of ours
    WrongLength,
    WrongCrc,
    ReservedBits,  ///< a bit is set that no signal names
    OutOfRange,
};
inline constexpr int kFrameFaults = 6;
std::string describe(FrameFault fault);

/// A sound frame.  values: of the layout's signals, in its order; the rest is 0.
struct Unpacked {
    FrameKind kind = FrameKind::Stop;
    std::uint8_t counter = 0;
    std::array<double, kMaxSignals> values{};
    bool operator==(const Unpacked&) const = default;
};

/// Throws std::invalid_argument where a value does not fit, or one is given that the frame has no place for.
CanFrame pack(const Unpacked& content);

/// The content of a frame that is ours in every bit; counters are for E2eReceiver to judge.
std::variant<Unpacked, FrameFault> unpack(const CanFrame& frame);

/// Whether a robot must stop on it: any standard frame with the identifier of Stop, however damaged.
bool meansStop(const CanFrame& frame);

// Commands.

/// epoch: as announced by the robot; without meaning in a Stop, which has none, as HoldFlippers has not.
/// challenge: of the robot's newest answer, 0 for none; without meaning in what makes safe, but for Arm.
CanFrame frameOf(const Command& command, std::uint8_t epoch, std::uint8_t counter,
                 std::uint16_t challenge = 0);

/// The kind of frame a command travels in.
FrameKind kindOf(const Command& command);

struct ReceivedCommand {
    Command command;
    std::optional<std::uint8_t> epoch{};       ///< of the frames that carry one
    std::optional<std::uint16_t> challenge{};  ///< likewise; 0 is no robot's
};
/// Empty where the frame holds no command (a heartbeat, telemetry).
std::optional<ReceivedCommand> commandOf(const Unpacked& content);

// Heartbeats.

CanFrame consoleHeartbeat(std::uint16_t token, std::uint8_t counter);
CanFrame robotHeartbeat(std::uint16_t token, std::uint8_t counter, std::uint16_t challenge = 0);
/// Empty where the frame is no heartbeat.
std::optional<std::uint16_t> tokenOf(const Unpacked& content);
/// Of a RobotHeartbeat or a command; empty where the frame has no such signal.
std::optional<std::uint16_t> challengeOf(const Unpacked& content);

// Telemetry.

struct RobotStatus {
    std::uint8_t epoch = 1;  ///< never 0
    RobotActivity activity = RobotActivity::Halted;
    Refusal refusal = Refusal::None;  ///< of the last command
    bool armed = false;
    bool exploring = false;
    std::optional<FrameKind> lastCommand{};  ///< obeyed or refused; empty before the first
    std::uint8_t lastCounter = 0;            ///< of that command's frame
    bool operator==(const RobotStatus&) const = default;
};
CanFrame frameOf(const RobotStatus& status, std::uint8_t counter);
/// Empty where the frame is no RobotStatus, or names no frame of the console as the last command.
std::optional<RobotStatus> statusOf(const Unpacked& content);

/// Left and right.
struct Pair {
    double left = 0.0, right = 0.0;
    bool operator==(const Pair&) const = default;
};

/// One line of a robot's sensors; an empty optional was not measured.
struct SensorLine {
    struct Attitude {
        double pitch = 0.0, roll = 0.0;  ///< [rad]
        bool operator==(const Attitude&) const = default;
    };
    using Three = std::array<double, 3>;
    struct Odometry {
        double travelled = 0.0;  ///< [m] along the tracks, forward positive
        double turned = 0.0;     ///< [rad] left positive, within half a turn
        bool operator==(const Odometry&) const = default;
    };
    std::optional<Odometry> odometry;
    std::optional<Attitude> attitude;
    std::optional<Pair> frontAngles, rearAngles;      ///< [rad] tip up positive, within half a turn
    std::optional<Pair> frontCurrents, rearCurrents;  ///< [A] positive = pressing down
    /// Voltages on the reference resistors [V]: left 1–3, left 4–6, right 1–3, right 4–6.
    std::array<std::optional<Three>, 4> voltages;
    std::optional<ArmReading> arm;
    bool operator==(const SensorLine&) const = default;
};

inline constexpr std::size_t kSensorFrames = 11;  ///< Odometry, and from Attitude to ArmResult

/// All frames of one line, with the same counter, Odometry first.
std::array<CanFrame, kSensorFrames> framesOf(const SensorLine& line, std::uint8_t counter);

/// Joins frames of one counter to a line.
class SensorLineReader {
public:
    /// The line that this frame completes.  Frames of another counter drop what is unfinished; a frame that
    /// comes twice replaces the first; frames of other kinds are ignored.  A line needs every frame but
    /// Odometry, which not every robot sends: it belongs to the line when it comes before the last of them.
    std::optional<SensorLine> take(const Unpacked& content);

    std::uint64_t unfinished() const { return unfinished_; }  ///< lines dropped

private:
    struct CountedOdometry {
        std::uint8_t counter = 0;
        std::optional<SensorLine::Odometry> odometry;
    };

    SensorLine line_;
    std::optional<CountedOdometry> odometry_;  ///< the newest since the last line
    std::uint8_t counter_ = 0;
    std::uint32_t have_ = 0;  ///< one bit per frame
    std::uint64_t unfinished_ = 0;
};

}  // namespace terratact
