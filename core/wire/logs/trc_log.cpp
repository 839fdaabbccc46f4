// Logs of PEAK's tools (.trc), versions 1.0 to 2.1. A line of version 1 is
//
//     1)      1059.9  Rx     0300  7  00 00 00 00 04 00 00
//
// Version 1.2 adds a bus before the direction, 1.3 a reserved dash behind the identifier. From 2.0
// on a heading gives the columns (;$COLUMNS=N,O,T,B,I,d,R,L,D). Times are milliseconds since
// ;$STARTTIME, in days since 30 December 1899, which is taken as UTC like in python-can. Version
// 1.0 has no $STARTTIME: its comment "Start time: 24.09.2008 16:00:35.472.0" is also taken as UTC.
// States, events and error counters are skipped and counted.
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/wire/logs/log_format.h"
#include "core/wire/logs/log_text.h"
#include "core/wire/logs/log_time.h"

namespace terratact {
namespace {

constexpr double kMilliseconds = 1000.0;
constexpr std::size_t kLongId = 4;  // a longer identifier is extended [digits]
constexpr std::string_view kColumns20 = "NOTIdlD", kColumns21 = "NOTBIdRLD";

/// Returns seconds since 1970 from days since 30 December 1899.
std::optional<double> secondsOfDays(std::string_view text)
{
    constexpr double kDaysTo1970 = 25569.0, kDay = 86400.0, kMaxDays = 130'000.0;
    const std::optional<double> days = numberFrom(text);
    if (!days || !(*days >= kDaysTo1970 && *days <= kMaxDays)) return std::nullopt;
    return (*days - kDaysTo1970) * kDay;
}

/// Returns seconds since 1970 of "24.09.2008 16:00:35.472.0": day first, tenths of a millisecond
/// last. Empty if the order of day and month is uncertain, or there is no such moment.
std::optional<double> secondsOfStart(std::string_view text)
{
    LogWords words(text);
    std::array<std::string_view, 3> parts;
    std::string_view date = words.next(), clock = words.next();
    for (std::string_view& part : parts) {
        const std::size_t end = std::min(date.find('.'), date.size());
        part = date.substr(0, end);
        date.remove_prefix(std::min(end + 1, date.size()));
    }
    const auto day = integerFrom<int>(parts[0]), month = integerFrom<int>(parts[1]),
               year = integerFrom<int>(parts[2]);
    if (!day || !month || !year || !date.empty() || !words.rest().empty()) return std::nullopt;
    LogDate moment;
    if (std::count(clock.begin(), clock.end(), '.') > 1) clock = clock.substr(0, clock.rfind('.'));
    if (!consumeClock(clock, moment)) return std::nullopt;
    const std::chrono::year_month_day calendar{std::chrono::year(*year),
                                               std::chrono::month(static_cast<unsigned>(*month)),
                                               std::chrono::day(static_cast<unsigned>(*day))};
    if (*year < 1970 || *year > 2200 || !calendar.ok()) return std::nullopt;
    const std::chrono::seconds midnight = std::chrono::sys_days(calendar).time_since_epoch();
    return static_cast<double>(midnight.count()) + 3600.0 * moment.hour + 60.0 * moment.minute
         + moment.second;
}

bool isDirection(std::string_view word)
{
    return word == "Rx" || word == "Tx";
}

class TrcFormat final : public LogFormat {
public:
    std::string_view name() const override { return "PEAK .trc"; }

    Result<std::optional<LoggedFrame>> parse(std::string_view line) override
    {
        LogWords words(line);
        const std::string_view begin = words.rest();
        if (begin.empty()) return std::optional<LoggedFrame>{};
        if (begin.front() == ';') return heading(begin.substr(1));
        if (const std::string_view number = words.next(); number.ends_with(')'))
            return oldFrame(number, words);
        return newFrame(LogWords(line));
    }

private:
    using Taken = Result<std::optional<LoggedFrame>>;

