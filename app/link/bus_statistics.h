#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "app/link/can_text.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// Bits of a classic frame on the bus, with the pause behind it.  fewest: without stuff bits; most: with as many
/// as its length allows.  A CAN FD frame counts as none (its two bit rates are not known), an error frame
/// either.
struct FrameBits {
    int fewest = 0, most = 0;
};
FrameBits bitsOf(const CanFrame& frame);

/// Tells frames apart that share an identifier and nothing else, or are several things under one.
struct FrameKey {
    bool error = false, extended = false, remote = false, fd = false;
    std::uint32_t id = 0;
    std::string name{};  ///< in FrameWords
    bool operator<(const FrameKey& other) const;
};
FrameKey keyOf(const CanFrame& frame, const FrameWords& words);

/// What came of one kind.
struct FrameCount {
    CanFrame last;         ///< the newest one
    FrameWords words;      ///< and what it says
    double first = 0.0;    ///< [s] when the first came
    double time = 0.0;     ///< [s] and the newest
    double longest = 0.0;  ///< [s] between two
    std::uint64_t frames = 0;
    std::array<std::uint64_t, kFrameTroubles> troubles{};  ///< by FrameTrouble

    std::uint64_t of(FrameTrouble trouble) const
    {
        return troubles[static_cast<std::size_t>(trouble)];
    }
};

/// Counts the frames of one bus.
class BusStatistics {
public:
    static constexpr std::size_t kMaxKeys =
        4096;  ///< frames beyond so many kinds are counted together

    void take(const CanFrame& frame, const FrameWords& words, double now);

    const std::map<FrameKey, FrameCount>& counts() const { return counts_; }
    std::uint64_t frames() const { return frames_; }
    std::uint64_t beyond() const { return beyond_; }  ///< of a kind that is not in counts()
    std::uint64_t fewestBits() const { return fewestBits_; }
    std::uint64_t mostBits() const { return mostBits_; }

private:
    std::map<FrameKey, FrameCount> counts_;
    std::uint64_t frames_ = 0, beyond_ = 0, fewestBits_ = 0, mostBits_ = 0;
};

/// A table of the counts, a line for each kind of frame, and what was wrong.  seconds: over which they came;
/// nullopt: not known.
std::string summaryText(const BusStatistics& statistics, std::optional<double> seconds);

}  // namespace terratact
