#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "app/link/dbc_book.h"
#include "app/link/tapped_frame.h"

namespace terratact {

/// Estimates the usual period of a signal from its last few intervals. A burst does not shorten the period and an
/// outage does not lengthen it. A long interval counts only if another one occurred recently.
class UsualInterval {
public:
    void add(double seconds);
    double seconds() const;  ///< longest of the recent intervals, at most kMax; 0: none yet

    static constexpr double kMax = 60.0;

private:
    /// An interval beyond this multiple of the usual is a silence.
    static constexpr double kSilence = 5.0;
    std::array<double, 16> last_{};  ///< [s] ring of the counted intervals
    std::size_t counted_ = 0, taken_ = 0;
    std::size_t silence_ = 0;  ///< number of the interval that was the newest silence; 0: none
};

/// Counts the frames outside the robot's protocol and decodes those that a DBC file describes. Memory is bounded for
/// any input. FrameHistory owns and locks it.
class ForeignFrames {
public:
    static constexpr std::size_t kMaxUnknown = 64;     ///< bound on kinds that no file describes
    static constexpr std::size_t kMaxDescribed = 256;  ///< bound on kinds that a file describes
    /// Bound on decoded signals; beyond it only a frame's bytes are kept.
    static constexpr std::size_t kMaxSignals = 2000;

    /// Uses `book` from now on and forgets all frames so far; null: no descriptions. Returns the previous book, so that
    /// the caller can free it outside a lock.
    std::shared_ptr<const DbcBook> describe(std::shared_ptr<const DbcBook> book);

    /// trouble: verdict of the protocol. Returns None if a DBC file describes the frame.
    FrameTrouble add(const CanFrame& frame, FrameTrouble trouble, double time);
    /// Advances histories and rates. tick: counted from 0. point: next index of the histories.
    void step(double now, std::size_t tick, std::size_t point);

    /// Appends the frames ordered by identifier, described ones first.
    void addTo(std::vector<TappedFrame>& frames, double now, std::size_t ticks,
               std::size_t point) const;
    void forgetExtremes();
    std::uint64_t beyond() const { return beyond_; }  ///< frames beyond the bounds

private:
    using Key = std::tuple<std::uint32_t, bool, bool, bool, bool>;
    struct KeptSignal {
        TappedSignal signal;
        std::optional<double> usedAt{};  ///< [s]
        UsualInterval interval;
        bool takesTurns = false;  ///< multiplexed: not in every frame
        std::uint64_t times = 0;
        TickCounts counts{};
    };
    struct Kept {
        TappedFrame frame;
        std::optional<double> usedAt{};  ///< [s]
        TickCounts counts{};
        std::vector<KeptSignal> payload{};
    };
    using Kinds = std::map<Key, Kept>;
    Kept* keptOf(const CanFrame& frame);
    Kept* begin(const Key& key, std::shared_ptr<const DescribedFrame> described);
    void addValues(Kept& kept, const CanFrame& frame, double time);
    static TappedFrame tapped(const Kept& kept, double now, std::size_t ticks, std::size_t point);
    static double freshOf(const Kept& kept, const KeptSignal& signal);

    std::shared_ptr<const DbcBook> book_;
    Kinds described_, unknown_;
    std::size_t signals_ = 0;  ///< signals of all described frames
    std::uint64_t beyond_ = 0;
    std::vector<std::optional<std::uint64_t>> values_;  // raw values of one frame
};

}  // namespace terratact
