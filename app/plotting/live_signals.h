#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/link/acquisition.h"
#include "app/plotting/estimate_signals.h"
#include "app/plotting/frame_signals.h"
#include "app/plotting/plot_source.h"
#include "app/plotting/signal_catalogue.h"
#include "core/series/signal_series.h"
#include "drivers/can_bus.h"

namespace terratact {

/// The plotted signals of a running console. Chosen signals are kept from their choice on, in fixed memory. Every frame
/// and every line of telemetry counts, independent of the window's rate. The add functions may be called from any thread; they
/// take microseconds. Times are those of the steady clock [s].
class LiveSignals final : public PlotSource {
public:
    explicit LiveSignals(double now) : begin_(now), now_(now) {}

    void add(const BusFrame& received, const JudgedFrame& judged);
    void add(const Received& telemetry);
    void add(const EstimateFacts& estimate, double time);
    void addFrameRate(double framesPerSecond, double time);
    /// Uses these DBC descriptions from now on; null: none.
    void describe(std::shared_ptr<const DbcBook> book);
    void setNow(double now);

    std::vector<PlotSignal> catalogue() const override;
    void choose(const std::vector<std::string>& keys) override;
    SeriesView view(const std::string& key, const PlotSpan& span) override;
    double begin() const override { return begin_; }
    double end() const override;
    std::uint64_t version() const override;

private:
    struct Chosen {
        std::string key;
        std::unique_ptr<SignalSeries> series;
    };
    void addEstimateValues();
    void put(std::size_t signal, double time, double value);

    const double begin_;
    mutable std::mutex mutex_;  // guards the members below
    double now_;
    std::vector<Chosen> chosen_;
    // Index of the signal among those of its origin, and in chosen_.
    std::vector<std::pair<std::size_t, std::size_t>> telemetry_, estimate_;
    std::optional<std::size_t> frameRate_;
    FrameSignals frames_;
    std::vector<FrameSignals::Value> values_;  // of one frame
    SignalCatalogue catalogue_;
    std::vector<std::optional<double>> newest_;  // values of the newest estimate
    double newestAt_ = 0.0;                      // [s]
    std::uint64_t version_ = 1;
};

}  // namespace terratact
