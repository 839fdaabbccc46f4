#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/plotting/plot_signal.h"
#include "core/base/message.h"
#include "core/series/series_view.h"

namespace terratact {

/// A span of time, and how finely it is shown.
struct PlotSpan {
    double from = 0.0, to = 1.0;  ///< [s], from < to
    std::size_t columns = 1000;   ///< pixels, at least 2
    double cursor = 0.0;          ///< [s] time of SeriesView::atCursor
    bool operator==(const PlotSpan&) const = default;
};

/// A source of plotted signals. Only chosen signals take memory, a fixed amount each. Calls from one thread.
class PlotSource {
public:
    static constexpr std::size_t kMaxChosen = 12;  ///< bound on chosen signals

    virtual ~PlotSource() = default;

    /// Returns all signals that can be chosen now.
    virtual std::vector<PlotSignal> catalogue() const = 0;
    /// Chooses the signals of these keys, at most kMaxChosen; values of those chosen before stay. A key that names no
    /// signal yet is kept: a frame may come later.
    virtual void choose(const std::vector<std::string>& keys) = 0;
    /// Returns what a plot shows of a chosen signal; empty for another key.
    virtual SeriesView view(const std::string& key, const PlotSpan& span) = 0;

    virtual double begin() const = 0;  ///< [s] earliest time
    virtual double end() const = 0;    ///< [s] latest time
    /// Returns a number that changes with catalogue() or values.
    virtual std::uint64_t version() const = 0;
    /// Returns the share of the values that is read, 0 … 1.
    virtual double share() const { return 1.0; }
    /// Returns why values are missing; empty: none are.
    virtual Message trouble() const { return {}; }
};

}  // namespace terratact
