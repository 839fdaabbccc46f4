#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "app/link/foreign_frames.h"
#include "app/link/frame_validator.h"
#include "app/link/tapped_frame.h"
#include "core/limits.h"
#include "drivers/can_bus.h"

namespace terratact {

/// What passed in the last seconds.
struct BusLoad {
    double framesPerSecond = 0.0;
    double fewestBits = 0.0,
           mostBits = 0.0;     ///< [bit/s] without stuff bits, and with all that can be
    std::uint64_t frames = 0;  ///< since the bus was opened
    std::array<std::uint64_t, kFrameTroubles> troubles{};  ///< likewise, by FrameTrouble
    std::uint64_t beyond = 0;  ///< frames of unknown kinds that found no room in the table
};

/// Looks at every frame in the thread that receives them and keeps what pages show: the newest value, extremes
/// and history of each signal, rates, and the newest frames as they were.  Bounded in everything.  take() and
/// tick() belong to one thread; all else may be called from any.
class FrameHistory {
public:
    static constexpr std::size_t kTrace = 2000;    ///< frames
    static constexpr double kTick = kBusTick;      ///< [s]
    static constexpr double kFresh = kStaleAfter;  ///< [s] an older value is none of now

    FrameHistory();

    void take(std::span<const BusFrame> frames);
    /// Histories and rates go on; to be called a few times per kTick.  now: [s] on the bus's clock.
    void tick(double now);
    /// What DBC files say of frames that are not the robot's, from now on; null: nothing.
    void describe(std::shared_ptr<const DbcBook> book);

    BusLoad load() const;
    std::vector<TappedFrame> frames(double now) const;  ///< the robot's, then ForeignFrames
    /// [s] since the last frame of a kind that may be used; empty: there was none.
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
    void take(const BusFrame& frame);
    void keep(Kept& kept, const JudgedFrame& judged, const BusFrame& received);
    void step(double now);

    FrameValidator judge_;

    mutable std::mutex mutex_;  // guards what follows
    std::vector<Kept> known_;   // in the order of FrameKind
    ForeignFrames foreign_;
    std::vector<TracedFrame> trace_;  // a ring: frame number n is at (n − 1) % kTrace
    std::uint64_t frames_ = 0, fewestBits_ = 0, mostBits_ = 0;
    std::array<std::uint64_t, kFrameTroubles> troubles_{};
    std::array<Totals, kBusRateTicks + 1> totals_{};
    std::size_t ticks_ = 0;  ///< taken
    std::size_t point_ = 0;  ///< where histories go on
    std::optional<double> nextTick_;
};

}  // namespace terratact
