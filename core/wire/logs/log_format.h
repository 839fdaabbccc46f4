#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/logs/log_frame.h"

namespace terratact {

/// Reads the lines of one log format, in their order. LogReader chooses the format by the content.
class LogFormat {
public:
    virtual ~LogFormat() = default;

    /// Returns "candump" or "Vector .asc".
    virtual std::string_view name() const = 0;

    /// Reads a line, given without its line end. Returns empty for a line without a frame (a
    /// heading, a comment, an event). Errors name what was expected and where.
    virtual Result<std::optional<LoggedFrame>> parse(std::string_view line) = 0;

    std::uint64_t dropped() const { return dropped_; }    ///< frames that the log reports as lost
    std::uint64_t passedOver() const { return passed_; }  ///< lines of events that are no frames

    /// Returns the frames that had more bytes than their length says, which were left out.
    std::uint64_t longer() const { return longer_; }

    /// Returns a remark about the last line; empty: none.
    Message consumeRemark();

protected:
    /// Counts a line that is neither a frame nor a heading.
    std::optional<LoggedFrame> passOver();

    std::uint64_t dropped_ = 0, passed_ = 0, longer_ = 0;
    Message remark_;
};

std::unique_ptr<LogFormat> candumpFormat();  ///< core/wire/logs/candump_log.h lists what it reads
std::unique_ptr<LogFormat> ascFormat();      ///< core/wire/logs/asc_log.cpp
std::unique_ptr<LogFormat> trcFormat();      ///< core/wire/logs/trc_log.cpp
/// core/wire/logs/csv_log.cpp. heading: its first line, or a GVRET line without a heading.
std::unique_ptr<LogFormat> csvFormat(std::string_view heading);

/// Returns the separator of a CSV log: comma, semicolon or tab, whichever is most frequent in its
/// first line.
char logCsvSeparator(std::string_view line);
/// Returns the fields without surrounding blanks and quotation marks; at most 80.
std::vector<std::string_view> logCsvFields(std::string_view line, char separator);
/// Returns "timestamp" for "Time Stamp".
std::string logCsvName(std::string_view field);

/// Returns the format of a log by its first line that is not blank; null: the line fits several
/// formats (a comment). Errors name what the file is instead, and which program converts it to a
/// readable log.
Result<std::unique_ptr<LogFormat>> formatOfLine(std::string_view line);

/// Returns what a binary file is, and which program converts it to a log. Empty: it may be a log.
Message binaryKindOf(std::string_view begin);

}  // namespace terratact
