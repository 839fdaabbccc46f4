#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/wire/can_codec.h"
#include "core/wire/can_frame.h"

namespace terratact {

// The bus of a real Absolem (NIFTi, TRADR): 500 kbit/s, seven Elmo SimplIQ drives that speak the "binary
// interpreter" on PDO2 of CANopen, polled by the robot's computer at 20 Hz.  Listened to, never written to.
//
// Request 0x300 + node, reply 0x280 + node: two letters of a command, its index, a byte of type, and for a set
// or a reply a little-endian int32 or float32.  Status word, unasked: 0x180 + node.  Start: identifier 0.
//
// Sources: NIFTi-BlueBotics/Librover (nodes, counts, which motors are mounted mirrored) and Elmo's MAN-CAN301IG
// 2.1, chapter 9 (types, refusals).  Assumptions, to be checked on the robot:
//   – a motor's positive current turns its encoder towards positive counts; from this and from the mirrored
//     motors follows which current presses down;
//   – the driver has set the encoders so that 0 is the lower edge flat (it does at start-up, from a
//     potentiometer).
// Pitch, roll, forces and the arm are not on this bus: from it alone no terrain can be estimated.

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

inline constexpr double kFlipperCounts = 6000.0;  ///< of the encoder per turn of a flipper

/// One frame of the bus, its bytes taken apart.
struct AbsolemFrame {
    enum class Kind : std::uint8_t { NetworkCommand, StatusWord, Query, Set, Reply };

    Kind kind = Kind::Query;
    AbsolemNode node = AbsolemNode::Core;   ///< of no meaning in a NetworkCommand, which is for all
    std::array<char, 2> command{' ', ' '};  ///< in capitals
    std::uint16_t index = 0;
    bool isFloat = false;  ///< the type bit says so
    bool flagged = false;  ///< bit 6 of the type: in a Reply most often that the drive refuses
    std::uint32_t bits =
        0;  ///< Set, Reply: the value; StatusWord, NetworkCommand: the first two bytes

    std::string name() const;  ///< "PX", "IB[16]"
    std::int32_t asInt() const;
    float asFloat() const;
    bool operator==(const AbsolemFrame&) const = default;
};

/// What a listener made of a frame.
enum class AbsolemVerdict : std::uint8_t {
    Used,    ///< AbsolemState has a new value
    Passed,  ///< in order, but nothing that is kept
    // Not understood:
    UnknownId,
    NotClassicData,  ///< extended, remote, error or FD frame
    WrongLength,
    NotACommand,  ///< no two letters
    // Replies that are not used:
    UnknownCommand,
    NotAsked,    ///< no request of the last 0.1 s has its header
    Refused,     ///< the drive says so: `bits` is its error code (EC)
    WrongType,   ///< a float where counts or bits are expected
    OutOfRange,  ///< NaN, or more than motor or encoder can have
};
inline constexpr std::size_t kAbsolemVerdicts = 11;
std::string describe(AbsolemVerdict verdict);

/// Takes the bytes apart; a verdict from UnknownId to NotACommand where that cannot be done.
std::variant<AbsolemFrame, AbsolemVerdict> absolemFrame(const CanFrame& frame);

/// A value and when it arrived.
template <class T>
struct Dated {
    T value{};
    double time = 0.0;  ///< [s]
    bool operator==(const Dated&) const = default;
};

/// What the bus has said so far; an empty optional: nothing.
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
    std::array<Drive, kAbsolemNodes> drives;   ///< of node 1 … 7
    std::optional<Dated<bool>> emergencyStop;  ///< IB[16]: the button is pressed
    bool operator==(const AbsolemState&) const = default;
};

/// What of a line of sensors this bus gives: angles and currents that are at most `limit` [s] old.
SensorLine sensorLineOf(const AbsolemState& state, double now, double limit);

/// Follows the conversation between the robot's computer and its drives.  No clock; `now` [s] is any clock.
///
/// A reply counts when it has the header of the last request to its node.  The robot's own library does not
/// look at bit 6 of a reply's type.  Elmo's manual calls it a refusal with an error code of one byte, and so it
/// is taken; a drive that merely sends the bit of the request back is told by a value that no such code has.
class AbsolemListener {
public:
    struct Heard {
        AbsolemVerdict verdict = AbsolemVerdict::Passed;
        std::optional<AbsolemFrame> frame{};  ///< where the bytes could be taken apart
    };
    using Counters = std::array<std::uint64_t, kAbsolemVerdicts>;  ///< by AbsolemVerdict

    /// Throws std::invalid_argument unless `now` is finite.
    Heard take(const CanFrame& frame, double now);

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
        bool echoes = false;  ///< it sends bit 6 back as it came
    };

    AbsolemVerdict follow(const AbsolemFrame& frame, double now);
    AbsolemVerdict takeReply(const AbsolemFrame& reply, double now);
    AbsolemVerdict keep(const AbsolemFrame& reply, double now);

    AbsolemState state_;
    std::array<Node, kAbsolemNodes> nodes_;
    Counters counters_{};
};

}  // namespace terratact
