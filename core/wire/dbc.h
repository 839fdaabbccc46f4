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
        std::uint64_t first = 0, last = 0;
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

    /// How many bits a frame must have for it.
    int end() const;
};

/// A frame as a DBC file describes it.
struct DbcMessage {
    std::uint32_t id = 0;  ///< 11 bits, or 29 where `extended`
    bool extended = false;
    int length = 0;  ///< [bytes] 0 … 64
    std::string name, sender, comment;
    std::vector<DbcSignal> payload;            ///< its signals; that word is a macro of Qt
    std::optional<std::size_t> selector;       ///< which of them is the multiplexor
    std::map<std::string, double> attributes;  ///< those that are numbers

    /// [s] from one frame to the next (GenMsgCycleTime); 0: on occasion, or the file does not say.
    double period() const;
    /// Throws std::out_of_range for none of that name.
    const DbcSignal& signal(const std::string& signalName) const;
};

/// What a signal is in a frame, whatever a multiplexor selects.  Empty where the frame is too short for it, is
/// no data frame, or where the value is not finite.  Of a CAN FD frame the first eight bytes are known.
std::optional<double> valueOf(const DbcSignal& signal, const CanFrame& frame);

/// The values of all signals of a message, in its order; empty also where the multiplexor selects others.
/// Throws std::invalid_argument unless `values` has one for each.
void decode(const DbcMessage& message, const CanFrame& frame,
            std::span<std::optional<double>> values);

/// The word that the file has for a value; null: none.
const std::string* wordOf(const DbcSignal& signal, double value);

}  // namespace terratact
