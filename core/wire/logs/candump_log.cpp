#include "core/wire/logs/candump_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/wire/logs/log_format.h"
#include "core/wire/logs/log_text.h"
#include "core/wire/logs/log_time.h"

namespace terratact {
namespace {

constexpr std::uint32_t kErrorBit = 0x2000'0000;
constexpr std::size_t kMaxNameLength = 15;  // of an interface name

Error expectedTime(std::string_view found)
{
    return expectedInLog(TR_NOOP("core", "a time like (1436509052.249713)"), found);
}

// "(1436509052.249713)"
Result<double> timeFrom(std::string_view word)
{
    const auto wrong = [word] { return expectedTime(word); };
    if (word.size() < 5 || word.back() != ')') return wrong();
    const std::string_view text = word.substr(1, word.size() - 2);
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos) return wrong();
    const std::string_view seconds = text.substr(0, point), fraction = text.substr(point + 1);
    const bool fits = isDigits(seconds) && isDigits(fraction) && fraction.size() <= 9;
    const std::optional<double> time = fits ? numberFrom(text) : std::nullopt;
    if (!time || *time > kMaxLogSeconds) return wrong();
    return *time;
}

// Returns true for a date such as "(2025-01-10" from candump -tA.
bool isDate(std::string_view word)
{
    return word.size() == 11 && word[5] == '-' && word[8] == '-';
}

// Returns the time of a date and a clock such as "12:34:56.249713)".
Result<double> timeOfDate(std::string_view date, std::string_view clock)
{
    const std::string_view plain = clock.substr(0, clock.empty() ? 0 : clock.size() - 1);
    const auto time = clock.ends_with(')') ? secondsOfDate(date.substr(1), plain) : std::nullopt;
    if (!time)
        return expectedInLog(TR_NOOP("core", "a time like (2025-01-10 12:34:56.249713)"),
                             fmt::format("{} {}", date, clock));
    return *time;
}

bool isName(std::string_view text)
{
    const auto isPlain = [](char c) { return c > ' ' && c <= '~' && c != '/' && c != '#'; };
    return !text.empty() && text.size() <= kMaxNameLength
        && std::all_of(text.begin(), text.end(), isPlain);
}

Result<CanFrame> frameWithId(std::string_view digits)
{
    CanFrame frame;
    const std::optional<std::uint32_t> id = integerFrom<std::uint32_t>(digits, 16);
    if (!id || (digits.size() != 3 && digits.size() != 8))
        return expectedInLog(TR_NOOP("core", "an identifier of 3 or 8 hexadecimal digits"), digits);
    frame.error = digits.size() == 8 && (*id & kErrorBit) != 0;
    frame.extended = digits.size() == 8 && !frame.error;
    frame.id = frame.error ? *id & ~kErrorBit : *id;
    if (digits.size() == 3 && frame.id > kMaxStandardId)
        return expectedInLog(TR_NOOP("core", "a standard identifier up to 7FF"), digits);
    if (frame.id > kMaxExtendedId)
        return expectedInLog(TR_NOOP("core", "an identifier up to 3FFFFFFF"), digits);
    return frame;
}

// Reads what follows "044#R".
Status readRemote(CanFrame& frame, std::string_view length)
{
    if (frame.error) return Error{TR_NOOP("core", "an error frame cannot be a remote frame")};
    frame.remote = true;
    if (length.empty()) return Done{};
    if (length.size() != 1 || length[0] < '0' || length[0] > '8')
        return expectedInLog(TR_NOOP("core", "a length from 0 to 8 after R"), length);
    frame.length = static_cast<std::uint8_t>(length[0] - '0');
    return Done{};
}

Status readBytes(CanFrame& frame, std::string_view digits)
{
    if (digits.size() % 2 != 0)
        return expectedInLog(TR_NOOP("core", "an even number of hexadecimal digits"), digits);
    if (Status done = setFrameLength(frame, digits.size() / 2, digits); !done) return done;
    for (std::size_t i = 0; i < frame.length; ++i)
        if (Status done = setFrameByte(frame, i, digits.substr(2 * i, 2)); !done) return done;
    return Done{};
}

// Removes "_F" from "1122334455667788_F": a length code from 9 to 15 means eight bytes (candump -8).
void removeLengthCode(std::string_view& digits)
{
    constexpr std::size_t kDigits = 2 * kClassicBytes;
    if (digits.size() != kDigits + 2 || digits[kDigits] != '_') return;
    const auto code = integerFrom<unsigned>(digits.substr(kDigits + 1), 16);
    if (code && *code > kClassicBytes) digits.remove_suffix(2);
}

// Reads "044#2A366C2BBA".
Result<CanFrame> compactFrame(std::string_view word)
{
    const std::size_t hash = word.find('#');
    Result<CanFrame> frame = frameWithId(word.substr(0, hash));
    if (!frame) return frame;
    std::string_view content = word.substr(hash + 1);
    if (content.starts_with('R') || content.starts_with('r')) {
        if (const Status done = readRemote(*frame, content.substr(1)); !done) return done.error();
        return frame;
    }
    if (content.starts_with('#')) {
        frame->fd = true;
        if (content.size() < 2 || !integerFrom<unsigned>(content.substr(1, 1), 16))
            return expectedInLog(TR_NOOP("core", "a digit of flags after ##"),
                                 content.substr(1, 1));
        content.remove_prefix(2);
        if (frame->error) return Error{TR_NOOP("core", "an error frame cannot be a CAN FD frame")};
    } else {
        removeLengthCode(content);
    }
    if (content.find('#') != std::string_view::npos)
        return Error{TR_NOOP("core", "a CAN XL frame is not read; expected CAN or CAN FD")};
    if (const Status done = readBytes(*frame, content); !done) return done.error();
    return frame;
}

// Reads "[5]", or "[05]" of a CAN FD frame.
Status readLength(CanFrame& frame, std::string_view word)
{
    const bool isBracketed = word.starts_with('[') && word.ends_with(']') && word.size() > 2;
    const std::string_view digits = isBracketed ? word.substr(1, word.size() - 2) : "";
    if (!isDigits(digits) || digits.size() > 2)
        return expectedInLog(TR_NOOP("core", "a length like [5]"), word);
    frame.fd = digits.size() == 2;
    if (frame.fd && frame.error)
        return Error{TR_NOOP("core", "an error frame cannot be a CAN FD frame")};
    return setFrameLength(frame, *integerFrom<unsigned>(digits, 10), word);
}

Status readLongBytes(CanFrame& frame, LogWords& words)
{
    for (std::size_t i = 0; i < frame.length; ++i)
        if (Status done = setFrameByte(frame, i, words.next()); !done) return done;
    if (frame.error) {
        const std::string_view word = words.next();
        if (word != "ERRORFRAME")
            return expectedInLog(TR_NOOP("core", "the word ERRORFRAME"), word);
    }
    const std::string_view rest = words.rest();
    if (rest.empty() || (rest.size() > 1 && rest.front() == '\'')) return Done{};  // candump -a
    return expectedInLog(TR_NOOP("core", "no more than the bytes"), rest);
}

// Reads "044 [5] 2A 36 6C 2B BA"; `id` is its first word.
Result<CanFrame> longFrame(std::string_view id, LogWords& words)
{
    Result<CanFrame> frame = frameWithId(id);
    if (!frame) return frame;
    if (const Status done = readLength(*frame, words.next()); !done) return done.error();
    const std::string_view rest = words.rest();
    if (rest.starts_with("remote")) {
        if (words.next() != "remote" || words.next() != "request" || !words.rest().empty())
            return expectedInLog(TR_NOOP("core", "the words remote request"), rest);
        if (frame->error || frame->fd)
            return Error{TR_NOOP("core", "only a classic data frame can be requested")};
        frame->remote = true;
        return frame;
    }
    if (const Status done = readLongBytes(*frame, words); !done) return done.error();
    return frame;
}

// Reads the end of a compact line.
Result<LogDirection> directionFrom(LogWords& words)
{
    const std::string_view word = words.next();
    if (!words.rest().empty())
        return expectedInLog(TR_NOOP("core", "the end of the line"), words.rest());
    if (word.empty()) return LogDirection::Unknown;
    if (word == "R") return LogDirection::Received;
    if (word == "T") return LogDirection::Sent;
    return expectedInLog(TR_NOOP("core", "a direction R or T"), word);
}

// Skips "RX - -" of candump -x; `word` is its first word.
std::string_view skipDirection(std::string_view word, LogWords& words, LogDirection& direction)
{
    if (word != "RX" && word != "TX") return word;
    direction = word == "RX" ? LogDirection::Received : LogDirection::Sent;
    for (const char flag : {'B', 'E'})
        if (word = words.next(); word.size() != 1 || (word[0] != '-' && word[0] != flag))
            return word;  // is no identifier either
    return words.next();
}

std::string_view shortcoming(const CanFrame& frame)
{
    if (frame.error && (frame.extended || frame.remote || frame.fd)) return "two kinds in one";
    if (frame.remote && frame.fd) return "two kinds in one";
    if (frame.id > (frame.extended || frame.error ? kMaxExtendedId : kMaxStandardId))
        return "the identifier is too large";
    if (!isFrameLength(frame.length, frame.fd)) return "a length that no such frame has";
    if (frame.isCut) return "more bytes than are known";
    return {};
}

}  // namespace

