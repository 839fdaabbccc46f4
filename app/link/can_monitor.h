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

/// Present traffic of a bus: a table of frames (content, rate, age), the bus load, and lost frames. It reads no clock:
/// `now` [s] uses the clock of BusFrame::time.
class CanMonitor {
public:
    /// bitrate: of the bus [bit/s]. Throws std::invalid_argument unless it is above 0. book: describes frames outside
    /// the protocol.
    CanMonitor(CanProtocol protocol, double bitrate, std::shared_ptr<const DbcBook> book = nullptr);

    void add(const BusFrame& frame);

    /// Stores the present counts; rates and load use the last one or two seconds of them. Call a few times a second.
    void mark(double now);

    /// Returns "can0 is up; load 12.3 to 15.0 % of 500 kbit/s, …". The load is given without stuff bits and with the
    /// maximum stuff bits. state: as text.
    std::string headline(const std::string& state, const BusCounters& counters) const;

    /// Returns a heading and a line for each kind of frame, ordered by identifier.
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
