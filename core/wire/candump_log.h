#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/wire/can_frame.h"

namespace terratact {

// Logs of CAN traffic as can-utils and python-can write them, one frame per line, in two dialects:
//
//   compact, of candump -l and -L       (1436509052.249713) vcan0 044#2A366C2BBA
//   long, of candump without these       (1436509052.249713)  vcan0  044   [5]  2A 36 6C 2B BA
//
// An identifier has 3 digits, or 8 where it is extended or, with bit 29 set, an error frame; a remote frame
// is 044#R or 044#R4, a CAN FD frame 044##<flags><data>.  A direction (R or T; RX or TX of candump -x) may
// stand with it.  The long dialect may lack the time.  What candump writes about errors below an error frame
// (-e) and beside the bytes (-a) is passed over; swapped or binary bytes (-S, -i), colours (-c) and dates (-tA)
// are refused.  Times of -td cannot be told from others: a log of them has wrong times.

enum class LogDirection : std::uint8_t { Unknown, Received, Sent };

struct LoggedFrame {
    std::optional<double> time;  ///< [s] as it stands there: most often since 1970
    std::string interface;
    CanFrame frame;  ///< its bytes beyond its length are 0; flags of CAN FD (BRS, ESI) are not kept
    LogDirection direction = LogDirection::Unknown;
    bool operator==(const LoggedFrame&) const = default;
};

/// The frame of one line, without its line end.  Errors say what was expected where.
Result<LoggedFrame> frameFromCandump(std::string_view line);

/// A line of the compact dialect, without its line end, that every can-utils and python-can read: six digits
/// after the point, no direction.  Throws std::invalid_argument for what has no such line: a time that is
/// negative or not finite, an interface name that is empty, longer than 15 bytes or holds blanks, an
/// identifier beyond its bits, more than 8 bytes (of a longer FD frame the bytes are not known), two kinds
/// of frame in one.
std::string candumpLine(double time, std::string_view interface, const CanFrame& frame);

/// Reads a log line by line; it may be endless (a pipe).  Holds no more than one line.
class CandumpReader {
public:
    static constexpr std::size_t kLongestLine = 1000;  ///< bytes

    /// Errors name the file.
    static Result<CandumpReader> open(const std::string& path);

    /// Reads what is at hand; errors call it `name`.
    CandumpReader(std::string name, std::unique_ptr<std::istream> log);

    /// The next frame; empty after the last.  Blank lines are passed over.  Errors name file and line: it is
    /// no frame, too long, or torn (the log ends without a line end).
    Result<std::optional<LoggedFrame>> next();

    std::uint64_t line() const { return line_; }        ///< of the last frame, the first being 1
    std::uint64_t dropped() const { return dropped_; }  ///< frames that candump -d says it lost

    /// "file: line 7: cause".
    Error error(std::string_view cause) const;

private:
    Result<bool> readLine();
    bool isRemark() const;
    bool countsDrops();

    std::string name_;
    std::unique_ptr<std::istream> log_;
    std::string text_;  ///< of the line
    std::uint64_t line_ = 0;
    std::uint64_t dropped_ = 0;
    bool afterError_ = false;  ///< the frame before was an error frame
};

}  // namespace terratact
