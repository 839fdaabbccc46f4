#include "app/plotting/frame_signals.h"

#include <algorithm>
#include <cmath>

#include "app/link/can_text.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

std::string shownFrame(std::uint32_t id, std::string_view frameName)
{
    CanFrame frame;
    frame.id = id;
    return idText(frame) + ' ' + std::string(frameName);
}

PlotSignal protocolSignal(const FrameLayout& layout, const SignalLayout& signal)
{
    return {.origin = SignalOrigin::Bus,
            .id = std::string(layout.name) + '.' + std::string(signal.name),
            .name = Message::verbatim(std::string(signal.name)),
            .unit = std::string(signal.unit),
            .frame = shownFrame(layout.id, layout.name)};
}

}  // namespace

std::vector<PlotSignal> protocolSignals()
{
    std::vector<PlotSignal> all;
    for (const FrameLayout& layout : frameLayouts())
        for (const SignalLayout& signal : layout.payload)
            all.push_back(protocolSignal(layout, signal));
    return all;
}

std::vector<PlotSignal> payloadSignals(const CanFrame& frame, const DescribedFrame& described)
{
    const DbcMessage& message = described.message;
    const std::string called = idText(frame) + ' ' + message.name;
    std::vector<PlotSignal> all;
    all.reserve(message.payload.size());
    for (const DbcSignal& signal : message.payload)
        all.push_back({.origin = SignalOrigin::Payload,
                       .id = called + '.' + signal.name,
                       .name = Message::verbatim(signal.name),
                       .unit = shownDbcText(signal.unit),
                       .frame = called});
    return all;
}

void FrameSignals::choose(const std::vector<std::string>& keys)
{
    chosen_.clear();
    foreign_.clear();
    for (auto& wanted : known_) wanted.clear();
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].starts_with("bus:") || keys[i].starts_with("payload:")) chosen_[keys[i]] = i;
    if (chosen_.empty()) return;
    for (std::size_t kind = 0; kind < kFrameKinds; ++kind) {
        const FrameLayout& layout = frameLayouts()[kind];
        for (std::size_t place = 0; place < layout.payload.size(); ++place)
            if (const auto found =
                    chosen_.find(protocolSignal(layout, layout.payload[place]).key());
                found != chosen_.end())
                known_[kind].push_back({place, found->second});
    }
}

void FrameSignals::describe(std::shared_ptr<const DbcBook> book)
{
    book_ = std::move(book);
    foreign_.clear();
}

const FrameSignals::Described& FrameSignals::describedBy(const CanFrame& frame)
{
    static const Described kNone{};
    const std::uint64_t key = std::uint64_t{frame.id} << 1U | (frame.extended ? 1U : 0U);
    if (const auto found = foreign_.find(key); found != foreign_.end()) return found->second;
    if (foreign_.size() >= kMaxForeign) return kNone;
    Described& made = foreign_[key];
    made.frame = book_->find(frame);
    if (!made.frame) return made;
    const auto all = payloadSignals(frame, *made.frame);
    for (std::size_t place = 0; place < all.size(); ++place)
        if (const auto found = chosen_.find(all[place].key()); found != chosen_.end())
            made.wanted.push_back({place, found->second});
    return made;
}

void FrameSignals::decode(const CanFrame& frame, const JudgedFrame& judged,
                          std::vector<Value>& values)
{
    if (chosen_.empty()) return;
    if (judged.kind) {
        const auto kind = static_cast<std::size_t>(*judged.kind);
        if (known_[kind].empty() || !judged.isSound()) return;
        const auto measured = measuredSignals(judged.content);
        for (const Wanted& wanted : known_[kind])
            if (measured[wanted.place])
                values.push_back({wanted.signal, judged.content.values.at(wanted.place)});
        return;
    }
    if (!book_ || frame.error || frame.remote) return;
    const Described& described = describedBy(frame);
    if (described.wanted.empty()) return;
    const DbcMessage& message = described.frame->message;
    bits_.assign(message.payload.size(), std::nullopt);
    decodeBits(message, frame, bits_);
    for (const Wanted& wanted : described.wanted)
        if (const auto& bits = bits_[wanted.place])
            values.push_back({wanted.signal, physicalOf(message.payload[wanted.place], *bits)});
}

}  // namespace terratact
