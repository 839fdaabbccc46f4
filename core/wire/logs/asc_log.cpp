// Logs of Vector's tools (.asc), of log2asc, of python-can, and of `session export`:
//
//   date Thu Jan  1 00:16:40 1970
//   base hex  timestamps absolute
//      0.000000 1  500             Rx   d 3 DD FF 01
//      0.100000 CANFD   1 Rx  50B  1 0 a 16 00 01 02 ...
//
// Times count from the date, which is local time, or from 0 without a date. Events that are no
// frames (statistics, chip states, requests to send) are skipped and counted.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/wire/logs/log_format.h"
#include "core/wire/logs/log_text.h"
#include "core/wire/logs/log_time.h"

namespace terratact {
namespace {

constexpr unsigned kMaxChannels = 999;
constexpr std::uint32_t kBusError = 0x80;  // class of an error frame in Linux

/// Returns the month by its first letters, in the English, German or other usual spelling; 0: none.
int monthOf(std::string_view word)
{
    constexpr std::array kMonths{"jan", "feb", "mar", "apr", "may", "jun",
                                 "jul", "aug", "sep", "oct", "nov", "dec"};
    constexpr std::array<std::pair<std::string_view, int>, 5> kGerman{
        {{"mrz", 3}, {"m\xC3\xA4r", 3}, {"mai", 5}, {"okt", 10}, {"dez", 12}}};
    std::string begin(word.substr(0, 4));
    for (char& c : begin)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto found = std::find_if(kMonths.begin(), kMonths.end(),
                                    [&](const char* month) { return begin.starts_with(month); });
    if (found != kMonths.end()) return static_cast<int>(found - kMonths.begin()) + 1;
    for (const auto& [month, number] : kGerman)
        if (begin.starts_with(month)) return number;
    return begin.starts_with("m\xE4r") ? 3 : 0;  // in a Windows code page
}

/// Returns the time of "Mon Sep 30 10:06:13.191 pm 2017", whatever the language of the day.
std::optional<double> secondsOfDateLine(std::string_view text)
{
    LogDate date;
    bool hasClock = false, isAfternoon = false, isMorning = false;
    LogWords words(text);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (word.find(':') != std::string_view::npos) {
            hasClock = consumeClock(word, date);
        } else if (isDigits(word)) {
            const auto number = integerFrom<int>(word);
            if (!number) return std::nullopt;
            (word.size() == 4 ? date.year : date.day) = *number;
        } else if (word == "pm" || word == "PM") {
            isAfternoon = true;
        } else if (word == "am" || word == "AM") {
            isMorning = true;
        } else if (const int month = monthOf(word); month != 0) {
            date.month = month;
        }
    }
    if (!hasClock) return std::nullopt;
    if (isAfternoon && date.hour < 12) date.hour += 12;
    if (isMorning && date.hour == 12) date.hour = 0;
    return secondsOfLocal(date);
}

class AscFormat final : public LogFormat {
public:
    std::string_view name() const override { return "Vector .asc"; }

    Result<std::optional<LoggedFrame>> parse(std::string_view line) override
    {
        LogWords words(line);
        const std::string_view first = words.next();
        if (first.empty() || first.starts_with("//")) return nothing();
        const bool isTime = isDigits(first.substr(first.front() == '-' ? 1 : 0, 1));
        if (!isTime) return heading(first, words);
        const Result<double> moment = logSeconds(first);
        if (!moment) return moment.error();
        const double time = isRelative_ ? last_ + *moment : *moment;
        if (!(base_ + time <= kMaxLogSeconds))
            return expectedInLog(TR_NOOP("core", "a time"), first);
        last_ = time;
        LoggedFrame logged;
        logged.time = base_ + time;
        const std::string_view second = words.next();
        if (second == "Start") return nothing();  // start of the measurement
        if (second == "CANFD") return fdFrame(std::move(logged), words);
        if (!isDigits(second)) return passOver();
        if (const Status done = setChannel(logged, second); !done) return done.error();
        return classicFrame(std::move(logged), words);
    }

private:
    using Taken = Result<std::optional<LoggedFrame>>;

    static Taken nothing() { return std::optional<LoggedFrame>{}; }

    Taken heading(std::string_view first, LogWords& words)
    {
        if (first == "date") {
            if (const auto seconds = secondsOfDateLine(words.rest()))
                base_ = *seconds;
            else
                remark_ = TR_NOOP("core", "the date is not understood: times count from 0");
            return nothing();
        }
        if (first == "base") return bases(words);
        if (first == "Begin" || first == "begin") {
            // "Triggerblock Thu Apr 28 10:44:52.480 am 2022" gives the date of the times below, if
            // present.
            (void)words.next();
            if (const auto seconds = secondsOfDateLine(words.rest())) base_ = *seconds;
            return nothing();
        }
        constexpr std::array kKnownLines{
            "End", "end", "internal", "no", "comment:", "Start", "version", "Mode:", "Trigger"};
        if (std::find(kKnownLines.begin(), kKnownLines.end(), first) == kKnownLines.end())
            return passOver();
        return nothing();
    }

    // "hex  timestamps absolute"
    Taken bases(LogWords& words)
    {
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            if (word == "hex") base16_ = true;
            if (word == "dec") base16_ = false;
            if (word == "relative") isRelative_ = true;
            if (word == "absolute") isRelative_ = false;
        }
        return nothing();
    }

