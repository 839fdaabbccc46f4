#include "core/wire/logs/log_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/base/system_message.h"
#include "core/store/file_read.h"
#include "core/wire/logs/log_text.h"

namespace terratact {
namespace {

LogBytes::Source sourceOf(std::unique_ptr<std::istream> log)
{
    return [stream = std::shared_ptr<std::istream>(std::move(log))](
               std::span<char> room) -> Result<std::size_t> {
        errno = 0;
        stream->read(room.data(), static_cast<std::streamsize>(room.size()));
        const int code = errno;
        if (stream->bad())
            return Error{Message(TR_NOOP("core", "cannot be read: %1"), systemMessage(code)), code};
        return static_cast<std::size_t>(stream->gcount());
    };
}

constexpr std::size_t kMaxZeroRemarks = 100;

/// Returns a step of the clock [s] with six digits, and never with an exponent.
std::string stepText(double seconds)
{
    constexpr double kSixDigits = 1e5;
    return seconds < kSixDigits ? fmt::format("{:.6g}", seconds) : fmt::format("{:.0f}", seconds);
}

bool isZeros(std::string_view text)
{
    return text.find_first_not_of('\0') == std::string_view::npos;
}

/// Returns true if the last byte of a GVRET line has one digit. Spreadsheets drop leading zeros, and
/// a torn line drops the second digit.
bool mayLackADigit(std::string_view line, const CanFrame& frame)
{
    const std::size_t separator = line.find_last_of(",;\t");
    return separator != std::string_view::npos && separator + 2 == line.size() && frame.length > 0
        && !frame.remote;
}

/// Consumes zero bytes, at most `most`. Returns true if something else follows them.
Result<bool> skipZeros(LogBytes& bytes, std::uint64_t most)
{
    for (std::uint64_t skipped = 0;;) {
        const Result<std::string_view> rest = bytes.peek(1);
        if (!rest) return rest.error();
        const std::size_t zeros = std::min(rest->find_first_not_of('\0'), rest->size());
        const bool follows = zeros < rest->size();
        bytes.consume(zeros);
        skipped += zeros;
        if (follows || zeros == 0) return follows;
        if (skipped > most) return true;
    }
}

}  // namespace

LogReader::LogReader(std::string name, std::unique_ptr<std::istream> log)
    : LogReader(std::move(name), sourceOf(std::move(log)))
{
}

LogReader::LogReader(std::string name, LogBytes::Source source)
    : name_(std::move(name)), bytes_(std::move(source))
{
}

Result<LogReader> LogReader::open(const std::string& path)
{
    Result<LogBytes::Source> source = LogBytes::sourceOf(path);
    if (!source) return source.error();
    return LogReader(path == "-" ? "standard input" : path, *std::move(source));
}

std::uint64_t LogReader::dropped() const
{
    return format_ ? format_->dropped() : 0;
}

std::string LogReader::format() const
{
    if (!format_) return {};
    return std::string(format_->name()) + (bytes_.isPacked() ? ", packed by gzip" : "");
}

Error LogReader::error(const Message& cause) const
{
    return fileError(name_, Message(TR_NOOP("core", "line %1: %2"), line_, cause));
}

std::vector<Message> LogReader::consumeRemarks()
{
    return std::exchange(remarks_, {});
}

void LogReader::remark(const Message& what)
{
    remarks_.push_back(error(what).message);
}

/// Reads the next line into text_.
Result<LogReader::Line> LogReader::readLine()
{
    for (std::size_t looked = 0;;) {
        const Result<std::string_view> got = bytes_.peek(looked + 1);
        if (!got) return fileError(name_, got.error().message, got.error().code);
        if (!std::exchange(hasLooked_, true))
            if (const Message kind = binaryKindOf(*got); !kind.empty())
                return fileError(name_, kind);
        const std::size_t end = got->find(lineEnd_, looked);
        const std::size_t zero = got->substr(0, end).find('\0', looked);
        if (format_ && zero <= kMaxLineLength) {  // after a power loss
            ++line_;
            text_ = got->substr(0, zero);
            bytes_.consume(zero);
            const Result<bool> follows = skipZeros(bytes_, kMaxZeros);
            if (!follows) return fileError(name_, follows.error().message, follows.error().code);
            if (!*follows) {
                text_ += '\0';
                return Line::Unended;
            }
            if (remarks_.size() < kMaxZeroRemarks)
                remark(text_.empty()
                           ? TR_NOOP("core", "zero bytes, as after a power loss, are left out")
                           : TR_NOOP("core", "zero bytes, as after a power loss, are left out, and "
                                             "the text that they cut"));
            --line_;
            looked = 0;
            continue;
        }
        if (end <= kMaxLineLength) {  // npos is larger
            ++line_;
            text_ = got->substr(0, end);
            bytes_.consume(end + 1);
            return Line::Whole;
        }
        if (endsLinesWithCr(*got) && (got->size() > kMaxLineLength || got->size() == looked)) {
            lineEnd_ = '\r';
            looked = 0;
            continue;
        }
        if (got->size() > kMaxLineLength) return endOfLongLine();
        if (got->size() == looked) {  // end of the log
            if (looked == 0) return Line::None;
            ++line_;
            text_ = *got;
            bytes_.consume(looked);
            return Line::Unended;
        }
        looked = got->size();
    }
}

/// Returns true if the first line is text and has a CR without an LF.
bool LogReader::endsLinesWithCr(std::string_view atHand) const
{
    const std::size_t cr = std::min(atHand.find('\r'), atHand.size());
    const std::string_view first = atHand.substr(0, cr);
    const bool isText = std::none_of(first.begin(), first.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\t';
    });
    return line_ == 0 && lineEnd_ == '\n' && cr + 1 < atHand.size() && isText;
}

