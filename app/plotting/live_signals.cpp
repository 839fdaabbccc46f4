#include "app/plotting/live_signals.h"

#include <algorithm>

#include "app/plotting/telemetry_signals.h"

namespace terratact {

void LiveSignals::put(std::size_t signal, double time, double value)
{
    chosen_[signal].series->add(time, value);
    ++version_;
}

void LiveSignals::add(const BusFrame& received, const JudgedFrame& judged)
{
    const std::scoped_lock lock(mutex_);
    if (!judged.kind && catalogue_.add(received.frame)) ++version_;
    if (frames_.isIdle()) return;
    values_.clear();
    frames_.decode(received.frame, judged, values_);
    for (const FrameSignals::Value& value : values_) put(value.signal, received.time, value.value);
}

void LiveSignals::add(const Received& telemetry)
{
    const std::scoped_lock lock(mutex_);
    const double time = std::chrono::duration<double>(telemetry.arrived.time_since_epoch()).count();
    for (const auto& [index, signal] : telemetry_)
        if (const auto value = telemetryValue(index, telemetry.sample.measurement))
            put(signal, time, *value);
}

void LiveSignals::add(const EstimateFacts& estimate, double time)
{
    std::vector<std::optional<double>> values = estimateValues(estimate);
    const std::scoped_lock lock(mutex_);
    newest_ = std::move(values);
    newestAt_ = time;
    addEstimateValues();
}

/// Adds the values of the newest estimate to the series that do not have them yet.
void LiveSignals::addEstimateValues()
{
    if (newest_.empty()) return;
    for (const auto& [index, signal] : estimate_)
        if (newest_[index] && chosen_[signal].series->last().value_or(begin_ - 1.0) < newestAt_)
            put(signal, newestAt_, *newest_[index]);
}

void LiveSignals::addFrameRate(double framesPerSecond, double time)
{
    const std::scoped_lock lock(mutex_);
    if (frameRate_) put(*frameRate_, time, framesPerSecond);
}

void LiveSignals::describe(std::shared_ptr<const DbcBook> book)
{
    const std::scoped_lock lock(mutex_);
    frames_.describe(book);
    catalogue_.describe(std::move(book));
    ++version_;
}

void LiveSignals::setNow(double now)
{
    const std::scoped_lock lock(mutex_);
    now_ = now;
}

std::vector<PlotSignal> LiveSignals::catalogue() const
{
    const std::scoped_lock lock(mutex_);
    return catalogue_.all();
}

void LiveSignals::choose(const std::vector<std::string>& keys)
{
    std::vector<Chosen> chosen;
    const std::size_t count = std::min(keys.size(), kMaxChosen);
    chosen.reserve(count);
    const std::scoped_lock lock(mutex_);
    for (std::size_t i = 0; i < count; ++i) {
        const auto kept = std::find_if(chosen_.begin(), chosen_.end(), [&](const Chosen& c) {
            return c.series && c.key == keys[i];
        });
        chosen.push_back({keys[i], kept != chosen_.end() ? std::move(kept->series)
                                                         : std::make_unique<SignalSeries>(begin_)});
    }
    chosen_ = std::move(chosen);
    frames_.choose({keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(count)});
    telemetry_.clear();
    estimate_.clear();
    frameRate_.reset();
    const auto telemetry = telemetrySignals(), estimate = estimateSignals();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        const std::string& key = chosen_[i].key;
        for (std::size_t k = 0; k < telemetry.size(); ++k)
            if (telemetry[k].key() == key) telemetry_.emplace_back(k, i);
        for (std::size_t k = 0; k < estimate.size(); ++k)
            if (estimate[k].key() == key) estimate_.emplace_back(k, i);
        if (key == frameRateKey()) frameRate_ = i;
    }
    addEstimateValues();
    ++version_;
}

SeriesView LiveSignals::view(const std::string& key, const PlotSpan& span)
{
    const std::scoped_lock lock(mutex_);
    const auto found =
        std::find_if(chosen_.begin(), chosen_.end(), [&](const Chosen& c) { return c.key == key; });
    if (found == chosen_.end()) return {};
    return viewOf(*found->series, span.from, span.to, span.columns, span.cursor,
                  found->series->resolutionFrom(span.from));
}

double LiveSignals::end() const
{
    const std::scoped_lock lock(mutex_);
    return now_;
}

std::uint64_t LiveSignals::version() const
{
    const std::scoped_lock lock(mutex_);
    return version_;
}

}  // namespace terratact