    static Status setChannel(LoggedFrame& logged, std::string_view digits)
    {
        const auto channel = isDigits(digits) ? integerFrom<unsigned>(digits) : std::nullopt;
        if (!channel || *channel > kMaxChannels)
            return expectedInLog(TR_NOOP("core", "the number of a channel"), digits);
        logged.interface = interfaceOfBus(*channel);
        return Done{};
    }

    int base() const { return base16_ ? 16 : 10; }

    Status setId(CanFrame& frame, std::string_view word) const
    {
        frame.extended = word.ends_with('x') || word.ends_with('X');
        if (frame.extended) word.remove_suffix(1);
        return setFrameId(frame, word, base());
    }

    static bool setDirection(LoggedFrame& logged, std::string_view word)
    {
        if (word != "Rx" && word != "Tx") return false;
        logged.direction = word == "Rx" ? LogDirection::Received : LogDirection::Sent;
        return true;
    }

    // "500x  Rx   d 3 DD FF 01", "500 Rx r 4", "ErrorFrame"
    Taken classicFrame(LoggedFrame logged, LogWords& words)
    {
        const std::string_view id = words.next();
        if (id.starts_with("ErrorFrame")) return errorFrame(std::move(logged));
        const std::string_view direction = words.next(), kind = words.next();
        if (!setDirection(logged, direction) || (kind != "d" && kind != "r")) return passOver();
        CanFrame& frame = logged.frame;
        if (const Status done = setId(frame, id); !done) return done.error();
        frame.remote = kind == "r";
        const std::string_view word = words.next();
        const auto length = integerFrom<unsigned>(word, base());
        // A remote frame may lack its length.
        if (frame.remote && !length) return std::optional(std::move(logged));
        // A classic frame may have a length code up to 15, and then has eight bytes.
        if (!length || *length > 15)
            return expectedInLog(TR_NOOP("core", "a length from 0 to 8"), word);
        frame.length = static_cast<std::uint8_t>(std::min<std::size_t>(*length, kClassicBytes));
        if (frame.remote) return std::optional(std::move(logged));
        Taken taken = withBytes(std::move(logged), words);
        CanFrame none;
        if (taken && setFrameByte(none, 0, words.next(), base())) ++longer_;
        return taken;
    }

    static Taken errorFrame(LoggedFrame logged)
    {
        logged.frame = {.id = kBusError, .error = true, .length = kClassicBytes};
        return std::optional(std::move(logged));
    }

    Taken withBytes(LoggedFrame logged, LogWords& words) const
    {
        for (std::size_t i = 0; i < logged.frame.length; ++i)
            if (const Status done = setFrameByte(logged.frame, i, words.next(), base()); !done)
                return done.error();
        return std::optional(std::move(logged));
    }

    // "1 Rx  50B  [name]  1 0 a 16 00 01 ... duration length flags crc ...", behind CANFD
    Taken fdFrame(LoggedFrame logged, LogWords& words)
    {
        if (const Status done = setChannel(logged, words.next()); !done) return done.error();
        if (!setDirection(logged, words.next())) return passOver();
        const std::string_view id = words.next();
        if (id.starts_with("ErrorFrame")) return errorFrame(std::move(logged));
        CanFrame& frame = logged.frame;
        if (const Status done = setId(frame, id); !done) return done.error();
        std::string_view switched = words.next();  // the bit rate switch, or a name before it
        if (switched != "0" && switched != "1") switched = words.next();
        const std::string_view state = words.next(), code = words.next();
        if ((switched != "0" && switched != "1") || (state != "0" && state != "1"))
            return expectedInLog(TR_NOOP("core", "0 or 1 for the flags BRS and ESI"), switched);
        if (!integerFrom<unsigned>(code, 16))
            return expectedInLog(TR_NOOP("core", "a length code"), code);
        const std::string_view word = words.next();
        const auto length = isDigits(word) ? integerFrom<unsigned>(word) : std::nullopt;
        frame.fd = true;
        if (const Status done = setFrameLength(frame, length.value_or(kFdBytes + 1), word); !done)
            return done.error();
        Taken taken = withBytes(std::move(logged), words);
        if (taken && *taken) readFlags((*taken)->frame, *integerFrom<unsigned>(code, 16), words);
        return taken;
    }

    /// Reads the flags behind the bytes: they may mark a classic or a remote frame.
    static void readFlags(CanFrame& frame, unsigned code, LogWords& words)
    {
        constexpr unsigned kRemote = 0x10, kFd = 0x1000;
        (void)words.next();  // the frame's duration
        (void)words.next();  // its bits
        const auto flags = integerFrom<std::uint32_t>(words.next(), 16);
        if (!flags || (*flags & kFd) != 0 || frame.length > kClassicBytes) return;
        frame.fd = false;
        frame.remote = (*flags & kRemote) != 0;
        if (!frame.remote) return;
        frame.data = {};
        frame.length = static_cast<std::uint8_t>(std::min<std::size_t>(code, kClassicBytes));
    }

    double base_ = 0.0, last_ = 0.0;  ///< [s]
    bool base16_ = true, isRelative_ = false;
};

}  // namespace

std::unique_ptr<LogFormat> ascFormat()
{
    return std::make_unique<AscFormat>();
}

}  // namespace terratact
