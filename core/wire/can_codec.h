#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/robot/command.h"
#include "core/robot/measurement.h"
#include "core/wire/can_frame.h"
#include "core/wire/frame_layout.h"

namespace terratact {

// Packs values into CAN frames and unpacks them, as in resources/dbc/terratact.dbc. Values are
// physical, in SI units; the nearest raw value is sent. Encoding a value that does not fit (out of
// range, NaN, invalid enumerator) throws std::invalid_argument.

/// Reason why a frame does not belong to this protocol.
enum class FrameFault : std::uint8_t {
    UnknownId,
    NotClassicData,  ///< extended, remote, error or FD: never valid, even with a known identifier
    WrongLength,
    WrongCrc,
    ReservedBits,  ///< a bit without a signal is set
    OutOfRange,
};
inline constexpr int kFrameFaults = 6;
std::string describe(FrameFault fault);

/// A valid frame. values: in the order of the layout's signals; the rest is 0.
struct Unpacked {
    FrameKind kind = FrameKind::Stop;
    std::uint8_t counter = 0;
    std::array<double, kMaxSignals> values{};
    bool operator==(const Unpacked&) const = default;
};

/// Packs a frame. Throws std::invalid_argument if a value does not fit, or has no place in the
/// frame.
CanFrame pack(const Unpacked& content);

/// Unpacks a frame that is valid in every bit; E2eReceiver judges its counter.
std::variant<Unpacked, FrameFault> unpack(const CanFrame& frame);

/// Returns which signals of a frame hold a value, in the order of its layout. If Measured is 0, it is
/// the only one. A current whose LeftMissing or RightMissing is 1 holds none.
std::bitset<kMaxSignals> measuredSignals(const Unpacked& content);

/// Returns true if a robot must stop on this frame: any standard frame with the identifier of Stop,
/// however damaged.
bool meansStop(const CanFrame& frame);

// Commands.

/// Packs a command. epoch: as announced by the robot; unused in Stop and HoldFlippers, which have
/// none. challenge: from the robot's newest answer, 0: none; unused in safe commands, except for
/// Arm.
CanFrame frameOf(const Command& command, std::uint8_t epoch, std::uint8_t counter,
                 std::uint16_t challenge = 0);

/// Returns the kind of frame that carries a command.
FrameKind kindOf(const Command& command);

struct ReceivedCommand {
    Command command;
    std::optional<std::uint8_t> epoch{};       ///< from frames that carry one
    std::optional<std::uint16_t> challenge{};  ///< from frames that carry one; a robot never uses 0
};
/// Returns the command of a frame; empty if it holds none (heartbeat, telemetry).
std::optional<ReceivedCommand> commandOf(const Unpacked& content);

// Heartbeats.

CanFrame consoleHeartbeat(std::uint16_t token, std::uint8_t counter);
CanFrame robotHeartbeat(std::uint16_t token, std::uint8_t counter, std::uint16_t challenge = 0);
/// Returns the token of a heartbeat; empty for another frame.
std::optional<std::uint16_t> tokenOf(const Unpacked& content);
/// Returns the challenge of a RobotHeartbeat or a command; empty for a frame without one.
std::optional<std::uint16_t> challengeOf(const Unpacked& content);

// Telemetry.

struct RobotStatus {
    std::uint8_t epoch = 1;  ///< never 0
    RobotActivity activity = RobotActivity::Halted;
    Refusal refusal = Refusal::None;  ///< reason for refusing the last command
    bool armed = false;
    bool exploring = false;
    std::optional<FrameKind> lastCommand{};  ///< last command, obeyed or refused; empty: none yet
    std::uint8_t lastCounter = 0;            ///< counter of that command's frame
    bool operator==(const RobotStatus&) const = default;
};
CanFrame frameOf(const RobotStatus& status, std::uint8_t counter);
/// Returns the status; empty if the frame is no RobotStatus, or names a last command that is no
/// console frame.
std::optional<RobotStatus> statusOf(const Unpacked& content);

/// Values of the left and right side.
struct Pair {
    double left = 0.0, right = 0.0;
    bool operator==(const Pair&) const = default;
};

/// Currents of the motors of an axle [A], positive = pressing down; an empty optional was not
/// measured.
struct AxleCurrents {
    std::optional<double> left{}, right{};
    bool operator==(const AxleCurrents&) const = default;
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
    std::optional<Pair> frontAngles, rearAngles;  ///< [rad] tip up positive, within half a turn
    AxleCurrents frontCurrents, rearCurrents;
    /// Voltages on the reference resistors [V]: left 1–3, left 4–6, right 1–3, right 4–6, front
    /// flippers before rear ones.
    std::array<std::optional<Three>, 8> voltages;
    std::optional<ArmReading> arm;
    std::optional<double> differential;  ///< [rad] left track nose up, within half a turn
    bool operator==(const SensorLine&) const = default;
};

/// Frames of a line that only some robots send, after those of every robot.
struct LineExtent {
    bool rearForces = false;    ///< RearLeftForces1To3 to RearRightForces4To6
    bool differential = false;  ///< Differential
};

/// Returns all frames of one line with the same counter: Odometry, Attitude to ArmResult, and those of
/// the extent.
std::vector<CanFrame> framesOf(const SensorLine& line, std::uint8_t counter,
                               const LineExtent& extent = {});

/// Joins frames of one counter to a line. Without one of its frames there is no line; if that lasts,
/// telemetry becomes stale after kStaleAfter.
class SensorLineReader {
public:
    explicit SensorLineReader(const LineExtent& extent = {});

    /// Adds a frame. Returns the line that it completes. A frame with another counter drops the
    /// unfinished line. A repeated frame replaces the first one; other kinds of frames are ignored,
    /// and so are those beyond the extent. A line needs every frame of its extent except Odometry,
    /// which some robots do not send. Odometry belongs to the line if it comes before the last frame.
    std::optional<SensorLine> add(const Unpacked& content);

    std::uint64_t unfinished() const { return unfinished_; }  ///< number of dropped lines

private:
    struct CountedOdometry {
        std::uint8_t counter = 0;
        std::optional<SensorLine::Odometry> odometry;
    };

    SensorLine line_;
    std::optional<CountedOdometry> odometry_;  ///< newest since the last line
    std::uint8_t counter_ = 0;
    std::uint32_t needed_;  ///< one bit per frame
    std::uint32_t have_ = 0;
    std::uint64_t unfinished_ = 0;
};

}  // namespace terratact
