#include "core/wire/candump_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/file_read.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::uint32_t kErrorBit = 0x2000'0000;
constexpr std::uint32_t kMostStandard = 0x7FF;
constexpr std::uint32_t kMostExtended = 0x1FFF'FFFF;
constexpr std::size_t kLongestName = 15;  // of an interface
constexpr std::size_t kClassic = 8;       // bytes
constexpr double kMostSeconds = 9'999'999'999.0;
constexpr std::array<std::size_t, 7> kLongFdLengths{12, 16, 20, 24, 32, 48, 64};
constexpr std::string_view kBlanks = " \t\r";

Error expected(std::string_view what, std::string_view found)
{
    return Error{fmt::format("expected {}, found {}", what,
                             found.empty() ? "the end of the line" : shown(found))};
}

/// Takes a line apart at its blanks.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    /// Empty after the last one.
    std::string_view next()
    {
        skipBlanks();
        const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
        rest_.remove_prefix(word.size());
        return word;
    }

    std::string_view rest()
    {
        skipBlanks();
        return rest_;
    }

private:
    void skipBlanks()
    {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    }

    std::string_view rest_;
};

bool isDigits(std::string_view text)
{
    return !text.empty()
        && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// "(1436509052.249713)"
Result<double> timeFrom(std::string_view word)
{
    const auto wrong = [word] { return expected("a time like (1436509052.249713)", word); };
    if (word.size() < 5 || word.back() != ')') return wrong();
    const std::string_view text = word.substr(1, word.size() - 2);
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos) return wrong();
    const std::string_view seconds = text.substr(0, point), fraction = text.substr(point + 1);
    const bool fits = isDigits(seconds) && isDigits(fraction) && fraction.size() <= 9;
    const std::optional<double> time = fits ? numberFrom(text) : std::nullopt;
    if (!time || *time > kMostSeconds) return wrong();
    return *time;
}

bool isName(std::string_view text)
{
    const auto isPlain = [](char c) { return c > ' ' && c <= '~' && c != '/' && c != '#'; };
    return !text.empty() && text.size() <= kLongestName
        && std::all_of(text.begin(), text.end(), isPlain);
}

Result<CanFrame> frameWithId(std::string_view digits)
{
    CanFrame frame;
    const std::optional<std::uint32_t> id = integerFrom<std::uint32_t>(digits, 16);
    if (!id || (digits.size() != 3 && digits.size() != 8))
        return expected("an identifier of 3 or 8 hexadecimal digits", digits);
    frame.error = digits.size() == 8 && (*id & kErrorBit) != 0;
    frame.extended = digits.size() == 8 && !frame.error;
    frame.id = frame.error ? *id & ~kErrorBit : *id;
    if (digits.size() == 3 && frame.id > kMostStandard)
        return expected("a standard identifier up to 7FF", digits);
    if (frame.id > kMostExtended) return expected("an identifier up to 3FFFFFFF", digits);
    return frame;
}

bool isLength(std::size_t length, bool fd)
{
    return length <= kClassic
        || (fd
            && std::find(kLongFdLengths.begin(), kLongFdLengths.end(), length)
                   != kLongFdLengths.end());
}

Status setLength(CanFrame& frame, std::size_t length, std::string_view found)
{
    if (!isLength(length, frame.fd))
        return expected(frame.fd ? "as many bytes as CAN FD can have" : "at most 8 bytes", found);
    frame.length = static_cast<std::uint8_t>(length);
    return Done{};
}

Status setByte(CanFrame& frame, std::size_t i, std::string_view digits)
{
    const auto byte = digits.size() == 2 ? integerFrom<std::uint8_t>(digits, 16) : std::nullopt;
    if (!byte) return expected("a byte of two hexadecimal digits", digits);
    if (i < frame.data.size()) frame.data[i] = *byte;
    return Done{};
}