    Taken heading(std::string_view text)
    {
        constexpr std::string_view kVersion = "$FILEVERSION=", kStart = "$STARTTIME=",
                                   kColumns = "$COLUMNS=", kStartOfVersion10 = "Start time:";
        while (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        if (text.starts_with(kVersion)) {
            const std::string_view version = text.substr(kVersion.size());
            if (version.empty() || version.front() < '1' || version.front() > '2')
                return Error{Message(TR_NOOP("core", "is of version %1 of the format: export it as "
                                                     "version 1.0 to 2.1"),
                                     shown(version))};
            if (version == "2.0") columns_ = kColumns20;
        } else if (text.starts_with(kStart)) {
            setStart(secondsOfDays(text.substr(kStart.size())));
        } else if (const auto at = text.find(kStartOfVersion10);
                   at != std::string_view::npos && !start_) {
            setStart(secondsOfStart(text.substr(at + kStartOfVersion10.size())));
        } else if (text.starts_with(kColumns)) {
            columns_.clear();
            for (const char c : text.substr(kColumns.size()))
                if (c != ',' && c != ' ') columns_ += c;
        }
        return std::optional<LoggedFrame>{};
    }

    void setStart(std::optional<double> seconds)
    {
        start_ = seconds.value_or(0.0);
        if (!seconds)
            remark_ = TR_NOOP("core", "the start time is not understood: times count from 0");
    }

    Status setTime(LoggedFrame& logged, std::string_view word) const
    {
        const Result<double> time = logSeconds(word, kMilliseconds);
        if (!time) return time.error();
        logged.time = start_.value_or(0.0) + *time;
        return Done{};
    }

    static Status setBus(LoggedFrame& logged, std::string_view word)
    {
        const auto bus = isDigits(word) ? integerFrom<std::uint8_t>(word) : std::nullopt;
        if (!bus) return expectedInLog(TR_NOOP("core", "the number of a bus"), word);
        logged.interface = interfaceOfBus(*bus);
        return Done{};
    }

    static Status setId(CanFrame& frame, std::string_view word)
    {
        if (word.ends_with('h')) word.remove_suffix(1);
        frame.extended = word.size() > kLongId;
        return setFrameId(frame, word);
    }

    // Reads a line of versions 1.0 to 1.3, behind "1)".
    Taken oldFrame(std::string_view number, LogWords& words)
    {
        if (!isDigits(number.substr(0, number.size() - 1)))
            return expectedInLog(TR_NOOP("core", "the number of a frame, such as 1)"), number);
        LoggedFrame logged;
        logged.interface = interfaceOfBus(1);
        if (const Status done = setTime(logged, words.next()); !done) return done.error();
        std::string_view word = words.next();
        if (word.size() <= 2 && isDigits(word)) {
            if (const Status done = setBus(logged, word); !done) return done.error();
            word = words.next();
        }
        if (word == "Warng" || word == "Error" || word == "Event") return passOver();
        if (isDirection(word)) {
            logged.direction = word == "Rx" ? LogDirection::Received : LogDirection::Sent;
            word = words.next();
        }
        if (word == "FFFFFFFF") return passOver();  // the state of the bus
        if (const Status done = setId(logged.frame, word); !done) return done.error();
        word = words.next();
        if (word == "-") word = words.next();
        const auto length = isDigits(word) ? integerFrom<unsigned>(word) : std::nullopt;
        if (const Status done = setFrameLength(logged.frame, length.value_or(kFdBytes + 1), word);
            !done)
            return done.error();
        return withBytes(std::move(logged), words);
    }

    // Reads a line by its columns, from version 2.0 on.
    Taken newFrame(LogWords words)
    {
        LoggedFrame logged;
        logged.interface = interfaceOfBus(1);
        std::string_view type;
        for (const char column : columns_) {
            if (column == 'D') break;
            const std::string_view word = words.next();
            if (column == 'T') type = word;
            // Lines without a frame have columns of their own.
            if (column == 'T' && !setType(logged.frame, type)) return passOver();
            if (const Status done = setColumn(logged, column, word); !done) return done.error();
        }
        if (type.empty())
            return expectedInLog(TR_NOOP("core", "a line with the columns of the heading"), "");
        return withBytes(std::move(logged), words);
    }

    /// Returns false for a line that is neither a data frame nor a remote frame.
    static bool setType(CanFrame& frame, std::string_view type)
    {
        frame.fd = type == "FD" || type == "FB" || type == "FE" || type == "BI";
        frame.remote = type == "RR";
        return frame.fd || frame.remote || type == "DT";
    }

    Status setColumn(LoggedFrame& logged, char column, std::string_view word) const
    {
        switch (column) {
        case 'N':
            return isDigits(word) ? Status(Done{})
                                  : expectedInLog(TR_NOOP("core", "a number"), word);
        case 'O': return setTime(logged, word);
        case 'B': return setBus(logged, word);
        case 'I': return setId(logged.frame, word);
        case 'd':
            if (!isDirection(word)) return expectedInLog(TR_NOOP("core", "Rx or Tx"), word);
            logged.direction = word == "Rx" ? LogDirection::Received : LogDirection::Sent;
            return Done{};
        case 'l':
        case 'L': return setLength(logged.frame, column == 'L', word);
        default: return Done{};
        }
    }

    static Status setLength(CanFrame& frame, bool isCode, std::string_view word)
    {
        const auto number = isDigits(word) ? integerFrom<unsigned>(word) : std::nullopt;
        if (!number || (isCode && *number > 15))
            return expectedInLog(TR_NOOP("core", "a length"), word);
        if (!isCode) return setFrameLength(frame, *number, word);
        const std::size_t bytes =
            frame.fd ? bytesOfCode(*number) : std::min<std::size_t>(*number, kClassicBytes);
        return setFrameLength(frame, bytes, word);
    }

    Taken withBytes(LoggedFrame logged, LogWords& words)
    {
        if (words.rest().starts_with("RTR")) logged.frame.remote = !logged.frame.fd;
        for (std::size_t i = 0; !logged.frame.remote && i < logged.frame.length; ++i)
            if (const Status done = setFrameByte(logged.frame, i, words.next()); !done)
                return done.error();
        CanFrame none;
        if (!logged.frame.remote && setFrameByte(none, 0, words.next())) ++longer_;
        return std::optional(std::move(logged));
    }

    std::optional<double> start_;  ///< start time [s] since 1970; empty: not read yet
    std::string columns_{kColumns21};
};

}  // namespace

std::unique_ptr<LogFormat> trcFormat()
{
    return std::make_unique<TrcFormat>();
}

}  // namespace terratact
