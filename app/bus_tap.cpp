#include "app/bus_tap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/bus_statistics.h"

namespace terratact {
namespace {

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

TappedFrame emptyFrame(const FrameLayout& layout, FrameKind kind)
{
    TappedFrame frame;
    frame.kind = kind;
    frame.payload.resize(layout.payload.size());
    for (TappedSignal& signal : frame.payload) signal.history.fill(kGap);
    return frame;
}

/// Signals of a frame that says which of its values count.
bool isMeasured(const JudgedFrame& judged)
{
    const auto signals = layoutOf(*judged.kind).payload;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (signals[i].name == "Measured") return judged.content.values[i] != 0.0;
    return true;
}

}  // namespace

BusTap::BusTap()
{
    const auto layouts = frameLayouts();
    for (std::size_t i = 0; i < layouts.size(); ++i)
        known_.push_back({.frame = emptyFrame(layouts[i], static_cast<FrameKind>(i))});
    trace_.reserve(kTrace);
}

void BusTap::take(std::span<const BusFrame> frames)
{
    if (frames.empty()) return;
    const std::scoped_lock lock(mutex_);
    for (const BusFrame& frame : frames) take(frame);
}

void BusTap::take(const BusFrame& received)
{
    const CanFrame& frame = received.frame;
    const JudgedFrame judged = judge_.judge(frame, received.time);
    const FrameBits bits = bitsOf(frame);
    fewestBits_ += static_cast<std::uint64_t>(bits.fewest);
    mostBits_ += static_cast<std::uint64_t>(bits.most);
    ++troubles_[static_cast<std::size_t>(judged.trouble)];

    const TracedFrame traced{++frames_, received.time, frame, received.echo, judged.trouble};
    if (trace_.size() < kTrace)
        trace_.push_back(traced);
    else
        trace_[(frames_ - 1) % kTrace] = traced;

    Kept* kept = judged.kind ? &known_[static_cast<std::size_t>(*judged.kind)] : unknown(frame);
    if (!kept)
        ++beyond_;
    else
        keep(*kept, judged, received.time);
}

BusTap::Kept* BusTap::unknown(const CanFrame& frame)
{
    const UnknownKey key{frame.id, frame.extended, frame.remote, frame.error, frame.fd};
    const auto found = unknown_.find(key);
    if (found != unknown_.end()) return &found->second;
    return unknown_.size() < kMostUnknown ? &unknown_[key] : nullptr;
}

void BusTap::keep(Kept& kept, const JudgedFrame& judged, double time)
{
    TappedFrame& frame = kept.frame;
    ++frame.frames;
    ++frame.troubles[static_cast<std::size_t>(judged.trouble)];
    frame.newest = trace_[(frames_ - 1) % kTrace].frame;
    if (!judged.isSound() && judged.kind) return;
    kept.usedAt = time;
    if (!judged.kind) return;
    frame.isMeasured = isMeasured(judged);
    const auto layout = layoutOf(*judged.kind).payload;
    for (std::size_t i = 0; i < layout.size(); ++i) {
        if (!frame.isMeasured && layout[i].name != "Measured") continue;
        const double value = judged.content.values[i];
        TappedSignal& signal = frame.payload[i];
        signal.last = value;
        signal.least = std::min(signal.least.value_or(value), value);
        signal.most = std::max(signal.most.value_or(value), value);
    }
}

void BusTap::tick(double now)
{
    if (nextTick_ && now < *nextTick_) return;
    const std::scoped_lock lock(mutex_);
    if (!nextTick_ || now - *nextTick_ > kTick * TappedSignal::kPoints) nextTick_ = now;
    for (; *nextTick_ <= now; *nextTick_ += kTick) step(*nextTick_);
}

void BusTap::step(double now)
{
    const std::size_t place = ticks_ % (kRateTicks + 1);
    totals_[place] = {now, frames_, fewestBits_, mostBits_};
    for (Kept& kept : known_) {
        kept.counts[place] = kept.frame.frames;
        const bool fresh = kept.usedAt && now - *kept.usedAt <= kFresh && kept.frame.isMeasured;
        for (TappedSignal& signal : kept.frame.payload)
            signal.history[point_] = fresh && signal.last ? static_cast<float>(*signal.last) : kGap;
    }
    for (auto& [key, kept] : unknown_) kept.counts[place] = kept.frame.frames;
    point_ = (point_ + 1) % TappedSignal::kPoints;
    ++ticks_;
}

double BusTap::rate(const Ring<std::uint64_t>& counts) const
{
    if (ticks_ < 2) return 0.0;
    const std::size_t steps = std::min(ticks_ - 1, kRateTicks);
    const std::uint64_t now = counts[(ticks_ - 1) % (kRateTicks + 1)];
    const std::uint64_t before = counts[(ticks_ - 1 - steps) % (kRateTicks + 1)];
    return static_cast<double>(now - before) / (static_cast<double>(steps) * kTick);
}

BusLoad BusTap::load() const
{
    const std::scoped_lock lock(mutex_);
    BusLoad load{.frames = frames_, .troubles = troubles_, .beyond = beyond_};
    if (ticks_ < 2) return load;
    const std::size_t steps = std::min(ticks_ - 1, kRateTicks);
    const Totals& now = totals_[(ticks_ - 1) % (kRateTicks + 1)];
    const Totals& before = totals_[(ticks_ - 1 - steps) % (kRateTicks + 1)];
    const double seconds = now.time - before.time;
    load.framesPerSecond = static_cast<double>(now.frames - before.frames) / seconds;
    load.fewestBits = static_cast<double>(now.fewestBits - before.fewestBits) / seconds;
    load.mostBits = static_cast<double>(now.mostBits - before.mostBits) / seconds;
    return load;
}

std::vector<TappedFrame> BusTap::frames(double now) const
{
    std::vector<TappedFrame> frames;
    const std::scoped_lock lock(mutex_);
    const auto add = [&](const Kept& kept) {
        if (kept.frame.frames == 0) return;
        TappedFrame& frame = frames.emplace_back(kept.frame);
        frame.rate = rate(kept.counts);
        if (kept.usedAt) frame.age = std::max(0.0, now - *kept.usedAt);
        for (TappedSignal& signal : frame.payload)
            std::rotate(signal.history.begin(),
                        signal.history.begin() + static_cast<std::ptrdiff_t>(point_),
                        signal.history.end());
    };
    for (const Kept& kept : known_) add(kept);
    for (const auto& [key, kept] : unknown_) add(kept);
    return frames;
}

std::optional<double> BusTap::age(FrameKind kind, double now) const
{
    const std::scoped_lock lock(mutex_);
    const auto& usedAt = known_[static_cast<std::size_t>(kind)].usedAt;
    return usedAt ? std::optional(std::max(0.0, now - *usedAt)) : std::nullopt;
}

std::vector<TracedFrame> BusTap::trace() const
{
    const std::scoped_lock lock(mutex_);
    std::vector<TracedFrame> frames = trace_;
    if (frames.size() == kTrace)
        std::rotate(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(frames_ % kTrace),
                    frames.end());
    return frames;
}

void BusTap::forgetExtremes()
{
    const std::scoped_lock lock(mutex_);
    for (Kept& kept : known_)
        for (TappedSignal& signal : kept.frame.payload) signal.least = signal.most = std::nullopt;
}

}  // namespace terratact
