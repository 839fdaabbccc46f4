#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"

namespace terratact {

// CAN bus of a real Absolem (NIFTi, TRADR): 500 kbit/s, seven Elmo SimplIQ drives. They use the
// "binary interpreter" on PDO2 of CANopen, and the robot's computer polls them at 20 Hz. The bus is
// only read, never written.
//
// A request has identifier 0x300 + node, a reply 0x280 + node. It holds two letters of a command,
// its index and a type byte. A set or a reply also holds a little-endian int32 or float32. A drive
// sends its status word unasked with 0x180 + node. The start command has identifier 0.
//
// Sources: NIFTi-BlueBotics/Librover (nodes, counts, motors that are mounted mirrored) and Elmo's
// MAN-CAN301IG 2.1, chapter 9 (types, refusals). Assumptions to be checked on the robot:
//   – A motor's positive current turns its encoder towards positive counts. With the mirrored motors,
//     this decides which current presses down.
//   – The driver has set the encoders so that 0 is the lower edge flat. It does so at start-up, from a
//     potentiometer.
// Pitch, roll, forces and the arm are not on this bus: it alone cannot give a terrain estimate.

enum class AbsolemNode : std::uint8_t {
    Core = 1,
    RearRight,
    TrackRight,
    FrontRight,
    RearLeft,
    TrackLeft,
    FrontLeft,
};
inline constexpr std::size_t kAbsolemNodes = 7;
std::string describe(AbsolemNode node);

inline constexpr double kFlipperCounts = 6000.0;  ///< encoder counts per turn of a flipper

/// One decoded frame of the bus.
struct AbsolemFrame {
    enum class Kind : std::uint8_t { NetworkCommand, StatusWord, Query, Set, Reply };

    Kind kind = Kind::Query;
    /// Meaningless in a NetworkCommand, which addresses all nodes.
    AbsolemNode node = AbsolemNode::Core;
    std::array<char, 2> command{' ', ' '};  ///< upper-case letters
    std::uint16_t index = 0;
    bool isFloat = false;  ///< value of the type bit
    bool flagged = false;  ///< bit 6 of the type: in a Reply it mostly means that the drive refuses
    /// Value of a Set or Reply; first two bytes of a StatusWord or NetworkCommand.
    std::uint32_t bits = 0;

    std::string name() const;  ///< Returns "PX" or "IB[16]".
    std::int32_t asInt() const;
    float asFloat() const;
    bool operator==(const AbsolemFrame&) const = default;
};

/// Result of listening to a frame.
enum class AbsolemVerdict : std::uint8_t {
    Used,    ///< AbsolemState has a new value
    Passed,  ///< valid, but nothing that is kept
    // Frames that cannot be decoded:
    UnknownId,
    NotClassicData,  ///< extended, remote, error or FD frame
    WrongLength,
    NotACommand,  ///< does not begin with two letters
    // Replies that are not used:
    UnknownCommand,
    NotAsked,    ///< no request of the last 0.1 s has this header
    Refused,     ///< the drive refuses: `bits` is its error code (EC)
    WrongType,   ///< a float where counts or bits are expected
    OutOfRange,  ///< NaN, or beyond the range of motor or encoder
};
inline constexpr std::size_t kAbsolemVerdicts = 11;
std::string describe(AbsolemVerdict verdict);

/// Decodes the bytes. Returns a verdict from UnknownId to NotACommand if that is impossible.
std::variant<AbsolemFrame, AbsolemVerdict> absolemFrame(const CanFrame& frame);

/// A value and its time of arrival.
template <class T>
struct Dated {
    T value{};
    double time = 0.0;  ///< [s]
    bool operator==(const Dated&) const = default;
};

/// Values from the bus so far; an empty optional: none yet.
struct AbsolemState {
    struct Flipper {
        std::optional<Dated<double>> angle;    ///< [rad] tip up positive, within half a turn
        std::optional<Dated<double>> current;  ///< [A] positive = pressing down (an assumption)
        bool operator==(const Flipper&) const = default;
    };
    struct Drive {
        std::optional<Dated<std::uint16_t>> statusWord;
        std::optional<Dated<std::uint32_t>> statusRegister;  ///< SR
        std::optional<Dated<std::uint32_t>> motorFault;      ///< MF
        bool operator==(const Drive&) const = default;
    };
    Flipper frontLeft, frontRight, rearLeft, rearRight;
    std::array<Drive, kAbsolemNodes> drives;   ///< node 1 … 7
    std::optional<Dated<bool>> emergencyStop;  ///< IB[16]: the button is pressed
    bool operator==(const AbsolemState&) const = default;
};

/// Returns the sensor line that this bus provides: angles and currents that are at most `limit` [s]
/// old. An axle has angles if both are.
SensorLine sensorLineOf(const AbsolemState& state, double now, double limit);

/// Follows the requests of the robot's computer and the replies of its drives. It has no clock;
/// `now` [s] is any clock.
///
/// A reply counts if its header equals that of the last request to its node. Bit 6 of a reply's
/// type is a refusal with an error code of one byte (Elmo's manual). The robot's own library
/// ignores it. A drive may merely echo that bit of the request: a value that is no such code
/// reveals it.
class AbsolemListener {
public:
    struct Received {
        AbsolemVerdict verdict = AbsolemVerdict::Passed;
        std::optional<AbsolemFrame> frame{};  ///< empty if the bytes could not be decoded
    };
    using Counters = std::array<std::uint64_t, kAbsolemVerdicts>;  ///< indexed by AbsolemVerdict

    /// Throws std::invalid_argument unless `now` is finite.
    Received receive(const CanFrame& frame, double now);

    const AbsolemState& state() const { return state_; }
    const Counters& counters() const { return counters_; }

private:
    struct Request {
        std::array<char, 2> command{};
        std::uint16_t index = 0;
        double time = 0.0;
    };
    struct Node {
        std::optional<Request> asked;
        bool echoes = false;  ///< it echoes bit 6
    };

    AbsolemVerdict follow(const AbsolemFrame& frame, double now);
    AbsolemVerdict receiveReply(const AbsolemFrame& reply, double now);
    AbsolemVerdict keep(const AbsolemFrame& reply, double now);

    AbsolemState state_;
    std::array<Node, kAbsolemNodes> nodes_;
    Counters counters_{};
};

}  // namespace terratact
