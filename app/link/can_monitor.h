#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/link/bus_statistics.h"
#include "app/link/can_text.h"
#include "app/link/dbc_book.h"
#include "drivers/can_bus.h"

namespace terratact {

/// What is on a bus now: a table of its frames in words with rate and age, the load, what was lost.  No clock:
/// `now` [s] is of the same clock as BusFrame::time.
class CanMonitor {
public:
    /// bitrate: [bit/s] of the bus.  Throws std::invalid_argument unless it is over 0.
    /// book: for frames that are not the protocol's.
    CanMonitor(CanProtocol protocol, double bitrate, std::shared_ptr<const DbcBook> book = nullptr);

    void take(const BusFrame& frame);

    /// Remembers the counts of this moment; rates and load are over the last second or two of them.  To be
    /// called a few times a second.
    void mark(double now);

    /// "can0 is up; load 12.3 to 15.0 % of 500 kbit/s, …": the load without stuff bits and with as many as can
    /// be.  state: in words.
    std::string headline(const std::string& state, const BusCounters& counters) const;

    /// A heading and a line for each kind of frame, in the order of identifiers.
    std::vector<std::string> table(double now) const;

private:
    struct Mark {
        double time = 0.0;
        std::uint64_t fewestBits = 0, mostBits = 0;
        std::map<FrameKey, std::uint64_t> frames;
    };
    double seconds() const;
    std::string rateText(const FrameKey& key) const;

    std::unique_ptr<FrameReader> reader_;
    double bitrate_;
    BusStatistics statistics_;
    std::deque<Mark> marks_;
};

}  // namespace terratact
