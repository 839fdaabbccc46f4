#include "app/link/bus_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace terratact {
namespace {

// Returns frames per second; a dash if the time is unknown.
std::string rateText(const FrameCount& count)
{
    const double seconds = count.time - count.first;
    if (seconds <= 0.0) return "-";
    return fmt::format("{:.1f}", static_cast<double>(count.frames - 1) / seconds);
}

struct Sums {
    std::uint64_t checksum = 0, sequence = 0, gaps = 0, other = 0, unknown = 0;
    std::size_t unknownKinds = 0;
};

Sums sumsOf(const BusStatistics& statistics)
{
    Sums sums;
    for (const auto& [key, count] : statistics.counts()) {
        sums.checksum += count.of(FrameTrouble::WrongChecksum);
        sums.sequence += count.of(FrameTrouble::WrongSequence);
        sums.gaps += count.of(FrameTrouble::Gap);
        sums.other += count.of(FrameTrouble::Other);
        sums.unknown += count.of(FrameTrouble::Unknown);
        if (count.of(FrameTrouble::Unknown) > 0) ++sums.unknownKinds;
    }
    return sums;
}

}  // namespace

FrameBits bitsOf(const CanFrame& frame)
{
    if (frame.fd || frame.error) return {};
    const int data = frame.remote ? 0 : 8 * std::min<int>(frame.length, 8);
    // Start bit, identifier, control, data and checksum are stuffed: one bit after five equal bits. A stuff bit may
    // begin the next five, so from then on after every four.
    const int stuffed = (frame.extended ? 54 : 34) + data;
    constexpr int kRest = 13;  // delimiters, acknowledgement, end of frame, interframe space
    return {stuffed + kRest, stuffed + kRest + (stuffed - 1) / 4};
}

FrameKey keyOf(const CanFrame& frame, const FrameWords& words)
{
    return {frame.error, frame.extended, frame.remote, frame.fd, frame.id, words.name};
}

bool FrameKey::operator<(const FrameKey& other) const
{
    return std::tie(error, extended, remote, fd, id, name)
         < std::tie(other.error, other.extended, other.remote, other.fd, other.id, other.name);
}

void BusStatistics::add(const CanFrame& frame, const FrameWords& words, double now)
{
    ++frames_;
    const FrameBits bits = bitsOf(frame);
    fewestBits_ += static_cast<std::uint64_t>(bits.fewest);
    mostBits_ += static_cast<std::uint64_t>(bits.most);
    const FrameKey key = keyOf(frame, words);
    if (counts_.size() >= kMaxKeys && !counts_.contains(key)) {
        ++beyond_;
        return;
    }
    FrameCount& count = counts_[key];
    if (count.frames == 0) count.first = now;
    if (count.frames > 0) count.longest = std::max(count.longest, now - count.time);
    count.last = frame;
    count.words = words;
    count.time = now;
    ++count.frames;
    ++count.troubles[static_cast<std::size_t>(words.trouble)];
}

std::string summaryText(const BusStatistics& statistics, std::optional<double> seconds)
{
    std::string text =
        fmt::format("{:<9} {:<26} {:>8} {:>7} {:>9} {:>8} {:>8} {:>5} {:>6}\n", "id", "frame",
                    "frames", "per s", "longest s", "checksum", "sequence", "gaps", "other");
    for (const auto& [key, count] : statistics.counts())
        text += fmt::format(
            "{:<9} {:<26} {:>8} {:>7} {:>9} {:>8} {:>8} {:>5} {:>6}\n", idText(count.last),
            key.name.empty() ? "unknown" : key.name, count.frames, rateText(count),
            seconds && count.frames > 1 ? fmt::format("{:.3f}", count.longest) : "-",
            count.of(FrameTrouble::WrongChecksum), count.of(FrameTrouble::WrongSequence),
            count.of(FrameTrouble::Gap), count.of(FrameTrouble::Other));
    const Sums sums = sumsOf(statistics);
    text += fmt::format("{} frames", statistics.frames());
    if (seconds) text += fmt::format(" in {:.3f} s", *seconds);
    text += fmt::format(
        ": {} with a wrong checksum, {} out of sequence, {} gaps, {} otherwise wrong; {} "
        "frames of {} unknown kinds\n",
        sums.checksum, sums.sequence, sums.gaps, sums.other, sums.unknown, sums.unknownKinds);
    if (statistics.beyond() > 0)
        text += fmt::format("{} more frames of kinds beyond the first {}\n", statistics.beyond(),
                            BusStatistics::kMaxKeys);
    return text;
}

}  // namespace terratact