Result<LoggedFrame> frameFromCandump(std::string_view line)
{
    LoggedFrame logged;
    LogWords words(line);
    std::string_view word = words.next();
    if (word.starts_with('(')) {
        const Result<double> time = isDate(word) ? timeOfDate(word, words.next()) : timeFrom(word);
        if (!time) return time.error();
        logged.time = *time;
        word = words.next();
    }
    if (word.size() > 4 && word.starts_with("<0x") && word.ends_with('>')) {
        const Result<CanFrame> frame = longFrame(word.substr(3, word.size() - 4), words);
        if (!frame) return frame.error();
        logged.interface = "can0";
        logged.frame = *frame;
        return logged;
    }
    if (!isName(word)) return expectedInLog(TR_NOOP("core", "the name of an interface"), word);
    logged.interface = word;
    word = words.next();
    const bool isCompact = word.find('#') != std::string_view::npos;
    if (isCompact && !logged.time) return expectedTime(line);
    if (!isCompact) word = skipDirection(word, words, logged.direction);
    const Result<CanFrame> frame = isCompact ? compactFrame(word) : longFrame(word, words);
    if (!frame) return frame.error();
    logged.frame = *frame;
    if (!isCompact) return logged;
    const Result<LogDirection> direction = directionFrom(words);
    if (!direction) return direction.error();
    logged.direction = *direction;
    return logged;
}

