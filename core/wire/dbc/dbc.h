#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/can_frame.h"

namespace terratact {

/// Raw value of an integer signal: 64 bits, signed or unsigned.
__extension__ using DbcRaw = __int128;

/// Signal of a frame as a DBC file describes it: a number raw · scale + offset, in `unit`. Texts
/// are UTF-8 on one line; comments keep their lines.
struct DbcSignal {
    /// Float, Double: IEEE 754
    enum class Type : std::uint8_t { Unsigned, Signed, Float, Double };
    /// Range of multiplexor values that select a signal; both ends belong to it.
    struct Selection {
        std::uint64_t first = 0, last = 0;  ///< raw values
        bool operator==(const Selection&) const = default;
    };

    std::string name;
    /// Start bit: bit b is bit b % 8 of byte b / 8. It is the lowest bit, or the highest one of a
    /// big-endian signal. A big-endian signal continues with lower bits of its byte, and then with
    /// the highest bit of the next byte.
    int start = 0;
    int length = 0;  ///< [bits] 1 … 64
    bool isBigEndian = false;
    Type type = Type::Unsigned;
    double scale = 1.0, offset = 0.0;
    /// Both ends belong to the range; equal: the file gives no range.
    double least = 0.0, most = 0.0;
    std::string unit, receivers, comment;
    std::map<DbcRaw, std::string> words;  ///< texts of raw values; none is blank
    /// In the order of their first values, without overlap. Empty: the signal is in every frame of
    /// its message.
    std::vector<Selection> selectedBy;
    /// The multiplexor of selectedBy, as an index of its message's payload. Multiplexors may be
    /// nested, at most kMaxNesting deep.
    std::optional<std::size_t> selector;
    static constexpr int kMaxNesting = 8;

    /// Returns the number of bits that a frame must have to contain the signal.
    int end() const;
};

/// Message as a DBC file describes it.
struct DbcMessage {
    std::uint32_t id = 0;  ///< 11 bits, or 29 where `extended`
    bool extended = false;
    int length = 0;  ///< [bytes] 0 … 64
    std::string name, sender, comment;
    std::vector<DbcSignal> payload;  ///< at most kMaxSignals; `signals` is a macro of Qt
    bool isParameterGroup = false;   ///< J1939: from any source address (parameterGroupOf)
    std::map<std::string, double> attributes;  ///< numeric attributes

    /// 64 multiplexed pages of a frame of 8 bytes, with a signal for each bit.
    static constexpr std::size_t kMaxSignals = 4096;

    /// Returns the time between two frames [s] (GenMsgCycleTime); 0: event-driven, or not in the
    /// file.
    double period() const;
    /// Returns the signal of that name. Throws std::out_of_range if there is none.
    const DbcSignal& signal(std::string_view signalName) const;
};

/// Returns the part of a 29-bit identifier that names a J1939 parameter group. It is without
/// priority, source address and any destination.
std::uint32_t parameterGroupOf(std::uint32_t id);

/// Returns the bits of a signal in a frame, whatever a multiplexor selects. Empty if the frame is
/// too short, or is no data frame.
std::optional<std::uint64_t> bitsOf(const DbcSignal& signal, const CanFrame& frame);

/// Returns the most signals that a frame of so many bytes is decoded to: one for each bit, and 8
/// more, because signals may overlap.
constexpr std::size_t mostSignals(std::size_t bytes)
{
    return 8 * bytes + 8;
}

/// Writes the bits of all signals of a message, in its order. Signals that a multiplexor does not
/// select are empty too, and signals beyond the first mostSignals() of the frame. Throws
/// std::invalid_argument unless `bits` has one element per signal.
void decodeBits(const DbcMessage& message, const CanFrame& frame,
                std::span<std::optional<std::uint64_t>> bits);

/// Returns raw · scale + offset, to the precision of a double (dbc_number.h gives all digits). A
/// float that is NaN or infinite stays so.
double physicalOf(const DbcSignal& signal, std::uint64_t bits);

/// Return the values of a frame, with the same rules as the bits.
std::optional<double> valueOf(const DbcSignal& signal, const CanFrame& frame);
void decode(const DbcMessage& message, const CanFrame& frame,
            std::span<std::optional<double>> values);

/// Returns the raw value of an integer signal.
DbcRaw rawOf(const DbcSignal& signal, std::uint64_t bits);

/// Return the file's text for a value; null: none.
const std::string* wordOf(const DbcSignal& signal, double value);
const std::string* wordOfBits(const DbcSignal& signal, std::uint64_t bits);

}  // namespace terratact
