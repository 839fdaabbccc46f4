#include "app/link/frame_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/link/bus_statistics.h"

namespace terratact {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

TappedFrame emptyFrame(const FrameLayout& layout, FrameKind kind)
{
    TappedFrame frame;
    frame.kind = kind;
    frame.payload.resize(layout.payload.size());
    for (TappedSignal& signal : frame.payload) signal.history.fill(kNoValue);
    return frame;
}

/// Returns false if the frame states that its values were not measured.
bool isMeasured(const JudgedFrame& judged)
{
    const auto signals = layoutOf(*judged.kind).payload;
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (signals[i].name == "Measured") return judged.content.values[i] != 0.0;
    return true;
}

}  // namespace

FrameHistory::FrameHistory()
{
    const auto layouts = frameLayouts();
    for (std::size_t i = 0; i < layouts.size(); ++i)
        known_.push_back({.frame = emptyFrame(layouts[i], static_cast<FrameKind>(i))});
    trace_.reserve(kTrace);
}

void FrameHistory::add(const BusFrame& received, const JudgedFrame& judged)
{
    const std::scoped_lock lock(mutex_);
    const CanFrame& frame = received.frame;
    const FrameBits bits = bitsOf(frame);
    fewestBits_ += static_cast<std::uint64_t>(bits.fewest);
    mostBits_ += static_cast<std::uint64_t>(bits.most);
    const FrameTrouble trouble =
        judged.kind ? judged.trouble : foreign_.add(frame, judged.trouble, received.time);
    ++troubles_[static_cast<std::size_t>(trouble)];

    const TracedFrame traced{++frames_, received.time, frame, received.echo, trouble};
    if (trace_.size() < kTrace)
        trace_.push_back(traced);
    else
        trace_[(frames_ - 1) % kTrace] = traced;

    if (judged.kind) keep(known_[static_cast<std::size_t>(*judged.kind)], judged, received);
    if (listener_) listener_(received, judged);
}

void FrameHistory::listen(const Listener& listener)
{
    const std::scoped_lock lock(mutex_);
    listener_ = listener;
}

void FrameHistory::keep(Kept& kept, const JudgedFrame& judged, const BusFrame& received)
{
    TappedFrame& frame = kept.frame;
    ++frame.frames;
    ++frame.troubles[static_cast<std::size_t>(judged.trouble)];
    frame.newest = received.frame;
    if (!judged.isSound()) return;
    kept.usedAt = received.time;
    frame.isMeasured = isMeasured(judged);
    const auto measured = measuredSignals(judged.content);
    for (std::size_t i = 0; i < frame.payload.size(); ++i) {
        if (measured[i])
            frame.payload[i].add(judged.content.values[i]);
        else if (frame.isMeasured)
            frame.payload[i].last.reset();  // this signal alone was not measured
    }
}

void FrameHistory::tick(double now)
{
    if (nextTick_ && now < *nextTick_) return;
    const std::scoped_lock lock(mutex_);
    if (!nextTick_ || now - *nextTick_ > kTick * TappedSignal::kPoints) nextTick_ = now;
    for (; *nextTick_ <= now; *nextTick_ += kTick) step(*nextTick_);
}

void FrameHistory::describe(std::shared_ptr<const DbcBook> book)
{
    // The previous book is freed after the lock, because the bus thread waits for it.
    std::shared_ptr<const DbcBook> before;
    const std::scoped_lock lock(mutex_);
    before = foreign_.describe(std::move(book));
}

void FrameHistory::step(double now)
{
    const std::size_t place = ticks_ % totals_.size();
    totals_[place] = {now, frames_, fewestBits_, mostBits_};
    for (Kept& kept : known_) {
        kept.counts[place] = kept.frame.frames;
        const bool fresh = kept.usedAt && now - *kept.usedAt <= kFresh && kept.frame.isMeasured;
        for (TappedSignal& signal : kept.frame.payload)
            signal.history[point_] =
                fresh && signal.last ? static_cast<float>(*signal.last) : kNoValue;
    }
    foreign_.step(now, ticks_, point_);
    point_ = (point_ + 1) % TappedSignal::kPoints;
    ++ticks_;
}

BusLoad FrameHistory::load() const
{
    const std::scoped_lock lock(mutex_);
    BusLoad load{.frames = frames_, .troubles = troubles_, .beyond = foreign_.beyond()};
    if (ticks_ < 2) return load;
    const std::size_t steps = std::min(ticks_ - 1, kBusRateTicks);
    const Totals& now = totals_[(ticks_ - 1) % totals_.size()];
    const Totals& before = totals_[(ticks_ - 1 - steps) % totals_.size()];
    const double seconds = now.time - before.time;
    load.framesPerSecond = static_cast<double>(now.frames - before.frames) / seconds;
    load.fewestBits = static_cast<double>(now.fewestBits - before.fewestBits) / seconds;
    load.mostBits = static_cast<double>(now.mostBits - before.mostBits) / seconds;
    return load;
}

std::vector<TappedFrame> FrameHistory::frames(double now) const
{
    std::vector<TappedFrame> frames;
    const std::scoped_lock lock(mutex_);
    const auto add = [&](const Kept& kept) {
        if (kept.frame.frames == 0) return;
        TappedFrame& frame = frames.emplace_back(kept.frame);
        frame.rate = rateOf(kept.counts, ticks_);
        if (kept.usedAt) frame.age = std::max(0.0, now - *kept.usedAt);
        for (TappedSignal& signal : frame.payload) signal.unrollHistory(point_);
    };
    for (const Kept& kept : known_) add(kept);
    foreign_.addTo(frames, now, ticks_, point_);
    return frames;
}

std::optional<double> FrameHistory::age(FrameKind kind, double now) const
{
    const std::scoped_lock lock(mutex_);
    const auto& usedAt = known_[static_cast<std::size_t>(kind)].usedAt;
    return usedAt ? std::optional(std::max(0.0, now - *usedAt)) : std::nullopt;
}

std::vector<TracedFrame> FrameHistory::trace() const
{
    const std::scoped_lock lock(mutex_);
    std::vector<TracedFrame> frames = trace_;
    if (frames.size() == kTrace)
        std::rotate(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(frames_ % kTrace),
                    frames.end());
    return frames;
}

void FrameHistory::forgetExtremes()
{
    const std::scoped_lock lock(mutex_);
    for (Kept& kept : known_)
        for (TappedSignal& signal : kept.frame.payload) signal.forgetExtremes();
    foreign_.forgetExtremes();
}

}  // namespace terratact
