#include "app/recording/export/payload_signals.h"

#include <fmt/format.h>

#include <cmath>

#include "app/recording/export/mcap_writer.h"
#include "core/wire/dbc/dbc_number.h"
#include "core/wire/frame_layout.h"

namespace terratact {

void PayloadSignals::note(const CanFrame& frame)
{
    const std::pair key(frame.extended, frame.id);
    if (!book_ || byId_.contains(key) || leftOut_.contains(key)) return;
    auto described = book_->find(frame);
    if (!described) return;
    const std::size_t signals = described->message.payload.size();
    if (signals_ + signals > kMaxSignals) {
        leftOut_.insert(key);
        return;
    }
    byId_[key] = messages_.size();
    ids_.push_back(frame.id);
    messages_.push_back({std::move(described), {}, signals_});
    signals_ += signals;
}

void PayloadSignals::name()
{
    std::set<std::string> names;
    for (const FrameLayout& layout : frameLayouts()) names.emplace(layout.name);
    for (std::size_t i = 0; i < messages_.size(); ++i) {
        Message& m = messages_[i];
        const DbcMessage& message = m.described->message;
        m.name = message.isParameterGroup
                   ? fmt::format("{} from 0x{:02X}", message.name, ids_[i] & 0xFFU)
                   : message.name;
        if (names.insert(m.name).second) continue;
        m.name += fmt::format(" {:0{}X}", ids_[i], message.extended ? 8 : 3);
        names.insert(m.name);
    }
}

std::optional<std::size_t> PayloadSignals::find(const CanFrame& frame) const
{
    if (frame.error || frame.remote) return std::nullopt;
    const auto found = byId_.find(std::pair(frame.extended, frame.id));
    return found == byId_.end() ? std::nullopt : std::optional(found->second);
}

std::string headingOf(const PayloadSignals::Message& message, const DbcSignal& signal)
{
    return signal.unit.empty() ? fmt::format("{}.{}", message.name, signal.name)
                               : fmt::format("{}.{} [{}]", message.name, signal.name, signal.unit);
}

std::string jsonSchemaOf(const PayloadSignals::Message& message)
{
    std::string properties;
    for (const DbcSignal& signal : message.described->message.payload)
        properties += fmt::format(R"({}{}:{{"type":"number","description":{}}})",
                                  properties.empty() ? "" : ",", jsonText(signal.name),
                                  jsonText(signal.unit));
    return fmt::format(R"({{"type":"object","title":{},"properties":{{{}}}}})",
                       jsonText(message.name), properties);
}

std::string jsonValuesOf(const DbcMessage& message, const CanFrame& frame)
{
    std::vector<std::optional<std::uint64_t>> bits(message.payload.size());
    decodeBits(message, frame, bits);
    std::string values;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        const DbcSignal& signal = message.payload[i];
        if (!bits[i]) continue;
        const bool isFinite = std::isfinite(physicalOf(signal, *bits[i]));
        values += fmt::format("{}{}:{}", values.empty() ? "" : ",", jsonText(signal.name),
                              isFinite ? exactText(signal, *bits[i]) : "null");
    }
    return "{" + values + "}";
}

std::vector<std::string> numbersOf(const DbcMessage& message, const CanFrame& frame)
{
    std::vector<std::optional<std::uint64_t>> bits(message.payload.size());
    decodeBits(message, frame, bits);
    std::vector<std::string> numbers;
    numbers.reserve(bits.size());
    for (std::size_t i = 0; i < bits.size(); ++i)
        numbers.push_back(bits[i] ? exactText(message.payload[i], *bits[i]) : std::string());
    return numbers;
}

}  // namespace terratact
