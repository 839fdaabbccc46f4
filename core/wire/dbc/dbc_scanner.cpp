#include "core/wire/dbc/dbc_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

constexpr char kEndOfDos = '\x1A';  // DOS ended a text file with this character

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == kEndOfDos;
}

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool isOfNumber(char c)
{
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

}  // namespace

bool isDbcKeyword(std::string_view word)
{
    return word == "VERSION"
        || (word.size() > 2 && word.back() == '_'
            && std::all_of(word.begin(), word.end(),
                           [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }));
}

DbcScanner::Place DbcScanner::place()
{
    skipBlanks();
    return {at_, line_};
}

void DbcScanner::recover(const Place& place)
{
    failure_ = {};
    at_ = place.at;
    line_ = place.line;
    do {
        (void)restOfLine();
        skipBlanks();
    } while (at_ < text_.size() && !isSectionNext());
}

int DbcScanner::line()
{
    skipBlanks();
    return line_;
}

bool DbcScanner::atEnd()
{
    skipBlanks();
    return at_ == text_.size();
}

bool DbcScanner::isNext(char c)
{
    skipBlanks();
    return at_ < text_.size() && text_[at_] == c;
}

bool DbcScanner::consume(char c)
{
    if (!isNext(c)) return false;
    advance();
    return true;
}

void DbcScanner::expect(char c, SourceText place)
{
    if (!consume(c)) fail(Message(place, std::string{'\'', c, '\''}));
}

bool DbcScanner::isNameNext()
{
    skipBlanks();
    return at_ < text_.size() && isNameCharacter(text_[at_])
        && !(text_[at_] >= '0' && text_[at_] <= '9');
}

bool DbcScanner::isLineEndNext()
{
    std::size_t at = at_;
    while (at < text_.size() && isBlank(text_[at]) && text_[at] != '\n') ++at;
    return at == text_.size() || text_[at] == '\n';
}

std::string_view DbcScanner::upTo(char c)
{
    const std::size_t end = text_.find_first_of(std::string{c, '\n'}, at_);
    if (end == std::string_view::npos || text_[end] != c) return {};
    const std::string_view found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
}

std::string_view DbcScanner::wordIfAny()
{
    skipBlanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && isNameCharacter(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
}

std::string_view DbcScanner::word(SourceText what)
{
    skipBlanks();
    const std::size_t begin = at_;
    const std::string_view found = wordIfAny();
    if (!found.empty() && found.size() <= kDbcName) return found;
    at_ = begin;
    fail(Message(TR_NOOP("core", "%1 of at most %2 letters, digits and _"), what, kDbcName));
    return {};
}

std::string_view DbcScanner::numberToken()
{
    skipBlanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && isOfNumber(text_[at_])) ++at_;
    std::string_view found = text_.substr(begin, at_ - begin);
    if (found.starts_with('+')) found.remove_prefix(1);
    return found;
}

double DbcScanner::number(SourceText what)
{
    skipBlanks();
    const std::size_t begin = at_;
    const std::optional<double> value = numberFrom(numberToken());
    if (value && std::isfinite(*value)) return *value;
    at_ = begin;
    fail(Message(TR_NOOP("core", "%1, a number"), what));
    return 0.0;
}

std::optional<DbcRaw> DbcScanner::raw(SourceText what)
{
    const Place begin = place();
    const std::string_view token = numberToken();
    if (const auto whole = integerFrom<std::int64_t>(token)) return *whole;
    if (const auto whole = integerFrom<std::uint64_t>(token)) return *whole;
    at_ = begin.at;
    const double rounded = std::round(number(what));
    if (!(std::abs(rounded) <= 0x1p53)) return std::nullopt;
    return static_cast<DbcRaw>(rounded);
}

