#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/log_bytes.h"
#include "core/wire/log_clock.h"
#include "core/wire/log_format.h"
#include "core/wire/log_frame.h"

namespace terratact {

/// Reads a log of CAN traffic line by line, whichever program wrote it: of candump (core/wire/candump_log.h), Vector
/// (asc_log.cpp), PEAK (trc_log.cpp), or CSV (csv_log.cpp).  The format is found in the content, not in the name.  It
/// may be packed by gzip, may begin with a byte order mark, may be UTF-16, and may be endless (a pipe).  Holds no more
/// than one line and two blocks.
///
/// A last line that is torn ends the log, which is said in a remark.
class LogReader {
public:
    static constexpr std::size_t kMaxLineLength = 1000;  ///< bytes

    /// path: "-" for standard input.  Errors name the file.
    static Result<LogReader> open(const std::string& path);

    /// Reads what is at hand; remarks and errors call it `name`.
    LogReader(std::string name, std::unique_ptr<std::istream> log);
    LogReader(std::string name, LogBytes::Source source);

    /// The next frame; empty after the last.  Errors name file and line: it is no frame, or too long; or it is no log
    /// that is read here, and what makes one of it.
    Result<std::optional<LoggedFrame>> next();

    std::uint64_t line() const { return line_; }  ///< of the last frame, the first being 1
    std::uint64_t dropped() const;                ///< frames that the log says it lost
    std::string
    format() const;  ///< "candump", "Vector .asc, packed by gzip"; empty before the first line

    /// [s] since the first frame on an even clock (LogClock); of the last frame that has a time.
    double elapsed() const { return clock_.elapsed(); }
    /// [s] by which the last frame's time lies before that of the frame before, negative where it lies more than
    /// LogClock::kMaxSilence behind it; empty: neither.
    const std::optional<double>& stepBack() const { return step_; }
    std::uint64_t stepsBack() const { return steps_; }  ///< how many frames had a stepBack()
    bool isTorn() const { return isTorn_; }

    /// What is to be said of the log since the last call, each a sentence that names file and line: clock steps
    /// (the first kMaxSteps), a torn end, lines that hold no frame.  In full after the last frame.
    std::vector<std::string> takeRemarks();
    static constexpr std::uint64_t kMaxSteps = 5;

    /// "file: line 7: cause".
    Error error(std::string_view cause) const;

private:
    enum class Line : std::uint8_t { None, Whole, Unended };
    Result<Line> readLine();
    Result<Line> endOfLongLine();
    bool endsLinesWithCr(std::string_view atHand) const;
    Status chooseFormat();
    Result<std::optional<LoggedFrame>> frameOf(Line line);
    void watchClock(const LoggedFrame& logged);
    void remark(std::string_view what);
    std::optional<LoggedFrame> end();
    void tear(std::string_view what);

    std::string name_;
    LogBytes bytes_;
    std::unique_ptr<LogFormat> format_;
    LogClock clock_;
    std::string text_;  ///< of the line
    std::uint64_t line_ = 0, steps_ = 0;
    char lineEnd_ = '\n';  ///< or CR, where the log has no other
    std::optional<double> step_;
    std::vector<std::string> remarks_;
    std::uint64_t firstPassed_ = 0;  ///< the first line that holds no frame
    bool isTorn_ = false, hasEnded_ = false, hasLooked_ = false;
};

}  // namespace terratact
