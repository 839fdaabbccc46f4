#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/wire/can_frame.h"

namespace terratact {

/// A number in the data of a frame as a DBC file describes it: raw · scale + offset, in `unit`.
/// Texts are UTF-8 on one line, but comments, which keep theirs.
struct DbcSignal {
    enum class Type : std::uint8_t { Unsigned, Signed, Float, Double };  ///< the last two: IEEE 754
    /// Of the multiplexor; both ends belong to it.
    struct Selection {
        std::uint64_t first = 0, last = 0;  ///< raw values
        bool operator==(const Selection&) const = default;
    };

    std::string name;
    /// Bit b is bit b % 8 of byte b / 8.  That of the lowest bit or, big-endian, of the highest, from which
    /// the signal goes on to lower bits of its byte and then to the highest of the next.
    int start = 0;
    int length = 0;  ///< [bits] 1 … 64
    bool isBigEndian = false;
    Type type = Type::Unsigned;
    double scale = 1.0, offset = 0.0;
    double least = 0.0, most = 0.0;  ///< both belong to the range; equal: the file gives none
    std::string unit, receivers, comment;
    std::map<std::int64_t, std::string> words;  ///< of raw values
    std::vector<Selection> selectedBy;          ///< empty: it is in every frame of its message
    /// The multiplexor of those: an index of its message's payload.  Multiplexors may stand below others, at most
    /// kMaxNesting deep.
    std::optional<std::size_t> selector;
    static constexpr int kMaxNesting = 8;

    /// How many bits a frame must have for it.
    int end() const;
};

/// A frame as a DBC file describes it.
struct DbcMessage {
    std::uint32_t id = 0;  ///< 11 bits, or 29 where `extended`
    bool extended = false;
    int length = 0;  ///< [bytes] 0 … 64
    std::string name, sender, comment;
    std::vector<DbcSignal> payload;  ///< its signals; that word is a macro of Qt
    bool isParameterGroup = false;   ///< of J1939: from any source address (parameterGroupOf)
    std::map<std::string, double> attributes;  ///< those that are numbers

    /// [s] from one frame to the next (GenMsgCycleTime); 0: on occasion, or the file does not say.
    double period() const;
    /// Throws std::out_of_range for none of that name.
    const DbcSignal& signal(const std::string& signalName) const;
};

/// What of a 29-bit identifier names a parameter group of J1939: neither priority nor source address and, where it
/// tells a destination, not that either.
std::uint32_t parameterGroupOf(std::uint32_t id);

/// The bits of a signal in a frame, whatever a multiplexor selects.  Empty where the frame is too short for it or is no
/// data frame.
std::optional<std::uint64_t> bitsOf(const DbcSignal& signal, const CanFrame& frame);

/// Those of all signals of a message, in its order; empty also where a multiplexor selects others.
/// Throws std::invalid_argument unless `bits` has one for each.
void decodeBits(const DbcMessage& message, const CanFrame& frame,
                std::span<std::optional<std::uint64_t>> bits);

/// raw · scale + offset, to the precision of a double (dbc_number.h: to all digits).  NaN and infinite of a float that
/// is so.
double physicalOf(const DbcSignal& signal, std::uint64_t bits);

/// The same of a frame's.
std::optional<double> valueOf(const DbcSignal& signal, const CanFrame& frame);
void decode(const DbcMessage& message, const CanFrame& frame,
            std::span<std::optional<double>> values);

/// The raw value of an integer signal; beyond 63 bits it wraps around.
std::int64_t rawOf(const DbcSignal& signal, std::uint64_t bits);

/// The word that the file has for a value; null: none.
const std::string* wordOf(const DbcSignal& signal, double value);
const std::string* wordOfBits(const DbcSignal& signal, std::uint64_t bits);

}  // namespace terratact
