#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "app/link/foreign_frames.h"
#include "app/link/tapped_frame.h"
#include "core/limits.h"
#include "core/wire/frame_validator.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Traffic of the last seconds.
struct BusLoad {
    double framesPerSecond = 0.0;
    double fewestBits = 0.0,
           mostBits = 0.0;     ///< [bit/s] bounds without and with the maximum stuff bits
    std::uint64_t frames = 0;  ///< since the bus was opened
    /// Since the bus was opened, by FrameTrouble.
    std::array<std::uint64_t, kFrameTroubles> troubles{};
    std::uint64_t beyond = 0;  ///< frames of unknown kinds beyond the table's bound
};

/// Keeps the data of received frames that the pages show. These are newest value, extremes and history per signal,
/// rates, and the newest raw frames. All memory is bounded. add() and tick() belong to the receiving thread; any
/// thread may call the others.
class FrameHistory {
public:
    static constexpr std::size_t kTrace = 2000;    ///< number of raw frames kept
    static constexpr double kTick = kBusTick;      ///< [s]
    static constexpr double kFresh = kStaleAfter;  ///< [s] an older value is stale

    FrameHistory();

    /// Called with every frame, in the receiving thread; it must be quick and call nothing of this object.
    using Listener = std::function<void(const BusFrame& received, const JudgedFrame& judged)>;
    void listen(const Listener& listener);  ///< empty: nothing is called any more

    /// Adds a frame and the verdict on it.
    void add(const BusFrame& received, const JudgedFrame& judged);
    /// Advances histories and rates; call a few times per kTick. now: [s] on the bus's clock.
    void tick(double now);
    /// Uses these DBC descriptions for frames outside the protocol from now on; null: none.
    void describe(std::shared_ptr<const DbcBook> book);

    BusLoad load() const;
    /// Returns frames of the protocol, then ForeignFrames.
    std::vector<TappedFrame> frames(double now) const;
    /// Returns the time [s] since the last usable frame of a kind; empty if there was none.
    std::optional<double> age(FrameKind kind, double now) const;
    std::vector<TracedFrame> trace() const;  ///< oldest first
    void forgetExtremes();

private:
    struct Kept {
        TappedFrame frame;
        std::optional<double> usedAt{};  ///< [s]
        TickCounts counts{};
    };
    struct Totals {
        double time = 0.0;
        std::uint64_t frames = 0, fewestBits = 0, mostBits = 0;
    };
    void keep(Kept& kept, const JudgedFrame& judged, const BusFrame& received);
    void step(double now);

    mutable std::mutex mutex_;  // guards the members below
    std::vector<Kept> known_;   // indexed by FrameKind
    ForeignFrames foreign_;
    std::vector<TracedFrame> trace_;  // ring: frame number n is at (n − 1) % kTrace
    std::uint64_t frames_ = 0, fewestBits_ = 0, mostBits_ = 0;
    std::array<std::uint64_t, kFrameTroubles> troubles_{};
    std::array<Totals, kBusRateTicks + 1> totals_{};
    std::size_t ticks_ = 0;  ///< ticks taken
    std::size_t point_ = 0;  ///< next index of the histories
    std::optional<double> nextTick_;
    Listener listener_;
};

}  // namespace terratact
