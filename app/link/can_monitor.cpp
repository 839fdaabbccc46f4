#include "app/link/can_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

constexpr double kWindow = 2.0;  // [s] window of the rates

std::string rowText(const FrameCount& count)
{
    const std::string said = contentText(count.last, count.words);
    const bool isFine = count.words.trouble == FrameTrouble::None;
    return isFine ? said : said + " (" + count.words.verdict + ")";
}

}  // namespace

CanMonitor::CanMonitor(CanProtocol protocol, double bitrate, std::shared_ptr<const DbcBook> book)
    : reader_(frameReader(protocol, std::move(book))), bitrate_(bitrate)
{
    if (!(bitrate > 0.0)) throw std::invalid_argument("CanMonitor: the bitrate must be over 0");
}

void CanMonitor::add(const BusFrame& frame)
{
    statistics_.add(frame.frame, reader_->read(frame.frame, frame.time), frame.time);
}

void CanMonitor::mark(double now)
{
    Mark mark{now, statistics_.fewestBits(), statistics_.mostBits(), {}};
    for (const auto& [key, count] : statistics_.counts()) mark.frames[key] = count.frames;
    marks_.push_back(std::move(mark));
    while (marks_.size() > 2 && marks_[1].time <= now - kWindow) marks_.pop_front();
}

double CanMonitor::seconds() const
{
    return marks_.empty() ? 0.0 : marks_.back().time - marks_.front().time;
}

std::string CanMonitor::rateText(const FrameKey& key) const
{
    if (seconds() <= 0.0) return "-";
    const auto framesAt = [&](const Mark& mark) {
        const auto found = mark.frames.find(key);
        return found == mark.frames.end() ? std::uint64_t{0} : found->second;
    };
    const std::uint64_t frames = framesAt(marks_.back()) - framesAt(marks_.front());
    return fmt::format("{:.1f}", static_cast<double>(frames) / seconds());
}

std::string CanMonitor::headline(const std::string& state, const BusCounters& counters) const
{
    std::string load = "-";
    if (seconds() > 0.0) {
        const auto percent = [&](std::uint64_t from, std::uint64_t to) {
            return 100.0 * static_cast<double>(to - from) / (bitrate_ * seconds());
        };
        load = fmt::format("{:.1f} to {:.1f} %",
                           percent(marks_.front().fewestBits, marks_.back().fewestBits),
                           percent(marks_.front().mostBits, marks_.back().mostBits));
    }
    return fmt::format("{}; load {} of {:g} kbit/s, {} frames, {} dropped, {} error frames", state,
                       load, bitrate_ / 1000.0, counters.received, counters.dropped,
                       counters.errorFrames);
}

std::vector<std::string> CanMonitor::table(double now) const
{
    std::vector<std::string> lines{
        fmt::format("{:<9} {:<26} {:>6} {:>7}  {}", "id", "frame", "per s", "age s", "content")};
    for (const auto& [key, count] : statistics_.counts())
        lines.push_back(fmt::format("{:<9} {:<26} {:>6} {:>7.2f}  {}", idText(count.last),
                                    key.name.empty() ? "unknown" : key.name, rateText(key),
                                    std::max(0.0, now - count.time), rowText(count)));
    return lines;
}

}  // namespace terratact
