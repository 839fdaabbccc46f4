#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/logs/log_bytes.h"
#include "core/wire/logs/log_clock.h"
#include "core/wire/logs/log_format.h"
#include "core/wire/logs/log_frame.h"

namespace terratact {

/// Reads a log of CAN traffic line by line: candump (core/wire/logs/candump_log.h), Vector
/// (asc_log.cpp), PEAK (trc_log.cpp) or CSV (csv_log.cpp). The content decides the format, not the
/// name. The log may be packed by gzip, begin with a byte order mark, be UTF-16, or be endless (a
/// pipe). One line and two blocks are held in memory.
///
/// A truncated last line ends the log. Zero bytes and text that they cut are left out. A compact
/// candump line without line end is read if it holds a frame; its data may be truncated. A GVRET
/// line without line end is truncated if its last byte has one digit. See remarks.
class LogReader {
public:
    static constexpr std::size_t kMaxLineLength = 1000;        ///< bytes
    static constexpr std::uint64_t kMaxZeros = 1'000'000'000;  ///< bytes at the end of a log

    /// Opens a log; path: "-" is standard input. Errors name the file.
    static Result<LogReader> open(const std::string& path);

    /// Reads from a stream or source; remarks and errors call it `name`.
    LogReader(std::string name, std::unique_ptr<std::istream> log);
    LogReader(std::string name, LogBytes::Source source);

    /// Returns the next frame; empty after the last. Errors name file and line of a line that is
    /// too long or no frame. For a file that is no readable log, they name the program that
    /// converts it.
    Result<std::optional<LoggedFrame>> next();

    std::uint64_t line() const { return line_; }  ///< line of the last frame; the first line is 1
    std::uint64_t dropped() const;                ///< frames that the log reports as lost
    /// Returns "candump" or "Vector .asc, packed by gzip"; empty before the first line.
    std::string format() const;

    /// Returns the time from the first frame to the last frame with a time, on a continuous clock
    /// (LogClock) [s].
    double elapsed() const { return clock_.elapsed(); }
    /// Returns how far the last frame's time lies before the time of the frame before it [s]. It is
    /// negative for a jump forward of more than LogClock::kMaxJumpForward. Empty: no jump.
    const std::optional<double>& stepBack() const { return step_; }
    std::uint64_t stepsBack() const { return steps_; }  ///< number of frames with a stepBack()
    /// Returns a sentence if the times look like those of candump -td, each since the line before.
    /// Else it is empty. It is complete after the last frame.
    Message clockDoubt() const;
    bool isTorn() const { return isTorn_; }

    /// Returns the remarks since the last call, each a sentence that names file and line. Subjects:
    /// clock steps (the first kMaxSteps), a truncated end, lines without a frame. They are complete
    /// after the last frame.
    std::vector<Message> consumeRemarks();
    static constexpr std::uint64_t kMaxSteps = 5;

    /// Returns "file: line 7: cause".
    Error error(const Message& cause) const;

private:
    enum class Line : std::uint8_t { None, Whole, Unended };
    Result<Line> readLine();
    Result<Line> endOfLongLine();
    bool endsLinesWithCr(std::string_view atHand) const;
    Status chooseFormat();
    Result<std::optional<LoggedFrame>> frameOf(Line line);
    void watchClock(const LoggedFrame& logged);
    void remark(const Message& what);
    std::optional<LoggedFrame> end();
    void tear(const Message& what);

    std::string name_;
    LogBytes bytes_;
    std::unique_ptr<LogFormat> format_;
    LogClock clock_;
    std::string text_;  ///< text of the current line
    std::uint64_t line_ = 0, steps_ = 0;
    char lineEnd_ = '\n';  ///< CR if the log has no other line ends
    std::optional<double> step_;
    std::vector<Message> remarks_;
    std::uint64_t firstPassed_ = 0;  ///< first line without a frame
    std::uint64_t firstLonger_ = 0;  ///< first line with bytes left out
    bool isTorn_ = false, hasEnded_ = false, hasLooked_ = false;
};

}  // namespace terratact
