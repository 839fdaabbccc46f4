#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "app/link/can_text.h"
#include "core/wire/can_frame.h"

namespace terratact {

/// Length [bit] of a classic CAN frame including the interframe space. fewest: without stuff bits; most: with the
/// maximum stuff bits. CAN FD frames (unknown bit rates) and error frames count as 0.
struct FrameBits {
    int fewest = 0, most = 0;
};
FrameBits bitsOf(const CanFrame& frame);

/// Key of a kind of frame: distinguishes frames that share an identifier, and multiple contents of one identifier.
struct FrameKey {
    bool error = false, extended = false, remote = false, fd = false;
    std::uint32_t id = 0;
    std::string name{};  ///< as in FrameWords
    bool operator<(const FrameKey& other) const;
};
FrameKey keyOf(const CanFrame& frame, const FrameWords& words);

/// Counts for one kind of frame.
struct FrameCount {
    CanFrame last;         ///< newest frame
    FrameWords words;      ///< decoded content of `last`
    double first = 0.0;    ///< [s] time of the first frame
    double time = 0.0;     ///< [s] time of the newest frame
    double longest = 0.0;  ///< [s] longest interval between two frames
    std::uint64_t frames = 0;
    std::array<std::uint64_t, kFrameTroubles> troubles{};  ///< indexed by FrameTrouble

    std::uint64_t of(FrameTrouble trouble) const
    {
        return troubles[static_cast<std::size_t>(trouble)];
    }
};

/// Counts the frames of one bus.
class BusStatistics {
public:
    /// Bound of counts(); further kinds are counted together.
    static constexpr std::size_t kMaxKeys = 4096;

    void add(const CanFrame& frame, const FrameWords& words, double now);

    const std::map<FrameKey, FrameCount>& counts() const { return counts_; }
    std::uint64_t frames() const { return frames_; }
    std::uint64_t beyond() const { return beyond_; }  ///< frames whose kind is not in counts()
    std::uint64_t fewestBits() const { return fewestBits_; }
    std::uint64_t mostBits() const { return mostBits_; }

private:
    std::map<FrameKey, FrameCount> counts_;
    std::uint64_t frames_ = 0, beyond_ = 0, fewestBits_ = 0, mostBits_ = 0;
};

/// Returns a table with a line for each kind of frame, and the faults found. seconds: time span of the frames; nullopt:
/// unknown.
std::string summaryText(const BusStatistics& statistics, std::optional<double> seconds);

}  // namespace terratact
