#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/link/dbc_book.h"
#include "core/limits.h"
#include "core/wire/frame_layout.h"
#include "core/wire/frame_trouble.h"

namespace terratact {

inline constexpr double kBusTick = 0.1;           ///< [s] interval between history points
inline constexpr std::size_t kBusRateTicks = 20;  ///< window of the rates in ticks

/// Frame counts at the last ticks; tick n is at n % size().
using TickCounts = std::array<std::uint64_t, kBusRateTicks + 1>;

/// Returns the rate [Hz] over the window after `ticks` ticks.
inline double rateOf(const TickCounts& counts, std::size_t ticks)
{
    if (ticks < 2) return 0.0;
    const std::size_t steps = std::min(ticks - 1, kBusRateTicks);
    const std::uint64_t now = counts[(ticks - 1) % counts.size()];
    const std::uint64_t before = counts[(ticks - 1 - steps) % counts.size()];
    return static_cast<double>(now - before) / (static_cast<double>(steps) * kBusTick);
}

/// One signal since the bus was opened, or since its extremes were reset.
struct TappedSignal {
    static constexpr std::size_t kPoints = 120;
    std::optional<double> last, least, most;  ///< SI units; empty before the first measured value
    /// One point per kBusTick, newest last; NaN: no fresh value. A ring inside FrameHistory.
    std::array<float, kPoints> history{};

    std::uint64_t bits = 0;  ///< raw bits of `last`, for a signal of a DBC file

    /// Adds a value; one that is not finite leaves the extremes unchanged.
    void add(double value)
    {
        last = value;
        if (!std::isfinite(value)) return;
        least = std::min(least.value_or(value), value);
        most = std::max(most.value_or(value), value);
    }
    void forgetExtremes() { least = most = std::nullopt; }
    /// Rotates the ring so that the newest point is last. point: next index of the ring.
    void unrollHistory(std::size_t point)
    {
        std::rotate(history.begin(), history.begin() + static_cast<std::ptrdiff_t>(point),
                    history.end());
    }
};

/// Timing of a DBC signal; a multiplexed signal does not come with every frame.
struct SignalTimes {
    double rate = 0.0;           ///< [Hz] over the last seconds
    std::optional<double> age;   ///< [s]
    double fresh = kStaleAfter;  ///< [s] an older value is stale
};

/// The frames of one kind.
struct TappedFrame {
    std::optional<FrameKind> kind;  ///< empty: outside the robot's protocol
    CanFrame newest{};
    std::uint64_t frames = 0;
    double rate = 0.0;          ///< [Hz] over the last seconds
    std::optional<double> age;  ///< [s] since the last usable frame
    std::array<std::uint64_t, kFrameTroubles> troubles{};
    bool isMeasured = true;  ///< false: the robot states that its values were not measured
    std::vector<TappedSignal> payload{};  ///< in the order of the layout or DBC message
    std::shared_ptr<const DescribedFrame> described{};  ///< description from a DBC file; null: none
    std::vector<SignalTimes> times{};  ///< timing of the payload of a described frame
};

}  // namespace terratact
