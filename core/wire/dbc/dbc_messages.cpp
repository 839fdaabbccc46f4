#include "core/wire/dbc/dbc_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/store/file_read.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

constexpr std::uint64_t kExtendedId = 0x8000'0000;  // bit that marks an identifier of 29 bits
constexpr std::uint64_t kMax29Bits = 0x1FFF'FFFF, kMax11Bits = 0x7FF;
// Vector's message for signals without a frame; it occurs with several identifiers.
constexpr std::string_view kSignalsOfNoFrame = "VECTOR__INDEPENDENT_SIG_MSG";
constexpr int kMaxFrameLength = 64;  // [bytes]
constexpr std::size_t kMaxWarnings = 20;
constexpr std::size_t kMaxLineRanges = 50;

/// Returns ranges of the same values in the order of selectedBy, so that each is found quickly.
std::vector<DbcSignal::Selection> withoutOverlap(std::vector<DbcSignal::Selection> ranges)
{
    std::ranges::sort(ranges, {}, [](const auto& r) { return std::pair(r.first, r.last); });
    std::vector<DbcSignal::Selection> merged;
    for (const DbcSignal::Selection& range : ranges)
        if (!merged.empty() && range.first <= merged.back().last)
            merged.back().last = std::max(merged.back().last, range.last);
        else
            merged.push_back(range);
    return merged;
}

using SignalsBelow = std::vector<std::vector<std::size_t>>;  // of each signal as a multiplexor

/// Returns the most signals that a frame may have with this one: itself, and those that one of its
/// values selects.
std::size_t mostWith(const DbcMessage& m, const SignalsBelow& below, std::size_t signal)
{
    std::vector<std::pair<std::uint64_t, std::size_t>> firsts, lasts;  // values, and their signals
    for (const std::size_t i : below[signal]) {
        const std::size_t signals = mostWith(m, below, i);
        for (const DbcSignal::Selection& range : m.payload[i].selectedBy) {
            if (range.first > range.last) continue;
            firsts.emplace_back(range.first, signals);
            lasts.emplace_back(range.last, signals);
        }
    }
    std::ranges::sort(firsts);
    std::ranges::sort(lasts);
    std::size_t selected = 0, most = 0;
    auto ended = lasts.begin();
    for (const auto& [first, signals] : firsts) {
        for (; ended->first < first; ++ended) selected -= ended->second;
        selected += signals;
        most = std::max(most, selected);
    }
    return 1 + most;
}

/// Returns the most signals that a frame of a message may have, whatever its length.
std::size_t mostAtOnce(const DbcMessage& m)
{
    SignalsBelow below(m.payload.size());
    for (std::size_t i = 0; i < m.payload.size(); ++i)
        if (m.payload[i].selector) below[*m.payload[i].selector].push_back(i);
    std::size_t most = 0;
    for (std::size_t i = 0; i < m.payload.size(); ++i)
        if (!m.payload[i].selector) most += mostWith(m, below, i);
    return most;
}

}  // namespace

void DbcWarnings::add(Message what)
{
    file_.warnings.push_back(fileError(file_.path, std::move(what)).message);
}

void DbcWarnings::add(int line, const Message& what)
{
    list(line, Message(TR_NOOP("core", "line %1: %2"), line, what));
}

void DbcWarnings::addEntry(int line, const Message& failure)
{
    list(line, Message(TR_NOOP("core", "%1; this entry is left out"), failure));
}

std::string DbcWarnings::readableUpTo(std::size_t most, std::string_view text, SourceText what,
                                      int line)
{
    std::string whole = readable(text, text.size(), false);
    if (whole.size() <= most) return whole;
    add(line,
        Message(TR_NOOP("core", "%1 is longer than %2 bytes: the rest is left out"), what, most));
    return readable(text, most, false);
}

void DbcWarnings::list(int line, Message what)
{
    if (file_.warnings.size() < kMaxWarnings) return add(std::move(what));
    ++omitted_;
    const int behind = lines_.empty() ? -1 : line - lines_.back().second;
    if (behind == 0 || behind == 1)
        lines_.back().second = line;
    else if (lines_.size() <= kMaxLineRanges)
        lines_.emplace_back(line, line);
}

void DbcWarnings::end()
{
    if (omitted_ == 0) return;
    std::string lines;
    for (std::size_t i = 0; i < std::min(lines_.size(), kMaxLineRanges); ++i) {
        const auto& [first, last] = lines_[i];
        lines += fmt::format("{}{}", i > 0 ? ", " : "", first);
        if (last > first) lines += fmt::format("–{}", last);
    }
    if (lines_.size() > kMaxLineRanges) lines += ", …";
    add(Message(TR_NOOP("core", "%1 more things are left out, in lines %2"), omitted_, lines));
}

