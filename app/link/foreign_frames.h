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

/// How often a signal comes as a rule, by its last few intervals.  Neither does a burst make it more frequent nor an
/// outage rarer: a silence counts where it is not the only one of late.
class UsualInterval {
public:
    void take(double seconds);
    double seconds() const;  ///< the longest of the last few, at most kMax; 0: there was none yet

    static constexpr double kMax = 60.0;

private:
    static constexpr double kSilence = 5.0;  ///< times the usual
    std::array<double, 16> last_{};          ///< [s] a ring of those that count
    std::size_t counted_ = 0, taken_ = 0;
    std::size_t silence_ =
        0;  ///< the how-manieth that was taken was the newest silence; 0: none was
};

/// The frames of a bus that the robot's protocol does not know: counted, and decoded where a DBC file describes
/// them.  Bounded whatever comes.  A part of FrameHistory, which guards it.
class ForeignFrames {
public:
    static constexpr std::size_t kMaxUnknown = 64;     ///< kinds of which only the bytes are known
    static constexpr std::size_t kMaxDescribed = 256;  ///< kinds that a file describes
    static constexpr std::size_t kMaxSignals = 2000;   ///< of those; beyond, only the bytes count

    /// From now on; what came so far is forgotten.  book: null: none.  The one before, which may be large to free.
    std::shared_ptr<const DbcBook> describe(std::shared_ptr<const DbcBook> book);

    /// trouble: as the protocol has it.  None where a DBC file describes the frame.
    FrameTrouble take(const CanFrame& frame, FrameTrouble trouble, double time);
    /// tick: counted from 0.  point: where histories go on.
    void step(double now, std::size_t tick, std::size_t point);

    /// Described ones first, in the order of identifiers.
    void addTo(std::vector<TappedFrame>& frames, double now, std::size_t ticks,
               std::size_t point) const;
    void forgetExtremes();
    std::uint64_t beyond() const { return beyond_; }  ///< frames that found no room

private:
    using Key = std::tuple<std::uint32_t, bool, bool, bool, bool>;
    struct KeptSignal {
        TappedSignal signal;
        std::optional<double> usedAt{};  ///< [s]
        UsualInterval interval;
        bool takesTurns = false;  ///< multiplexed
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
    void takeValues(Kept& kept, const CanFrame& frame, double time);
    static TappedFrame tapped(const Kept& kept, double now, std::size_t ticks, std::size_t point);
    static double freshOf(const Kept& kept, const KeptSignal& signal);

    std::shared_ptr<const DbcBook> book_;
    Kinds described_, unknown_;
    std::size_t signals_ = 0;  ///< of the described ones
    std::uint64_t beyond_ = 0;
    std::vector<std::optional<std::uint64_t>> values_;  // of one frame, as they were sent
};

}  // namespace terratact