// What follows "044#R".
Status takeRemote(CanFrame& frame, std::string_view length)
{
    if (frame.error) return Error{"an error frame cannot be a remote frame"};
    frame.remote = true;
    if (length.empty()) return Done{};
    if (length.size() != 1 || length[0] < '0' || length[0] > '8')
        return expected("a length from 0 to 8 after R", length);
    frame.length = static_cast<std::uint8_t>(length[0] - '0');
    return Done{};
}

Status takeBytes(CanFrame& frame, std::string_view digits)
{
    if (digits.size() % 2 != 0) return expected("an even number of hexadecimal digits", digits);
    if (Status done = setLength(frame, digits.size() / 2, digits); !done) return done;
    for (std::size_t i = 0; i < frame.length; ++i)
        if (Status done = setByte(frame, i, digits.substr(2 * i, 2)); !done) return done;
    return Done{};
}

// "044#2A366C2BBA"
Result<CanFrame> compactFrame(std::string_view word)
{
    const std::size_t hash = word.find('#');
    Result<CanFrame> frame = frameWithId(word.substr(0, hash));
    if (!frame) return frame;
    std::string_view content = word.substr(hash + 1);
    if (content.starts_with('R') || content.starts_with('r')) {
        if (const Status done = takeRemote(*frame, content.substr(1)); !done) return done.error();
        return frame;
    }
    if (content.starts_with('#')) {
        frame->fd = true;
        if (content.size() < 2 || !integerFrom<unsigned>(content.substr(1, 1), 16))
            return expected("a digit of flags after ##", content.substr(1, 1));
        content.remove_prefix(2);
        if (frame->error) return Error{"an error frame cannot be a CAN FD frame"};
    }
    if (const Status done = takeBytes(*frame, content); !done) return done.error();
    return frame;
}

// "[5]", or "[05]" of a CAN FD frame
Status takeLength(CanFrame& frame, std::string_view word)
{
    const bool isBracketed = word.starts_with('[') && word.ends_with(']') && word.size() > 2;
    const std::string_view digits = isBracketed ? word.substr(1, word.size() - 2) : "";
    if (!isDigits(digits) || digits.size() > 2) return expected("a length like [5]", word);
    frame.fd = digits.size() == 2;
    if (frame.fd && frame.error) return Error{"an error frame cannot be a CAN FD frame"};
    return setLength(frame, *integerFrom<unsigned>(digits, 10), word);
}

Status takeLongBytes(CanFrame& frame, Words& words)
{
    for (std::size_t i = 0; i < frame.length; ++i)
        if (Status done = setByte(frame, i, words.next()); !done) return done;
    if (frame.error) {
        const std::string_view word = words.next();
        if (word != "ERRORFRAME") return expected("the word ERRORFRAME", word);
    }
    const std::string_view rest = words.rest();
    if (rest.empty() || (rest.size() > 1 && rest.front() == '\'')) return Done{};  // candump -a
    return expected("no more than the bytes", rest);
}

// "044   [5]  2A 36 6C 2B BA", `id` being its first word
Result<CanFrame> longFrame(std::string_view id, Words& words)
{
    Result<CanFrame> frame = frameWithId(id);
    if (!frame) return frame;
    if (const Status done = takeLength(*frame, words.next()); !done) return done.error();
    const std::string_view rest = words.rest();
    if (rest.starts_with("remote")) {
        if (words.next() != "remote" || words.next() != "request" || !words.rest().empty())
            return expected("the words remote request", rest);
        if (frame->error || frame->fd) return Error{"only a classic data frame can be requested"};
        frame->remote = true;
        return frame;
    }
    if (const Status done = takeLongBytes(*frame, words); !done) return done.error();
    return frame;
}

// The end of a compact line.
Result<LogDirection> directionFrom(Words& words)
{
    const std::string_view word = words.next();
    if (!words.rest().empty()) return expected("the end of the line", words.rest());
    if (word.empty()) return LogDirection::Unknown;
    if (word == "R") return LogDirection::Received;
    if (word == "T") return LogDirection::Sent;
    return expected("a direction R or T", word);
}