std::uint64_t DbcScanner::whole(SourceText what, std::uint64_t most)
{
    skipBlanks();
    const std::size_t begin = at_;
    std::uint64_t value = 0;
    const auto [rest, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    at_ = static_cast<std::size_t>(rest - text_.data());
    const bool isHexadecimal = value == 0 && at_ < text_.size() && (text_[at_] | 0x20) == 'x';
    if (error == std::errc{} && value <= most && !isHexadecimal) return value;
    at_ = begin;
    fail(Message(TR_NOOP("core", "%1, a whole number of at most %2"), what, most));
    return 0;
}

std::string_view DbcScanner::text(SourceText what)
{
    if (!isNext('"')) {
        fail(Message(TR_NOOP("core", "%1 in quotation marks"), what));
        return {};
    }
    const Place begin{at_, line_};
    advance();
    while (at_ < text_.size() && text_[at_] != '"') advanceEscaped();
    if (at_ == text_.size()) {
        failUnclosed(begin, what);
        return {};
    }
    const std::string_view found = text_.substr(begin.at + 1, at_ - begin.at - 1);
    advance();
    return found;
}

std::string_view DbcScanner::lastText(SourceText what)
{
    const Place begin = place();
    const std::string_view found = text(what);
    if (isNext(';')) return found;
    DbcScanner lines(found);
    lines.recover({});
    if (lines.atEnd()) return found;
    failUnclosed(begin, what);
    return {};
}

void DbcScanner::failUnclosed(const Place& begin, SourceText what)
{
    at_ = begin.at;
    line_ = begin.line;
    fail(Message(TR_NOOP("core", "a quotation mark at the end of %1"), what));
}

std::string_view DbcScanner::restOfLine()
{
    const std::size_t begin = at_;
    at_ = std::min(text_.find('\n', at_), text_.size());
    return text_.substr(begin, at_ - begin);
}

void DbcScanner::skipIndented()
{
    do {
        (void)restOfLine();
        if (at_ < text_.size()) advance();
    } while (at_ < text_.size() && isBlank(text_[at_]) && !isMessageLineNext());
}

bool DbcScanner::isMessageLineNext() const
{
    const std::size_t begin = text_.find_first_not_of(" \t", at_);
    if (begin == std::string_view::npos) return false;
    const std::string_view line = text_.substr(begin);
    return line.starts_with("BO_ ") || line.starts_with("SG_ ");
}

void DbcScanner::skipSection()
{
    for (int began = line_; !atEnd() && !consume(';');) {
        if (line_ > began && isSectionNext()) return;
        began = line_;
        if (isNext('"'))
            (void)lastText(TR_NOOP("core", "a text"));
        else if (wordIfAny().empty())
            advanceEscaped();
    }
}

void DbcScanner::fail(const Message& expected)
{
    if (!failure_.empty()) return;
    skipBlanks();
    // The token is a word, or a single semicolon.
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n;", at_ + 1), text_.size());
    const std::string_view found = text_.substr(at_, end - at_);
    failure_ = {TR_NOOP("core", "line %1: expected %2, found %3"), line_, expected,
                found.empty() ? Message(TR_NOOP("core", "the end of the file"))
                              : Message::verbatim(shown(found))};
    at_ = text_.size();
}

void DbcScanner::refuse(Message failure)
{
    if (failure_.empty()) failure_ = std::move(failure);
    at_ = text_.size();
}

void DbcScanner::advance()
{
    if (text_[at_] == '\n') ++line_;
    ++at_;
}

void DbcScanner::advanceEscaped()
{
    for (int i = text_[at_] == '\\' && at_ + 1 < text_.size() ? 2 : 1; i > 0; --i) advance();
}

void DbcScanner::skipBlanks()
{
    for (;;) {
        while (at_ < text_.size() && isBlank(text_[at_])) advance();
        if (!text_.substr(at_).starts_with("//")) return;
        (void)restOfLine();
    }
}

bool DbcScanner::isSectionNext()
{
    const std::size_t begin = at_;
    const std::string_view found = wordIfAny();
    at_ = begin;
    return isDbcKeyword(found);
}

}  // namespace terratact
