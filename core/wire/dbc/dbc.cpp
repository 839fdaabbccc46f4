#include "core/wire/dbc/dbc.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace terratact {
namespace {

constexpr int kWordBits = 64;

/// Returns the number of data bits of a frame.
int dataBits(const CanFrame& frame)
{
    return frame.error ? 0 : 8 * static_cast<int>(bytesOf(frame).size());
}

/// Returns the bits of a signal that the frame contains, in at most nine bytes. A little-endian
/// signal lies in the bytes from its first bit on, lowest first. A big-endian signal lies in the
/// bytes up to its end, highest first.
std::uint64_t rawBits(const DbcSignal& signal, const CanFrame& frame)
{
    // in the signal's own bit order
    const int first = signal.end() - signal.length, last = signal.end() - 1;
    std::uint64_t word = 0;
    if (signal.isBigEndian) {
        for (int bit = first; bit <= last;) {
            const int count = std::min(8 - bit % 8, last - bit + 1);
            const unsigned byte = frame.data[static_cast<std::size_t>(bit / 8)];
            const unsigned part = byte >> static_cast<unsigned>(8 - bit % 8 - count);
            word = word << static_cast<unsigned>(count)
                 | (part & ((1U << static_cast<unsigned>(count)) - 1U));
            bit += count;
        }
        return word;
    }
    for (int bit = first, got = 0; bit <= last;) {
        const int count = std::min(8 - bit % 8, last - bit + 1);
        const unsigned byte = frame.data[static_cast<std::size_t>(bit / 8)];
        const unsigned part = byte >> static_cast<unsigned>(bit % 8);
        word |= std::uint64_t{part & ((1U << static_cast<unsigned>(count)) - 1U)}
             << static_cast<unsigned>(got);
        bit += count;
        got += count;
    }
    return word;
}

double numberOf(const DbcSignal& signal, std::uint64_t bits)
{
    switch (signal.type) {
    case DbcSignal::Type::Unsigned: return static_cast<double>(bits);
    case DbcSignal::Type::Signed: return static_cast<double>(rawOf(signal, bits));
    case DbcSignal::Type::Float:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case DbcSignal::Type::Double: return std::bit_cast<double>(bits);
    }
    throw std::invalid_argument("DbcSignal: no such Type");
}

/// Returns true if a value of the signal's multiplexor selects it.
bool selects(std::uint64_t value, const DbcSignal& signal)
{
    const auto above =
        std::ranges::upper_bound(signal.selectedBy, value, {}, &DbcSignal::Selection::first);
    return above != signal.selectedBy.begin() && value <= std::prev(above)->last;
}

/// Returns true if the multiplexors above a signal select it.
bool isSelected(const DbcMessage& message, const DbcSignal& signal, const CanFrame& frame)
{
    const DbcSignal* below = &signal;
    for (int depth = 0; !below->selectedBy.empty(); ++depth) {
        if (!below->selector || depth > DbcSignal::kMaxNesting) return false;
        const DbcSignal& multiplexor = message.payload[*below->selector];
        const std::optional<std::uint64_t> selected = bitsOf(multiplexor, frame);
        if (!selected || !selects(*selected, *below)) return false;
        below = &multiplexor;
    }
    return true;
}

}  // namespace

int DbcSignal::end() const
{
    // The bits of a big-endian signal are consecutive, counted from the first byte's highest bit.
    const int first = isBigEndian ? start - start % 8 + 7 - start % 8 : start;
    return first + length;
}

double DbcMessage::period() const
{
    const auto found = attributes.find("GenMsgCycleTime");
    return found == attributes.end() ? 0.0 : std::max(0.0, 1e-3 * found->second);
}

const DbcSignal& DbcMessage::signal(std::string_view signalName) const
{
    const auto found = std::find_if(payload.begin(), payload.end(),
                                    [&](const DbcSignal& s) { return s.name == signalName; });
    if (found == payload.end())
        throw std::out_of_range(name + " has no signal " + std::string(signalName));
    return *found;
}

std::uint32_t parameterGroupOf(std::uint32_t id)
{
    constexpr std::uint32_t kPages = 0x03FF'0000, kDestination = 0x0000'FF00, kBroadcast = 0xF0;
    const bool isBroadcast = (id >> 16U & 0xFFU) >= kBroadcast;
    return id & (isBroadcast ? kPages | kDestination : kPages);
}

DbcRaw rawOf(const DbcSignal& signal, std::uint64_t bits)
{
    if (signal.type != DbcSignal::Type::Signed) return bits;
    const auto unused = static_cast<unsigned>(kWordBits - signal.length);
    return static_cast<std::int64_t>(bits << unused) >> unused;
}

std::optional<std::uint64_t> bitsOf(const DbcSignal& signal, const CanFrame& frame)
{
    if (signal.end() > dataBits(frame)) return std::nullopt;
    return rawBits(signal, frame);
}

void decodeBits(const DbcMessage& message, const CanFrame& frame,
                std::span<std::optional<std::uint64_t>> bits)
{
    if (bits.size() != message.payload.size())
        throw std::invalid_argument("decode: a message needs one value for each of its signals");
    std::size_t left = mostSignals(bytesOf(frame).size());
    for (std::size_t i = 0; i < bits.size(); ++i) {
        const DbcSignal& signal = message.payload[i];
        const bool isWanted = left > 0 && isSelected(message, signal, frame);
        bits[i] = isWanted ? bitsOf(signal, frame) : std::nullopt;
        left -= bits[i].has_value();
    }
}

double physicalOf(const DbcSignal& signal, std::uint64_t bits)
{
    return numberOf(signal, bits) * signal.scale + signal.offset;
}

std::optional<double> valueOf(const DbcSignal& signal, const CanFrame& frame)
{
    const std::optional<std::uint64_t> bits = bitsOf(signal, frame);
    return bits ? std::optional(physicalOf(signal, *bits)) : std::nullopt;
}

void decode(const DbcMessage& message, const CanFrame& frame,
            std::span<std::optional<double>> values)
{
    std::vector<std::optional<std::uint64_t>> bits(values.size());
    decodeBits(message, frame, bits);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] =
            bits[i] ? std::optional(physicalOf(message.payload[i], *bits[i])) : std::nullopt;
}

const std::string* wordOfBits(const DbcSignal& signal, std::uint64_t bits)
{
    using Type = DbcSignal::Type;
    if (signal.type == Type::Float || signal.type == Type::Double)
        return wordOf(signal, physicalOf(signal, bits));
    const auto found = signal.words.find(rawOf(signal, bits));
    return found == signal.words.end() ? nullptr : &found->second;
}

const std::string* wordOf(const DbcSignal& signal, double value)
{
    constexpr double kMaxExact = 9007199254740992.0;  // 2⁵³
    if (signal.words.empty()) return nullptr;
    const double raw = std::round((value - signal.offset) / signal.scale);
    if (!(std::abs(raw) <= kMaxExact)) return nullptr;
    const auto found = signal.words.find(static_cast<std::int64_t>(raw));
    return found == signal.words.end() ? nullptr : &found->second;
}

}  // namespace terratact
