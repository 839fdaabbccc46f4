#include "core/wire/dbc.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr int kWordBits = 64;

/// The data of a frame in both orders: bit i of the file is bit i of `little`; in `big` the first byte is the
/// highest.
struct DataWords {
    std::uint64_t little = 0, big = 0;
    int bits = 0;  ///< that the frame has
};

DataWords dataOf(const CanFrame& frame)
{
    DataWords data;
    for (std::size_t i = 0; i < frame.data.size(); ++i) {
        const auto shift = static_cast<unsigned>(8 * i);
        data.little |= std::uint64_t{frame.data[i]} << shift;
        data.big |= std::uint64_t{frame.data[i]} << (kWordBits - 8U - shift);
    }
    const bool isData = !frame.remote && !frame.error;
    data.bits = isData ? 8 * std::min<int>(frame.length, static_cast<int>(frame.data.size())) : 0;
    return data;
}

/// Of a signal that the data has.
std::uint64_t rawBits(const DbcSignal& signal, const DataWords& data)
{
    const std::uint64_t word = signal.isBigEndian
                                 ? data.big >> static_cast<unsigned>(kWordBits - signal.end())
                                 : data.little >> static_cast<unsigned>(signal.start);
    return word & (~std::uint64_t{0} >> static_cast<unsigned>(kWordBits - signal.length));
}

double numberOf(const DbcSignal& signal, std::uint64_t bits)
{
    switch (signal.type) {
    case DbcSignal::Type::Unsigned: return static_cast<double>(bits);
    case DbcSignal::Type::Signed: {
        const auto unused = static_cast<unsigned>(kWordBits - signal.length);
        return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }
    case DbcSignal::Type::Float:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case DbcSignal::Type::Double: return std::bit_cast<double>(bits);
    }
    throw std::invalid_argument("DbcSignal: no such Type");
}

std::optional<double> physicalOf(const DbcSignal& signal, const DataWords& data)
{
    if (signal.end() > data.bits) return std::nullopt;
    const double value = numberOf(signal, rawBits(signal, data)) * signal.scale + signal.offset;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool isSelected(const DbcSignal& signal, const std::optional<std::uint64_t>& selected)
{
    if (signal.selectedBy.empty()) return true;
    return selected
        && std::any_of(signal.selectedBy.begin(), signal.selectedBy.end(),
                       [&](const DbcSignal::Selection& range) {
                           return range.first <= *selected && *selected <= range.last;
                       });
}

}  // namespace

int DbcSignal::end() const
{
    // From the first byte's highest bit on, the bits of a big-endian signal follow each other.
    const int first = isBigEndian ? start - start % 8 + 7 - start % 8 : start;
    return first + length;
}

double DbcMessage::period() const
{
    const auto found = attributes.find("GenMsgCycleTime");
    return found == attributes.end() ? 0.0 : std::max(0.0, 1e-3 * found->second);
}

const DbcSignal& DbcMessage::signal(const std::string& signalName) const
{
    const auto found = std::find_if(payload.begin(), payload.end(),
                                    [&](const DbcSignal& s) { return s.name == signalName; });
    if (found == payload.end()) throw std::out_of_range(name + " has no signal " + signalName);
    return *found;
}

std::optional<double> valueOf(const DbcSignal& signal, const CanFrame& frame)
{
    return physicalOf(signal, dataOf(frame));
}

void decode(const DbcMessage& message, const CanFrame& frame,
            std::span<std::optional<double>> values)
{
    if (values.size() != message.payload.size())
        throw std::invalid_argument("decode: a message needs one value for each of its signals");
    const DataWords data = dataOf(frame);
    std::optional<std::uint64_t> selected;
    if (message.selector && message.payload[*message.selector].end() <= data.bits)
        selected = rawBits(message.payload[*message.selector], data);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DbcSignal& signal = message.payload[i];
        values[i] = isSelected(signal, selected) ? physicalOf(signal, data) : std::nullopt;
    }
}

const std::string* wordOf(const DbcSignal& signal, double value)
{
    constexpr double kMostExact = 9007199254740992.0;  // 2⁵³
    if (signal.words.empty()) return nullptr;
    const double raw = std::round((value - signal.offset) / signal.scale);
    if (!(std::abs(raw) <= kMostExact)) return nullptr;
    const auto found = signal.words.find(static_cast<std::int64_t>(raw));
    return found == signal.words.end() ? nullptr : &found->second;
}

}  // namespace terratact