// Reads "BO_ 256 Engine: 8 Gateway".
void DbcMessages::message(int line)
{
    DbcMessage m;
    const std::uint64_t id = scan_.whole(TR_NOOP("core", "the message's identifier"), 0xFFFF'FFFF);
    m.name = scan_.word(TR_NOOP("core", "the message's name"));
    scan_.expect(':', TR_NOOP("core", "%1 behind the message's name"));
    const auto length =
        static_cast<int>(scan_.whole(TR_NOOP("core", "the message's length in bytes"), 65535));
    if (!scan_.isLineEndNext()) m.sender = scan_.word(TR_NOOP("core", "the message's sender"));
    isOpen_ = true;
    keeps_ = scan_.failure().empty() && m.name != kSignalsOfNoFrame && mayBe(id, m, length, line);
    if (!keeps_) return;
    m.extended = id >= kExtendedId;
    m.id = static_cast<std::uint32_t>(id & kMax29Bits);
    m.length = length;
    byId_.emplace(id, file_.messages.size());
    file_.messages.push_back(std::move(m));
    begins_.push_back(line);
    lines_.push_back(0);
}

bool DbcMessages::mayBe(std::uint64_t id, const DbcMessage& m, int length, int line)
{
    if (length > kMaxFrameLength) {
        warnings_.add(
            line,
            Message(TR_NOOP("core",
                            "the message %1 is left out: it has %2 bytes, no frame more than %3"),
                    m.name, length, kMaxFrameLength));
        return false;
    }
    const bool isExtended = id >= kExtendedId;
    if ((isExtended ? id - kExtendedId : id) > (isExtended ? kMax29Bits : kMax11Bits)) {
        warnings_.add(
            line,
            Message(TR_NOOP("core", "the message %1 is left out: its identifier %2 is none of CAN; "
                                    "expected at most 2047, or 2147483648 and 29 bits"),
                    m.name, id));
        return false;
    }
    if (const auto first = byId_.find(id); first != byId_.end()) {
        warnings_.add(line,
                      Message(TR_NOOP("core", "the message %1 is left out: %2 has its identifier"),
                              m.name, file_.messages[first->second].name));
        return false;
    }
    return true;
}

// Reads " SG_ Speed m1 : 8|16@1+ (0.1,-40) [0|250] "km/h" Display,Brake".
void DbcMessages::signal(int line)
{
    if (!isOpen_) return scan_.fail(TR_NOOP("core", "a message (BO_) before its signals"));
    DbcSignal s;
    s.name = scan_.word(TR_NOOP("core", "the signal's name"));
    const std::optional<Multiplexing> multiplexing = multiplex(s, line);
    scan_.expect(':', TR_NOOP("core", "%1 behind the signal's name"));
    s.start = static_cast<int>(scan_.whole(TR_NOOP("core", "the signal's first bit"), 65535));
    scan_.expect('|', TR_NOOP("core", "%1 behind the signal's first bit"));
    s.length = static_cast<int>(scan_.whole(TR_NOOP("core", "the signal's length in bits"), 65535));
    scan_.expect('@', TR_NOOP("core", "%1 behind the signal's length"));
    s.isBigEndian = scan_.whole(TR_NOOP("core", "the byte order, 1 (little-endian) or 0"), 1) == 0;
    if (scan_.consume('-'))
        s.type = DbcSignal::Type::Signed;
    else
        scan_.expect('+', TR_NOOP("core", "%1 or '-' behind the byte order"));
    scaleAndRange(s);
    const std::string_view unit = scan_.text(TR_NOOP("core", "the signal's unit"));
    if (unit.find('\n') != std::string_view::npos)
        return scan_.refuse(Message(TR_NOOP("core", "line %1: expected %2, found %3"), line,
                                    Message(TR_NOOP("core", "a quotation mark at the end of %1"),
                                            TR_NOOP("core", "the signal's unit")),
                                    TR_NOOP("core", "the end of the line")));
    s.unit = warnings_.readableUpTo(kDbcUnit, unit, TR_NOOP("core", "the signal's unit"), line);
    s.receivers = readable(scan_.restOfLine(), kDbcText, false);
    s.receivers.erase(0, std::min(s.receivers.find_first_not_of(' '), s.receivers.size()));
    s.receivers.erase(s.receivers.find_last_not_of(' ') + 1);
    if (scan_.failure().empty() && keeps_ && multiplexing) keep(std::move(s), *multiplexing);
}

// Reads "", "M", "m1" or "m1M". Returns empty for anything else, with a warning.
std::optional<DbcMessages::Multiplexing> DbcMessages::multiplex(DbcSignal& s, int line)
{
    Multiplexing found{.line = line};
    const std::string_view word = scan_.wordIfAny();
    if (word.empty()) return found;
    std::uint64_t value = 0;
    const auto [rest, error] = std::from_chars(word.data() + 1, word.data() + word.size(), value);
    const std::string_view behind = word.substr(static_cast<std::size_t>(rest - word.data()));
    const bool isSelected = word.front() == 'm' && error == std::errc{};
    found.selects = word == "M";
    if (isSelected && (behind.empty() || behind == "M")) {
        s.selectedBy.push_back({value, value});
        return found;
    }
    if (found.selects) return found;
    warnings_.add(
        line, Message(TR_NOOP("core", "the signal %1 is left out: expected ':' behind its name, or "
                                      "M or a multiplexor's value such as m1, found %2"),
                      shown(s.name), shown(word)));
    return std::nullopt;
}

void DbcMessages::scaleAndRange(DbcSignal& s)
{
    scan_.expect('(', TR_NOOP("core", "%1 before the signal's scale"));
    s.scale = scan_.number(TR_NOOP("core", "the signal's scale"));
    scan_.expect(',', TR_NOOP("core", "%1 between scale and offset"));
    s.offset = scan_.number(TR_NOOP("core", "the signal's offset"));
    scan_.expect(')', TR_NOOP("core", "%1 behind the signal's offset"));
    range(s);
}

// Reads "[-1|.5]". Only displays use the range: a range that is no pair of numbers is ignored.
void DbcMessages::range(DbcSignal& s)
{
    scan_.expect('[', TR_NOOP("core", "%1 before the signal's range"));
    const std::string_view both = scan_.upTo(']');
    const std::size_t bar = both.find('|');
    const auto number = [](std::string_view text) -> std::optional<double> {
        while (text.starts_with(' ')) text.remove_prefix(1);
        while (text.ends_with(' ')) text.remove_suffix(1);
        if (text.starts_with('+')) text.remove_prefix(1);
        const std::optional<double> value = numberFrom(text);
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    if (bar != std::string_view::npos) {
        const auto least = number(both.substr(0, bar)), most = number(both.substr(bar + 1));
        if (least && most) {
            s.least = *least;
            s.most = *most;
        }
    }
    scan_.expect(']', TR_NOOP("core", "%1 behind the signal's range"));
}

void DbcMessages::keep(DbcSignal s, const Multiplexing& multiplexing)
{
    DbcMessage& m = file_.messages.back();
    const int line = multiplexing.line;
    if (s.length < 1 || s.length > 64)
        return warnings_.add(
            line,
            Message(TR_NOOP("core", "the signal %1 is left out: it has %2 bits, expected 1 to 64"),
                    s.name, s.length));
    if (s.end() > 8 * m.length)
        return warnings_.add(line,
                             Message(TR_NOOP("core", "the signal %1 is left out: it does not fit "
                                                     "its message %2, it ends with bit %3 of %4"),
                                     s.name, m.name, s.end(), 8 * m.length));
    if (m.payload.size() >= DbcMessage::kMaxSignals)
        return warnings_.add(
            line, Message(TR_NOOP("core", "the signal %1 is left out: its message %2 has more than "
                                          "%3 signals"),
                          s.name, m.name, DbcMessage::kMaxSignals));
    if (s.scale == 0.0)
        return warnings_.add(
            line, Message(TR_NOOP("core", "the signal %1 is left out: its scale is 0"), s.name));
    if (!names_.insert(s.name).second)
        return warnings_.add(
            line, Message(TR_NOOP("core", "the signal %1 is left out: %2 has another of that name"),
                          s.name, m.name));
    m.payload.push_back(std::move(s));
    multiplexing_.push_back(multiplexing);
}

// Relates the signals of the message to each other, which is possible only at its end.
void DbcMessages::endMessage()
{
    if (isOpen_ && keeps_) {
        DbcMessage& m = file_.messages.back();
        std::optional<std::size_t> selector;
        std::size_t selectors = 0;
        for (std::size_t i = 0; i < m.payload.size(); ++i) {
            if (multiplexing_[i].selects) selector = i;
            selectors += multiplexing_[i].selects;
            if (lines_.back() == 0 && !m.payload[i].selectedBy.empty())
                lines_.back() = multiplexing_[i].line;
        }
        for (std::size_t i = 0; i < m.payload.size(); ++i) {
            if (!m.payload[i].selectedBy.empty() && selectors == 1)
                m.payload[i].selector = selector;
            signals_.emplace(std::pair(file_.messages.size() - 1, m.payload[i].name), i);
        }
    }
    names_.clear();
    multiplexing_.clear();
    isOpen_ = false;
}

DbcSignal& DbcMessages::at(const Place& place)
{
    return file_.messages[place.message].payload[place.signal];
}

void DbcMessages::select(const Place& place, const std::string& multiplexor,
                         std::vector<DbcSignal::Selection> ranges, int line)
{
    DbcSignal& s = at(place);
    if (s.selectedBy.empty()) return;
    const auto above = signals_.find(std::pair(place.message, multiplexor));
    if (above == signals_.end())
        return warnings_.add(
            line,
            Message(TR_NOOP("core", "what selects %1 is passed over: its message has no signal %2"),
                    s.name, shown(multiplexor)));
    s.selector = above->second;
    s.selectedBy = withoutOverlap(std::move(ranges));
}

void DbcMessages::leaveOut(const Place& place)
{
    leftOut_[place.message].insert(place.signal);
}

void DbcMessages::rename(const Place& place, std::string longName, int line)
{
    longNames_.push_back({place, std::move(longName), line});
}

void DbcMessages::assign(LongName longName)
{
    const auto& [place, name, line] = longName;
    const auto owner = signals_.emplace(std::pair(place.message, name), place.signal).first->second;
    if (owner != place.signal)
        return warnings_.add(
            line, Message(TR_NOOP("core", "the long name %1 of the signal %2 is left out: %3 has "
                                          "another signal of that name"),
                          shown(name), at(place).name, file_.messages[place.message].name));
    at(place).name = std::move(longName.name);
}

/// Returns signals without a multiplexor, below a removed one, or nested too deep; a circle counts
/// as too deep.
std::vector<bool> DbcMessages::unselectable(std::size_t message) const
{
    const DbcMessage& m = file_.messages[message];
    const auto out = leftOut_.find(message);
    std::vector<bool> isOut(m.payload.size());
    for (std::size_t i = 0; i < m.payload.size(); ++i) {
        std::optional<std::size_t> at = i;
        for (int depth = 0; at && !isOut[i]; ++depth) {
            const DbcSignal& s = m.payload[*at];
            const bool isLeft = out != leftOut_.end() && out->second.contains(*at);
            isOut[i] =
                isLeft || depth > DbcSignal::kMaxNesting || (!s.selectedBy.empty() && !s.selector);
            at = s.selectedBy.empty() ? std::nullopt : s.selector;
        }
    }
    return isOut;
}

void DbcMessages::finish()
{
    for (LongName& longName : longNames_) assign(std::move(longName));
    for (std::size_t i = 0; i < file_.messages.size(); ++i) {
        finish(i, unselectable(i));
        warnOfOverlap(i);
    }
}

void DbcMessages::warnOfOverlap(std::size_t message)
{
    const DbcMessage& m = file_.messages[message];
    const std::size_t most = mostSignals(static_cast<std::size_t>(m.length));
    if (m.payload.size() <= most) return;
    const std::size_t atOnce = mostAtOnce(m);
    if (atOnce <= most) return;
    warnings_.add(begins_[message],
                  Message(TR_NOOP("core", "the message %1 describes up to %2 signals in a frame of "
                                          "%3 bytes: only the first %4 of a frame are read"),
                          m.name, atOnce, m.length, most));
}

void DbcMessages::finish(std::size_t message, std::vector<bool> isOut)
{
    DbcMessage& m = file_.messages[message];
    std::vector<DbcSignal> kept;
    std::vector<std::size_t> newPlace(m.payload.size());
    std::size_t dropped = 0;
    for (std::size_t i = 0; i < m.payload.size(); ++i) {
        newPlace[i] = kept.size();
        if (!isOut[i]) kept.push_back(std::move(m.payload[i]));
        dropped += isOut[i] && !m.payload[i].selectedBy.empty();
    }
    for (DbcSignal& s : kept)
        if (s.selector) s.selector = newPlace[*s.selector];
    m.payload = std::move(kept);
    if (dropped > 0)
        warnings_.add(
            lines_[message],
            Message(TR_NOOP("core",
                            "%1 multiplexed signals of %2 are left out: expected one signal marked "
                            "M, or what selects them (SG_MUL_VAL_), at most %3 below each other"),
                    dropped, m.name, DbcSignal::kMaxNesting));
}

DbcMessage* DbcMessages::messageNext(std::size_t* index)
{
    const auto found =
        byId_.find(scan_.whole(TR_NOOP("core", "a message's identifier"), 0xFFFF'FFFF));
    if (found == byId_.end()) return nullptr;
    if (index) *index = found->second;
    return &file_.messages[found->second];
}

std::optional<DbcMessages::Place> DbcMessages::signalNext()
{
    std::size_t index = 0;
    const DbcMessage* m = messageNext(&index);
    const std::string name(scan_.word(TR_NOOP("core", "a signal's name")));
    const auto found = m ? signals_.find(std::pair(index, name)) : signals_.end();
    if (found == signals_.end()) return std::nullopt;
    return Place{index, found->second};
}

}  // namespace terratact
