#include "app/plotting/signal_catalogue.h"

#include <algorithm>
#include <iterator>

#include "app/plotting/estimate_signals.h"
#include "app/plotting/frame_signals.h"
#include "app/plotting/telemetry_signals.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxKinds = 4096;  // bound on kinds of frames, described or not

PlotSignal frameRate()
{
    return {.origin = SignalOrigin::Bus,
            .id = "frames_per_second",
            .name = TR_NOOP("core", "frames per second"),
            .unit = "1/s",
            .frame = {}};
}

}  // namespace

std::string_view name(SignalOrigin origin)
{
    switch (origin) {
    case SignalOrigin::Telemetry: return "telemetry";
    case SignalOrigin::Bus: return "bus";
    case SignalOrigin::Estimate: return "estimate";
    case SignalOrigin::Payload: break;
    }
    return "payload";
}

SourceText describe(SignalOrigin origin)
{
    switch (origin) {
    case SignalOrigin::Telemetry: return TR_NOOP("core", "telemetry");
    case SignalOrigin::Bus: return TR_NOOP("core", "bus");
    case SignalOrigin::Estimate: return TR_NOOP("core", "estimate");
    case SignalOrigin::Payload: break;
    }
    return TR_NOOP("core", "payload");
}

std::string frameRateKey()
{
    return frameRate().key();
}

void SignalCatalogue::describe(std::shared_ptr<const DbcBook> book)
{
    book_ = std::move(book);
    payload_.clear();
    described_ = 0;
}

bool SignalCatalogue::add(const CanFrame& frame)
{
    if (!book_ || frame.error || frame.remote) return false;
    const std::pair key(frame.extended, frame.id);
    if (payload_.contains(key) || payload_.size() >= kMaxKinds || described_ >= kMaxDescribed)
        return false;
    const auto described = book_->find(frame);
    payload_[key] = described ? payloadSignals(frame, *described) : std::vector<PlotSignal>();
    if (!described) return false;
    ++described_;
    return true;
}

std::vector<PlotSignal> SignalCatalogue::all() const
{
    std::vector<PlotSignal> all(telemetrySignals().begin(), telemetrySignals().end());
    const auto append = [&all](const auto& some) {
        all.insert(all.end(), some.begin(), some.end());
    };
    append(estimateSignals());
    for (const auto& [key, some] : payload_) append(some);
    all.push_back(frameRate());
    append(protocolSignals());
    return all;
}

std::vector<std::vector<std::string>> SignalCatalogue::usualRows()
{
    return {{"telemetry:pitch", "telemetry:roll"},
            {"telemetry:front_left", "telemetry:front_right"},
            {"telemetry:force1", "telemetry:force4", "telemetry:force6"},
            {"estimate:p_step"}};
}

}  // namespace terratact
