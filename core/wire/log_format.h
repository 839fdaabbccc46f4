#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/log_frame.h"

namespace terratact {

/// Reads the lines of one format of logs, in their order.  LogReader chooses it by the content.
class LogFormat {
public:
    virtual ~LogFormat() = default;

    /// "candump", "Vector .asc"
    virtual std::string_view name() const = 0;

    /// What a line says, without its line end.  Empty: no frame (a heading, a comment, an event).  Errors say what
    /// was expected where.
    virtual Result<std::optional<LoggedFrame>> take(std::string_view line) = 0;

    std::uint64_t dropped() const { return dropped_; }    ///< frames that the log says it lost
    std::uint64_t passedOver() const { return passed_; }  ///< lines of events that are no frames

    /// What is to be said of the last line; empty: nothing.
    std::string takeRemark();

protected:
    /// A line that holds no frame and is no heading either.
    std::optional<LoggedFrame> passOver();

    std::uint64_t dropped_ = 0, passed_ = 0;
    std::string remark_;
};

std::unique_ptr<LogFormat> candumpFormat();  ///< core/wire/candump_log.h says what it reads
std::unique_ptr<LogFormat> ascFormat();      ///< core/wire/asc_log.cpp
std::unique_ptr<LogFormat> trcFormat();      ///< core/wire/trc_log.cpp
/// core/wire/csv_log.cpp.  heading: its first line, or a line of GVRET without one.
std::unique_ptr<LogFormat> csvFormat(std::string_view heading);

/// What separates the fields of a CSV log: a comma, semicolon or tab, whichever its first line has most of.
char logCsvSeparator(std::string_view line);
/// Its fields, without blanks and quotation marks around them; at most 80.
std::vector<std::string_view> logCsvFields(std::string_view line, char separator);
/// "Time Stamp" as "timestamp"
std::string logCsvName(std::string_view field);

/// The format of a log that has this first line which is not blank; null: the line fits several formats (a comment).
/// Errors name what it is instead, and which program makes a log of it that is read here.
Result<std::unique_ptr<LogFormat>> formatOfLine(std::string_view line);

/// Of a file that holds no text: what it is, and which program makes a log of it.  Empty: it may be a log.
std::string binaryKindOf(std::string_view begin);

}  // namespace terratact
