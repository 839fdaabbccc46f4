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

inline constexpr double kBusTick = 0.1;           ///< [s] between two points of a history
inline constexpr std::size_t kBusRateTicks = 20;  ///< rates are over so many

/// How many there were at the last ticks, tick n at n % size().
using TickCounts = std::array<std::uint64_t, kBusRateTicks + 1>;

/// [Hz] over them, after so many ticks.
inline double rateOf(const TickCounts& counts, std::size_t ticks)
{
    if (ticks < 2) return 0.0;
    const std::size_t steps = std::min(ticks - 1, kBusRateTicks);
    const std::uint64_t now = counts[(ticks - 1) % counts.size()];
    const std::uint64_t before = counts[(ticks - 1 - steps) % counts.size()];
    return static_cast<double>(now - before) / (static_cast<double>(steps) * kBusTick);
}

/// One signal since the bus was opened or the extremes were forgotten.
struct TappedSignal {
    static constexpr std::size_t kPoints = 120;
    std::optional<double> last, least, most;  ///< SI; empty before the first that was measured
    /// Every kBusTick; NaN: none was fresh.  Newest last, but a ring in the tap.
    std::array<float, kPoints> history{};

    std::uint64_t bits = 0;  ///< `last` as it was sent, of a signal that a DBC file describes

    /// What is not finite has neither least nor most.
    void take(double value)
    {
        last = value;
        if (!std::isfinite(value)) return;
        least = std::min(least.value_or(value), value);
        most = std::max(most.value_or(value), value);
    }
    void forgetExtremes() { least = most = std::nullopt; }
    /// point: where the ring goes on.
    void unrollHistory(std::size_t point)
    {
        std::rotate(history.begin(), history.begin() + static_cast<std::ptrdiff_t>(point),
                    history.end());
    }
};

/// When a signal of a DBC file came: of a multiplexed one, not with every frame.
struct SignalTimes {
    double rate = 0.0;           ///< [Hz] over the last seconds
    std::optional<double> age;   ///< [s]
    double fresh = kStaleAfter;  ///< [s] an older value is none of now
};

/// The frames of one kind.
struct TappedFrame {
    std::optional<FrameKind> kind;  ///< empty: not of the robot's protocol
    CanFrame newest{};
    std::uint64_t frames = 0;
    double rate = 0.0;          ///< [Hz] over the last seconds
    std::optional<double> age;  ///< [s] since the last that may be used
    std::array<std::uint64_t, kFrameTroubles> troubles{};
    bool isMeasured = true;               ///< false: the robot says its values were not measured
    std::vector<TappedSignal> payload{};  ///< as in the layout, or in the DBC file
    std::shared_ptr<const DescribedFrame> described{};  ///< by a DBC file; null: by none
    std::vector<SignalTimes> times{};                   ///< of the payload of a described one
};

}  // namespace terratact
