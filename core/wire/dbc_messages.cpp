#include "core/wire/dbc_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/file_read.h"
#include "core/text.h"
#include "core/wire/dbc_text.h"

namespace terratact {
namespace {

constexpr std::uint64_t kExtendedId = 0x8000'0000;  // the bit that tells 29 bits from 11
constexpr std::uint64_t kMost29Bits = 0x1FFF'FFFF, kMost11Bits = 0x7FF;
constexpr std::uint64_t kSignalsOfNoFrame = 0xC000'0000;  // VECTOR__INDEPENDENT_SIG_MSG
constexpr int kLongestFrame = 64;                         // [bytes]
constexpr std::size_t kMostWarnings = 20;

}  // namespace

void DbcWarnings::add(int line, const std::string& what)
{
    if (file_.warnings.size() >= kMostWarnings) {
        ++unsaid_;
        return;
    }
    file_.warnings.push_back(fileError(file_.path, fmt::format("line {}: {}", line, what)).text);
}

void DbcWarnings::end()
{
    if (unsaid_ > 0)
        file_.warnings.push_back(
            fmt::format("{}: {} more things are left out", file_.path, unsaid_));
}

// "BO_ 256 Engine: 8 Gateway"
void DbcMessages::message(int line)
{
    DbcMessage m;
    const std::uint64_t id = scan_.whole("the message's identifier", 0xFFFF'FFFF);
    m.name = scan_.word("the message's name");
    scan_.expect(':', "behind the message's name");
    const auto length = static_cast<int>(scan_.whole("the message's length in bytes", 65535));
    m.sender = scan_.word("the message's sender");
    isOpen_ = true;
    keeps_ = scan_.failure().empty() && id != kSignalsOfNoFrame && mayBe(id, m, length, line);
    if (!keeps_) return;
    m.extended = id >= kExtendedId;
    m.id = static_cast<std::uint32_t>(id & kMost29Bits);
    m.length = length;
    byId_.emplace(id, file_.messages.size());
    file_.messages.push_back(std::move(m));
}

bool DbcMessages::mayBe(std::uint64_t id, const DbcMessage& m, int length, int line)
{
    if (length > kLongestFrame) {
        warnings_.add(line,
                      fmt::format("the message {} is left out: it has {} bytes, no frame more "
                                  "than {}",
                                  m.name, length, kLongestFrame));
        return false;
    }
    const bool isExtended = id >= kExtendedId;
    if ((isExtended ? id - kExtendedId : id) > (isExtended ? kMost29Bits : kMost11Bits)) {
        scan_.refuse(fmt::format("line {}: the identifier {} of {} is none of CAN: expected at "
                                 "most 2047, or 2147483648 and 29 bits; correct it",
                                 line, id, m.name));
        return false;
    }
    if (const auto first = byId_.find(id); first != byId_.end()) {
        warnings_.add(line, fmt::format("the message {} is left out: {} has its identifier", m.name,
                                        file_.messages[first->second].name));
        return false;
    }
    return true;
}

// " SG_ Speed m1 : 8|16@1+ (0.1,-40) [0|250] "km/h" Display,Brake"
void DbcMessages::signal(int line)
{
    if (!isOpen_) return scan_.fail("expected a message (BO_) before its signals");
    DbcSignal s;
    s.name = scan_.word("the signal's name");
    const Multiplexing multiplexing = multiplex(s, line);
    scan_.expect(':', "behind the signal's name");
    s.start = static_cast<int>(scan_.whole("the signal's first bit", 65535));
    scan_.expect('|', "behind the signal's first bit");
    s.length = static_cast<int>(scan_.whole("the signal's length in bits", 65535));
    scan_.expect('@', "behind the signal's length");
    s.isBigEndian = scan_.whole("the byte order, 1 (little-endian) or 0", 1) == 0;
    if (scan_.take('-'))
        s.type = DbcSignal::Type::Signed;
    else
        scan_.expect('+', "or '-' behind the byte order");
    scaleAndRange(s);
    s.unit = readable(scan_.text("the signal's unit"), kDbcText, false);
    s.receivers = readable(scan_.restOfLine(), kDbcComment, false);
    s.receivers.erase(0, std::min(s.receivers.find_first_not_of(' '), s.receivers.size()));
    s.receivers.erase(s.receivers.find_last_not_of(' ') + 1);
    if (scan_.failure().empty() && keeps_) keep(std::move(s), multiplexing);
}

// "", "M", "m1" or "m1M"
DbcMessages::Multiplexing DbcMessages::multiplex(DbcSignal& s, int line)
{
    Multiplexing found{.line = line};
    const std::string_view word = scan_.wordIfAny();
    if (word.empty()) return found;
    std::uint64_t value = 0;
    const auto [rest, error] = std::from_chars(word.data() + 1, word.data() + word.size(), value);
    const std::string_view behind = word.substr(static_cast<std::size_t>(rest - word.data()));
    found.selects = word == "M";
    found.isNested = word.front() == 'm' && error == std::errc{} && behind == "M";
    const bool isSelected = word.front() == 'm' && error == std::errc{} && behind.empty();
    if (isSelected || found.isNested) s.selectedBy.push_back({value, value});
    if (!isSelected && !found.selects && !found.isNested)
        scan_.refuse(fmt::format("line {}: expected ':' behind the signal's name, or M or a "
                                 "multiplexor's value such as m1, found {}; mend the line",
                                 line, shown(word)));
    return found;
}

void DbcMessages::scaleAndRange(DbcSignal& s)
{
    scan_.expect('(', "before the signal's scale");
    s.scale = scan_.number("the signal's scale");
    scan_.expect(',', "between scale and offset");
    s.offset = scan_.number("the signal's offset");
    scan_.expect(')', "behind the signal's offset");
    scan_.expect('[', "before the signal's range");
    s.least = scan_.number("the least of the range");
    scan_.expect('|', "within the signal's range");
    s.most = scan_.number("the most of the range");
    scan_.expect(']', "behind the signal's range");
}

void DbcMessages::keep(DbcSignal s, const Multiplexing& multiplexing)
{
    DbcMessage& m = file_.messages.back();
    const int line = multiplexing.line;
    if (s.length < 1 || s.length > 64)
        return scan_.refuse(
            fmt::format("line {}: the signal {} has {} bits: expected 1 to 64; correct its length",
                        line, s.name, s.length));
    if (s.end() > 8 * m.length)
        return scan_.refuse(fmt::format(
            "line {}: the signal {} does not fit its message {}: it ends with bit {} of {}; "
            "correct its first bit, its length or its byte order, or the message's length",
            line, s.name, m.name, s.end(), 8 * m.length));
    if (s.scale == 0.0)
        return warnings_.add(line,
                             fmt::format("the signal {} is left out: its scale is 0", s.name));
    if (!names_.insert(s.name).second)
        return warnings_.add(
            line,
            fmt::format("the signal {} is left out: {} has another of that name", s.name, m.name));
    m.payload.push_back(std::move(s));
    multiplexing_.push_back(multiplexing);
}

// What the signals of the message have to do with each other is known at its end.
void DbcMessages::endMessage()
{
    if (isOpen_ && keeps_) {
        DbcMessage& m = file_.messages.back();
        std::size_t selectors = 0;
        bool isNested = false;
        for (std::size_t i = 0; i < m.payload.size(); ++i) {
            if (multiplexing_[i].selects) m.selector = i;
            selectors += multiplexing_[i].selects;
            isNested = isNested || multiplexing_[i].isNested;
        }
        if (selectors != 1 || isNested) dropSelected(m, isNested);
        for (std::size_t i = 0; i < m.payload.size(); ++i)
            signals_.emplace(std::pair(file_.messages.size() - 1, m.payload[i].name), i);
    }
    names_.clear();
    multiplexing_.clear();
    isOpen_ = false;
}

/// Signals of which it is not known when they are there.
void DbcMessages::dropSelected(DbcMessage& m, bool isNested)
{
    std::vector<DbcSignal> kept;
    m.selector.reset();
    std::size_t dropped = 0;
    int line = 0;
    for (std::size_t i = 0; i < m.payload.size(); ++i) {
        const bool keeps = m.payload[i].selectedBy.empty();
        if (!keeps && (line == 0 || multiplexing_[i].isNested)) line = multiplexing_[i].line;
        if (keeps)
            kept.push_back(std::move(m.payload[i]));
        else
            ++dropped;
    }
    m.payload = std::move(kept);
    if (dropped > 0)
        warnings_.add(line,
                      fmt::format("{} multiplexed signals of {} are left out: {}", dropped, m.name,
                                  isNested ? "it has one multiplexor below another"
                                           : "expected one signal marked M"));
}

DbcMessage* DbcMessages::messageNext(std::size_t* index)
{
    const auto found = byId_.find(scan_.whole("a message's identifier", 0xFFFF'FFFF));
    if (found == byId_.end()) return nullptr;
    if (index) *index = found->second;
    return &file_.messages[found->second];
}

DbcSignal* DbcMessages::signalNext()
{
    std::size_t index = 0;
    DbcMessage* m = messageNext(&index);
    const std::string name(scan_.word("a signal's name"));
    const auto found = m ? signals_.find(std::pair(index, name)) : signals_.end();
    return found == signals_.end() ? nullptr : &m->payload[found->second];
}

}  // namespace terratact