std::string candumpLine(double time, std::string_view interface, const CanFrame& frame)
{
    if (!(time >= 0.0 && time <= kMaxLogSeconds))
        throw std::invalid_argument("candumpLine: the time has no place in a log");
    if (!isName(interface)) throw std::invalid_argument("candumpLine: no name of an interface");
    if (const std::string_view why = shortcoming(frame); !why.empty())
        throw std::invalid_argument(fmt::format("candumpLine: {}", why));

    const std::uint32_t id = frame.error ? frame.id | kErrorBit : frame.id;
    std::string line = fmt::format("({:017.6f}) {} {:0{}X}#", time, interface, id,
                                   frame.extended || frame.error ? 8 : 3);
    if (frame.remote) {
        line += 'R';
        if (frame.length > 0) line += std::to_string(frame.length);
        return line;
    }
    if (frame.fd) line += "#0";
    for (std::size_t i = 0; i < frame.length; ++i) line += fmt::format("{:02X}", frame.data[i]);
    return line;
}

namespace {

class CandumpFormat final : public LogFormat {
public:
    std::string_view name() const override { return "candump"; }

    Result<std::optional<LoggedFrame>> parse(std::string_view line) override
    {
        const std::string_view begin = LogWords(line).rest();
        if (begin.empty() || begin.front() == '#' || isOfError(line) || countsDrops(line))
            return std::optional<LoggedFrame>{};
        Result<LoggedFrame> logged = frameFromCandump(line);
        if (!logged) return logged.error();
        afterError_ = logged->frame.error;
        return std::optional(*std::move(logged));
    }

private:
    // Returns true for a text below an error frame (candump -e).
    bool isOfError(std::string_view line) const { return afterError_ && line.starts_with('\t'); }

    // Counts "DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 5)" (candump -d).
    bool countsDrops(std::string_view line)
    {
        LogWords words(line);
        if (words.next() != "DROPCOUNT:" || words.next() != "dropped") return false;
        const auto count = integerFrom<std::uint32_t>(words.next(), 10);
        if (!count || words.next() != "CAN") return false;
        dropped_ += *count;
        return true;
    }

    bool afterError_ = false;  ///< the last frame was an error frame
};

}  // namespace

std::unique_ptr<LogFormat> candumpFormat()
{
    return std::make_unique<CandumpFormat>();
}

}  // namespace terratact
