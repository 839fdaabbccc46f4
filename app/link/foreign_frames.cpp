#include "app/link/foreign_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/limits.h"

namespace terratact {
namespace {

constexpr float kNoPoint = std::numeric_limits<float>::quiet_NaN();

float pointOf(double value)
{
    constexpr double kMax = std::numeric_limits<float>::max();
    if (!std::isfinite(value)) return kNoPoint;
    return static_cast<float>(std::clamp(value, -kMax, kMax));
}

}  // namespace

void UsualInterval::add(double seconds)
{
    // The first interval may have been an outage; only the second one reveals that.
    if (counted_ == 1 && last_[0] > kSilence * seconds) {
        counted_ = 0;
        silence_ = taken_;
    }
    const double usual = counted_ == 0 ? 0.0 : this->seconds();
    ++taken_;
    if (usual > 0.0 && seconds > kSilence * usual) {
        const bool isAlone = silence_ == 0 || taken_ - silence_ > last_.size();
        silence_ = taken_;
        if (isAlone) return;
    }
    last_[counted_++ % last_.size()] = std::clamp(seconds, 0.0, kMax);
}

double UsualInterval::seconds() const
{
    return *std::max_element(last_.begin(), last_.end());
}

std::shared_ptr<const DbcBook> ForeignFrames::describe(std::shared_ptr<const DbcBook> book)
{
    described_.clear();
    unknown_.clear();
    signals_ = 0;
    beyond_ = 0;
    return std::exchange(book_, std::move(book));
}

FrameTrouble ForeignFrames::add(const CanFrame& frame, FrameTrouble trouble, double time)
{
    Kept* kept = keptOf(frame);
    if (!kept) {
        ++beyond_;
        return trouble;
    }
    if (kept->frame.described) trouble = FrameTrouble::None;
    ++kept->frame.frames;
    ++kept->frame.troubles[static_cast<std::size_t>(trouble)];
    kept->frame.newest = frame;
    kept->usedAt = time;
    if (kept->frame.described) addValues(*kept, frame, time);
    return trouble;
}

ForeignFrames::Kept* ForeignFrames::keptOf(const CanFrame& frame)
{
    const Key key{frame.id, frame.extended, frame.remote, frame.error, frame.fd};
    for (Kinds* kinds : {&described_, &unknown_})
        if (const auto found = kinds->find(key); found != kinds->end()) return &found->second;
    return begin(key, book_ ? book_->find(frame) : nullptr);
}

ForeignFrames::Kept* ForeignFrames::begin(const Key& key,
                                          std::shared_ptr<const DescribedFrame> described)
{
    const std::size_t signals = described ? described->message.payload.size() : 0;
    if (!described || described_.size() >= kMaxDescribed || signals_ + signals > kMaxSignals)
        return unknown_.size() < kMaxUnknown ? &unknown_[key] : nullptr;
    signals_ += signals;
    Kept& kept = described_[key];
    kept.payload.resize(signals);
    for (std::size_t i = 0; i < signals; ++i) {
        kept.payload[i].signal.history.fill(kNoPoint);
        kept.payload[i].takesTurns = !described->message.payload[i].selectedBy.empty();
    }
    kept.frame.described = std::move(described);
    return &kept;
}

void ForeignFrames::addValues(Kept& kept, const CanFrame& frame, double time)
{
    const DbcMessage& message = kept.frame.described->message;
    values_.resize(kept.payload.size());
    decodeBits(message, frame, values_);
    for (std::size_t i = 0; i < values_.size(); ++i) {
        if (!values_[i]) continue;
        KeptSignal& of = kept.payload[i];
        of.signal.bits = *values_[i];
        of.signal.add(physicalOf(message.payload[i], *values_[i]));
        if (of.usedAt) of.interval.add(time - *of.usedAt);
        of.usedAt = time;
        ++of.times;
    }
}

/// Returns the freshness limit [s]: three periods, at least kStaleAfter. The period is the file's, else that of
/// UsualInterval. A multiplexed signal takes the longer one, because it waits for its turn in the message.
double ForeignFrames::freshOf(const Kept& kept, const KeptSignal& signal)
{
    constexpr double kPeriods = 3.0;
    const double stated = kept.frame.described->message.period();
    const double usual = signal.interval.seconds();
    const double period = stated > 0.0 && !signal.takesTurns ? stated : std::max(stated, usual);
    return std::max(kStaleAfter, kPeriods * period);
}

void ForeignFrames::step(double now, std::size_t tick, std::size_t point)
{
    const std::size_t place = tick % (kBusRateTicks + 1);
    for (Kinds* kinds : {&described_, &unknown_})
        for (auto& [key, kept] : *kinds) {
            kept.counts[place] = kept.frame.frames;
            for (KeptSignal& of : kept.payload) {
                of.counts[place] = of.times;
                const bool fresh = of.usedAt && now - *of.usedAt <= freshOf(kept, of);
                of.signal.history[point] = fresh ? pointOf(*of.signal.last) : kNoPoint;
            }
        }
}

void ForeignFrames::addTo(std::vector<TappedFrame>& frames, double now, std::size_t ticks,
                          std::size_t point) const
{
    for (const Kinds* kinds : {&described_, &unknown_})
        for (const auto& [key, kept] : *kinds) frames.push_back(tapped(kept, now, ticks, point));
}

TappedFrame ForeignFrames::tapped(const Kept& kept, double now, std::size_t ticks,
                                  std::size_t point)
{
    const auto ageOf = [now](const std::optional<double>& at) {
        return at ? std::optional(std::max(0.0, now - *at)) : std::nullopt;
    };
    TappedFrame frame = kept.frame;
    frame.rate = rateOf(kept.counts, ticks);
    frame.age = ageOf(kept.usedAt);
    for (const KeptSignal& of : kept.payload) {
        frame.payload.emplace_back(of.signal).unrollHistory(point);
        frame.times.push_back({rateOf(of.counts, ticks), ageOf(of.usedAt), freshOf(kept, of)});
    }
    return frame;
}

void ForeignFrames::forgetExtremes()
{
    for (auto& [key, kept] : described_)
        for (KeptSignal& of : kept.payload) of.signal.forgetExtremes();
}

}  // namespace terratact