// "RX - -" of candump -x, of which `word` is the first.
std::string_view skipDirection(std::string_view word, Words& words, LogDirection& direction)
{
    if (word != "RX" && word != "TX") return word;
    direction = word == "RX" ? LogDirection::Received : LogDirection::Sent;
    for (const char flag : {'B', 'E'})
        if (word = words.next(); word.size() != 1 || (word[0] != '-' && word[0] != flag))
            return word;  // no identifier either
    return words.next();
}

std::string_view shortcoming(const CanFrame& frame)
{
    if (frame.error && (frame.extended || frame.remote || frame.fd)) return "two kinds in one";
    if (frame.remote && frame.fd) return "two kinds in one";
    if (frame.id > (frame.extended || frame.error ? kMostExtended : kMostStandard))
        return "the identifier is too large";
    if (frame.length > kClassic) return "more than 8 bytes";
    return {};
}

}  // namespace

Result<LoggedFrame> frameFromCandump(std::string_view line)
{
    LoggedFrame logged;
    Words words(line);
    std::string_view word = words.next();
    if (word.starts_with('(')) {
        const Result<double> time = timeFrom(word);
        if (!time) return time.error();
        logged.time = *time;
        word = words.next();
    }
    if (!isName(word)) return expected("the name of an interface", word);
    logged.interface = word;
    word = words.next();
    const bool isCompact = word.find('#') != std::string_view::npos;
    if (isCompact && !logged.time) return expected("a time like (1436509052.249713)", line);
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
    if (!(time >= 0.0 && time <= kMostSeconds))
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

CandumpReader::CandumpReader(std::string name, std::unique_ptr<std::istream> log)
    : name_(std::move(name)), log_(std::move(log))
{
}

Result<CandumpReader> CandumpReader::open(const std::string& path)
{
    auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*file) {
        const int code = errno;
        return fileError(path, "cannot be opened: " + std::generic_category().message(code), code);
    }
    return CandumpReader(path, std::move(file));
}

Error CandumpReader::error(std::string_view cause) const
{
    return fileError(name_, fmt::format("line {}: {}", line_, cause));
}

// False at the end of the log.
Result<bool> CandumpReader::readLine()
{
    std::array<char, kLongestLine + 1> buffer{};  // with the end of a string
    errno = 0;
    log_->getline(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(log_->gcount());
    if (log_->bad()) {
        const int code = errno;
        return fileError(name_, "cannot be read: " + std::generic_category().message(code), code);
    }
    if (log_->eof() && count == 0) return false;
    ++line_;
    if (log_->fail()) return error(fmt::format("is longer than {} bytes", kLongestLine));
    if (log_->eof()) return error("is torn: the log does not end with a line end");
    text_.assign(buffer.data(), count - 1);
    return true;
}

// Of candump -e, below an error frame.
bool CandumpReader::isRemark() const
{
    return afterError_ && text_.starts_with('\t');
}

// Of candump -d: "DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 5)".
bool CandumpReader::countsDrops()
{
    Words words(text_);
    if (words.next() != "DROPCOUNT:" || words.next() != "dropped") return false;
    const auto count = integerFrom<std::uint32_t>(words.next(), 10);
    if (!count || words.next() != "CAN") return false;
    dropped_ += *count;
    return true;
}

Result<std::optional<LoggedFrame>> CandumpReader::next()
{
    for (;;) {
        const Result<bool> more = readLine();
        if (!more) return more.error();
        if (!*more) return std::optional<LoggedFrame>{};
        if (text_.find_first_not_of(kBlanks) == std::string::npos || isRemark() || countsDrops())
            continue;
        Result<LoggedFrame> logged = frameFromCandump(text_);
        if (!logged) return error(logged.error().text);
        afterError_ = logged->frame.error;
        return std::optional(*std::move(logged));
    }
}

}  // namespace terratact
