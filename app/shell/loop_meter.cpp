#include "app/shell/loop_meter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace terratact {
namespace {

constexpr double kMaxFrames = 25.0;  // [Hz]

std::size_t beatsPerMinute(double period)
{
    if (!(period > 0.0)) throw std::invalid_argument("LoopMeter: the period must be over 0");
    return static_cast<std::size_t>(LoopMeter::kMinute / period);
}

}  // namespace

double NewestValues::quantile(double p) const
{
    if (!(p >= 0.0 && p <= 1.0)) throw std::invalid_argument("quantile: p must be in 0 … 1");
    if (values_.empty()) return 0.0;
    std::vector<double> values = values_;
    const double rank = std::ceil(p * static_cast<double>(values.size()));
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

LoopMeter::LoopMeter(double period)
    : period_(period), lateness_(beatsPerMinute(period)),
      frames_(static_cast<std::size_t>(kMinute * kMaxFrames)),
      latencies_(static_cast<std::size_t>(kMinute * kMaxFrames))
{
}

void LoopMeter::beat(double now)
{
    if (began_) lateness_.add(std::max(0.0, now - last_ - period_));
    last_ = now;
    began_ = true;
}

void LoopMeter::frame(double seconds, double latency)
{
    frames_.add(seconds);
    if (latency >= 0.0) latencies_.add(latency);
}

}  // namespace terratact