/// After a power loss, file systems leave zeros: they end a log. More than kMaxZeros are no log.
Result<LogReader::Line> LogReader::endOfLongLine()
{
    ++line_;
    const SourceText refusal =
        format_ ? TR_NOOP("core", "is longer than %1 bytes")
                : TR_NOOP("core", "is longer than %1 bytes: this is no log of CAN frames as text");
    const Error tooLong = error(Message(refusal, kMaxLineLength));
    const Result<std::string_view> begin = bytes_.peek(1);
    text_ = begin ? begin->substr(0, kMaxLineLength) : std::string_view();
    bytes_.consume(text_.size());
    const std::size_t zeros = std::min(text_.find('\0'), text_.size());
    if (zeros == text_.size() || !isZeros(std::string_view(text_).substr(zeros))) return tooLong;
    for (std::uint64_t read = 0;;) {
        const Result<std::string_view> rest = bytes_.peek(1);
        if (!rest) return fileError(name_, rest.error().message, rest.error().code);
        if (rest->empty()) break;
        read += rest->size();
        if (read > kMaxZeros || !isZeros(*rest)) return tooLong;
        bytes_.consume(rest->size());
    }
    text_.resize(zeros + 1);
    return Line::Unended;
}

Status LogReader::chooseFormat()
{
    if (format_ || LogWords(text_).rest().empty()) return Done{};
    Result<std::unique_ptr<LogFormat>> format = formatOfLine(text_);
    if (!format) return fileError(name_, format.error().message);
    format_ = *std::move(format);
    return Done{};
}

void LogReader::tear(const Message& what)
{
    isTorn_ = true;
    remark(what);
}

Message LogReader::clockDoubt() const
{
    const std::size_t steps = clock_.frames() > 0 ? clock_.frames() - 1 : 0;
    // In candump -td every time is relative to the line before.
    const bool isRelative = format_ && format_->name() == "candump" && clock_.first() == 0.0
                         && steps >= 3 && 4 * clock_.notLater() >= steps;
    if (!isRelative) return {};
    return {TR_NOOP("core",
                    "%1 of %2 times are no later than the one before, from 0 on: is this a log "
                    "of candump -td, whose times are wrong here? Record with candump -L"),
            clock_.notLater(), steps};
}

