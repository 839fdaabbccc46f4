#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "app/frame_judge.h"
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

/// One signal since the bus was opened or the extremes were forgotten.
struct TappedSignal {
    static constexpr std::size_t kPoints = 120;
    std::optional<double> last, least, most;  ///< SI; empty before the first that was measured
    std::array<float, kPoints>
        history{};  ///< newest last, every BusTap::kTick; NaN: none was fresh
};

/// The frames of one kind.
struct TappedFrame {
    std::optional<FrameKind> kind;  ///< empty: not in the DBC
    CanFrame newest{};
    std::uint64_t frames = 0;
    double rate = 0.0;          ///< [Hz] over the last seconds
    std::optional<double> age;  ///< [s] since the last that may be used
    std::array<std::uint64_t, kFrameTroubles> troubles{};
    bool isMeasured = true;               ///< false: the robot says its values were not measured
    std::vector<TappedSignal> payload{};  ///< as in the layout
};

/// Looks at every frame in the thread that receives them and keeps what pages show: the newest value, extremes
/// and history of each signal, rates, and the newest frames as they were.  Bounded in everything.  take() and
/// tick() belong to one thread; all else may be called from any.
class BusTap {
public:
    static constexpr std::size_t kTrace = 2000;      ///< frames
    static constexpr std::size_t kMostUnknown = 64;  ///< kinds that are not in the DBC
    static constexpr double kTick = 0.1;             ///< [s]
    static constexpr std::size_t kRateTicks = 20;    ///< rates are over so many
    static constexpr double kFresh = 0.15;           ///< [s] an older value is none of now

    BusTap();

    void take(std::span<const BusFrame> frames);
    /// Histories and rates go on; to be called a few times per kTick.  now: [s] on the bus's clock.
    void tick(double now);

    BusLoad load() const;
    std::vector<TappedFrame>
    frames(double now) const;  ///< in the order of identifiers, unknown ones last
    /// [s] since the last frame of a kind that may be used; empty: there was none.
    std::optional<double> age(FrameKind kind, double now) const;
    std::vector<TracedFrame> trace() const;  ///< oldest first
    void forgetExtremes();

private:
    template <class T>
    using Ring = std::array<T, kRateTicks + 1>;
    using UnknownKey = std::tuple<std::uint32_t, bool, bool, bool, bool>;
    struct Kept {
        TappedFrame frame;
        std::optional<double> usedAt{};  ///< [s]
        Ring<std::uint64_t> counts{};    ///< by tick
    };
    struct Totals {
        double time = 0.0;
        std::uint64_t frames = 0, fewestBits = 0, mostBits = 0;
    };
    void take(const BusFrame& frame);
    void keep(Kept& kept, const JudgedFrame& judged, double time);
    Kept* unknown(const CanFrame& frame);
    void step(double now);
    double rate(const Ring<std::uint64_t>& counts) const;

    FrameJudge judge_;

    mutable std::mutex mutex_;  // guards what follows
    std::vector<Kept> known_;   // in the order of FrameKind
    std::map<UnknownKey, Kept> unknown_;
    std::vector<TracedFrame> trace_;  // a ring: frame number n is at (n − 1) % kTrace
    std::uint64_t frames_ = 0, fewestBits_ = 0, mostBits_ = 0, beyond_ = 0;
    std::array<std::uint64_t, kFrameTroubles> troubles_{};
    Ring<Totals> totals_{};
    std::size_t ticks_ = 0;  ///< taken
    std::size_t point_ = 0;  ///< where histories go on
    std::optional<double> nextTick_;
};

}  // namespace terratact