/// Adds the last remarks.
std::optional<LoggedFrame> LogReader::end()
{
    if (std::exchange(hasEnded_, true)) return std::nullopt;
    if (bytes_.isTorn() && !isTorn_ && line_ > 0)
        tear(TR_NOOP("core", "the packed log is torn behind it: what came before is read"));
    if (bytes_.isTorn() && line_ == 0) {
        isTorn_ = true;
        remarks_.push_back(
            fileError(name_, TR_NOOP("core", "the packed log is torn before its first line"))
                .message);
    }
    if (bytes_.isFollowed())
        remark(TR_NOOP("core", "bytes behind the packed log are not gzip and are left out"));
    if (steps_ > kMaxSteps)
        remarks_.push_back(
            fileError(name_, Message(TR_NOOP("core", "the clock is set %1 more times"),
                                     steps_ - kMaxSteps))
                .message);
    if (Message doubt = clockDoubt(); !doubt.empty())
        remarks_.push_back(fileError(name_, std::move(doubt)).message);
    const std::uint64_t passed = format_ ? format_->passedOver() : 0;
    if (passed == 1)
        remarks_.push_back(
            fileError(name_, Message(TR_NOOP("core", "line %1 holds no frame and is passed over"),
                                     firstPassed_))
                .message);
    if (passed > 1)
        remarks_.push_back(
            fileError(
                name_,
                Message(TR_NOOP("core",
                                "%1 lines hold no frame and are passed over, the first is line %2"),
                        passed, firstPassed_))
                .message);
    if (format_ && format_->longer() > 0)
        remarks_.push_back(
            fileError(name_,
                      Message(TR_NOOP("core", "%1 frames have more bytes than their length says, "
                                              "which are left out; the first is in line %2"),
                              format_->longer(), firstLonger_))
                .message);
    return std::nullopt;
}

void LogReader::watchClock(const LoggedFrame& logged)
{
    step_.reset();
    if (!logged.time) return;
    step_ = clock_.add(*logged.time, logged.interface);
    if (!step_ || ++steps_ > kMaxSteps) return;
    const bool isCandump = format_->name() == "candump";
    if (*step_ < 0.0)
        return remark({TR_NOOP("core", "%1 s later than the line before: was the clock set? The "
                                       "silence is left out"),
                       stepText(-*step_)});
    const SourceText earlier =
        isCandump ? TR_NOOP("core", "%1 s earlier than the line before: was the clock set, or is "
                                    "this a log of candump -td?")
                  : TR_NOOP("core", "%1 s earlier than the line before: was the clock set?");
    remark({earlier, stepText(*step_)});
}

Result<std::optional<LoggedFrame>> LogReader::frameOf(Line line)
{
    const std::uint64_t passed = format_->passedOver(), longer = format_->longer();
    Result<std::optional<LoggedFrame>> taken = format_->parse(text_);
    if (passed == 0 && format_->passedOver() > 0) firstPassed_ = line_;
    if (longer == 0 && format_->longer() > 0) firstLonger_ = line_;
    if (Message said = format_->consumeRemark(); !said.empty()) remark(said);
    // Only candump's compact lines do not state their length.
    const bool mayBeCut = text_.find('#') != std::string::npos && format_->name() == "candump";
    if (taken && *taken && line == Line::Unended && mayBeCut)
        remark(TR_NOOP("core", "has no line end: it is read, but may be truncated"));
    if (taken && !*taken && line == Line::Unended && format_->passedOver() > passed)
        tear(TR_NOOP("core", "has no line end and holds no frame: it may be torn"));
    const bool isCut = taken && *taken && line == Line::Unended && format_->name() == "GVRET CSV"
                    && mayLackADigit(text_, (*taken)->frame);
    if (taken && !isCut) return taken;
    if (line == Line::Whole) return error(taken.error().message);
    tear(TR_NOOP("core", "is torn: the log ends within it; what came before is read"));
    return std::optional<LoggedFrame>{};
}

Result<std::optional<LoggedFrame>> LogReader::next()
{
    for (;;) {
        if (hasEnded_) return std::optional<LoggedFrame>{};
        const Result<Line> line = readLine();
        if (!line) return line.error();
        if (*line == Line::None) return end();
        if (const Status done = chooseFormat(); !done) return done.error();
        if (!format_) continue;
        Result<std::optional<LoggedFrame>> taken = frameOf(*line);
        if (!taken) return taken;
        if (*taken) {
            watchClock(**taken);
            return taken;
        }
        if (isTorn_) return end();
    }
}

}  // namespace terratact
