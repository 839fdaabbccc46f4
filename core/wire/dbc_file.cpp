#include "core/wire/dbc_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/file_read.h"
#include "core/text.h"

namespace terratact {
namespace {

constexpr std::uint64_t kExtendedId = 0x8000'0000;  // the bit that tells 29 bits from 11
constexpr std::uint64_t kMost29Bits = 0x1FFF'FFFF, kMost11Bits = 0x7FF;
constexpr std::uint64_t kSignalsOfNoFrame = 0xC000'0000;  // VECTOR__INDEPENDENT_SIG_MSG
constexpr int kLongestFrame = 64;                         // [bytes]
constexpr std::size_t kMostWarnings = 20;
constexpr std::size_t kDbcName = 128, kDbcText = 80, kDbcComment = 2000;  // [bytes]

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// "BO_", "BA_DEF_DEF_", and whatever else may begin a section.
bool isKeyword(std::string_view word)
{
    return word == "VERSION"
        || (word.size() > 2 && word.back() == '_'
            && std::all_of(word.begin(), word.end(),
                           [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }));
}

/// How many bytes the character at `at` has in UTF-8; 0: it is none.
std::size_t utf8Length(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || text.size() - at < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xC0U) != 0x80) return 0;
    const unsigned char second = byte(at + 1);
    const bool isTooLong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool isNoCharacter =
        (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
    return isTooLong || isNoCharacter ? 0 : length;
}

bool isUtf8(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8Length(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

std::string fromLatin1(std::string_view text)
{
    std::string utf8;
    utf8.reserve(text.size() + text.size() / 8);
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xC0U | (byte >> 6U));
            utf8 += static_cast<char>(0x80U | (byte & 0x3FU));
        }
    }
    return utf8;
}

/// What a text of the file says, at most so many bytes and "…", without control characters: those of a
/// terminal have no business here.  Lines are kept only where they may be.
std::string readable(std::string_view utf8, std::size_t most, bool keepsLines)
{
    std::string text;
    for (std::size_t at = 0; at < utf8.size();) {
        const std::size_t length = std::max<std::size_t>(1, utf8Length(utf8, at));
        const std::string_view character = utf8.substr(at, length);
        at += length;
        if (text.size() + length > most) return text + "…";
        const bool isUpperControl = length == 2 && character[0] == '\xC2'
                                 && static_cast<unsigned char>(character[1]) < 0xA0;
        if (character == "\r" || (character == "\\" && utf8.substr(at).starts_with('"'))) continue;
        if (character == "\n" && keepsLines)
            text += '\n';
        else if (isControl(character[0]) || isUpperControl)
            text += ' ';
        else
            text += character;
    }
    return text;
}

/// Takes a DBC file apart into words, numbers and texts.  The first thing that is not as expected is kept as
/// failure(), and nothing more is found from there on.
class DbcScanner {
public:
    explicit DbcScanner(std::string_view text) : text_(text) {}

    const std::string& failure() const { return failure_; }
    /// Of what is next.
    int line()
    {
        skipBlanks();
        return line_;
    }
    bool atEnd()
    {
        skipBlanks();
        return at_ == text_.size();
    }
    bool isNext(char c)
    {
        skipBlanks();
        return at_ < text_.size() && text_[at_] == c;
    }
    bool take(char c)
    {
        if (!isNext(c)) return false;
        advance();
        return true;
    }
    void expect(char c, std::string_view place)
    {
        if (!take(c)) fail(fmt::format("expected '{}' {}", c, place));
    }
    bool isNameNext()
    {
        skipBlanks();
        return at_ < text_.size() && isNameCharacter(text_[at_])
            && !(text_[at_] >= '0' && text_[at_] <= '9');
    }
    /// Empty where there is none; nothing is wrong then.
    std::string_view wordIfAny()
    {
        skipBlanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && isNameCharacter(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    std::string_view word(std::string_view what)
    {
        skipBlanks();
        const std::size_t begin = at_;
        const std::string_view found = wordIfAny();
        if (!found.empty() && found.size() <= kDbcName) return found;
        at_ = begin;
        fail(fmt::format("expected {} of at most {} letters, digits and _", what, kDbcName));
        return {};
    }
    double number(std::string_view what)
    {
        skipBlanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && isOfNumber(text_[at_])) ++at_;
        std::string_view found = text_.substr(begin, at_ - begin);
        if (found.starts_with('+')) found.remove_prefix(1);
        const std::optional<double> value = numberFrom(found);
        if (value && std::isfinite(*value)) return *value;
        at_ = begin;
        fail(fmt::format("expected {}, a number", what));
        return 0.0;
    }
    std::uint64_t whole(std::string_view what, std::uint64_t most)
    {
        skipBlanks();
        const std::size_t begin = at_;
        std::uint64_t value = 0;
        const auto [rest, error] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        at_ = static_cast<std::size_t>(rest - text_.data());
        if (error == std::errc{} && value <= most) return value;
        at_ = begin;
        fail(fmt::format("expected {}, a whole number of at most {}", what, most));
        return 0;
    }
    /// What stands between quotation marks, as it is.
    std::string_view text(std::string_view what)
    {
        if (!isNext('"')) {
            fail(fmt::format("expected {} in quotation marks", what));
            return {};
        }
        const std::size_t before = at_;
        const int line = line_;
        advance();
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != '"')
            for (int i = text_[at_] == '\\' && at_ + 1 < text_.size() ? 2 : 1; i > 0; --i)
                advance();
        if (at_ == text_.size()) {
            at_ = before;
            line_ = line;
            fail(fmt::format("expected a quotation mark at the end of {}", what));
            return {};
        }
        const std::string_view found = text_.substr(begin, at_ - begin);
        advance();
        return found;
    }
    /// What is left of the line.
    std::string_view restOfLine()
    {
        const std::size_t begin = at_;
        at_ = std::min(text_.find('\n', at_), text_.size());
        return text_.substr(begin, at_ - begin);
    }
    /// Passes over this line and the indented or empty ones below it.
    void skipIndented()
    {
        do {
            (void)restOfLine();
            if (at_ < text_.size()) advance();
        } while (at_ < text_.size() && isBlank(text_[at_]));
    }
    /// Passes over a section up to its semicolon; one without ends where a line begins with the next.
    void skipSection()
    {
        for (int began = line_; !atEnd() && !take(';');) {
            if (line_ > began && isSectionNext()) return;
            began = line_;
            if (isNext('"'))
                (void)text("a text");
            else if (wordIfAny().empty())
                advance();
        }
    }
    /// failure: what was expected here.
    void fail(std::string_view expected)
    {
        if (!failure_.empty()) return;
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n;", at_), text_.size());
        const std::string_view found = text_.substr(at_, end - at_);
        failure_ = fmt::format(
            "line {}: {}, found {}; mend the line, or have the file exported anew", line_, expected,
            at_ == text_.size() ? "the end of the file"
            : found.empty()     ? "the end of the line"
                                : shown(found));
        at_ = text_.size();
    }
    void refuse(std::string failure)
    {
        if (failure_.empty()) failure_ = std::move(failure);
        at_ = text_.size();
    }

private:
    static bool isOfNumber(char c)
    {
        return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
    }
    void advance()
    {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }
    void skipBlanks()
    {
        while (at_ < text_.size() && isBlank(text_[at_])) advance();
    }
    bool isSectionNext()
    {
        const std::size_t begin = at_;
        const std::string_view found = wordIfAny();
        at_ = begin;
        return isKeyword(found);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::string failure_;
};

/// Of a signal while its message is read.
struct Multiplexing {
    int line = 0;
    bool selects = false;   // M
    bool isNested = false;  // m0M
};

class DbcParser {
public:
    DbcParser(const std::string& path, std::string_view utf8) : scan_(utf8) { file_.path = path; }

    Result<DbcFile> parse()
    {
        while (!scan_.atEnd()) {
            const int line = scan_.line();
            const std::string_view keyword = scan_.word("the keyword of a section (BO_, CM_ …)");
            if (keyword != "SG_") endMessage();
            section(keyword, line);
        }
        endMessage();
        if (!scan_.failure().empty()) return fileError(file_.path, scan_.failure());
        if (file_.messages.empty())
            return fileError(file_.path,
                             "describes no message: expected lines that begin with BO_; is it a "
                             "DBC file?");
        takeDefaults();
        if (unsaid_ > 0)
            file_.warnings.push_back(
                fmt::format("{}: {} more things are left out", file_.path, unsaid_));
        return std::move(file_);
    }

private:
    void section(std::string_view keyword, int line)
    {
        if (keyword == "BO_") return message(line);
        if (keyword == "SG_") return signal(line);
        if (keyword == "NS_" || keyword == "BS_" || keyword == "BU_") return scan_.skipIndented();
        if (keyword == "VERSION") return static_cast<void>(scan_.text("the version"));
        if (keyword == "CM_") comment();
        if (keyword == "VAL_") words(line);
        if (keyword == "SIG_VALTYPE_") valueType(line);
        if (keyword == "SG_MUL_VAL_") selections();
        if (keyword == "BA_") attribute();
        if (keyword == "BA_DEF_DEF_") attributeDefault();
        if (!keyword.empty() && !isKeyword(keyword))
            scan_.refuse(fmt::format("line {}: expected the keyword of a section, such as BO_ or "
                                     "CM_, found {}; mend the line, or have the file exported anew",
                                     line, shown(keyword)));
        scan_.skipSection();
    }

    void warn(int line, const std::string& what)
    {
        if (file_.warnings.size() >= kMostWarnings) {
            ++unsaid_;
            return;
        }
        file_.warnings.push_back(
            fileError(file_.path, fmt::format("line {}: {}", line, what)).text);
    }

    // "BO_ 256 Engine: 8 Gateway"
    void message(int line)
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

    bool mayBe(std::uint64_t id, const DbcMessage& m, int length, int line)
    {
        if (length > kLongestFrame) {
            warn(line, fmt::format("the message {} is left out: it has {} bytes, no frame more "
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
            warn(line, fmt::format("the message {} is left out: {} has its identifier", m.name,
                                   file_.messages[first->second].name));
            return false;
        }
        return true;
    }

    // " SG_ Speed m1 : 8|16@1+ (0.1,-40) [0|250] "km/h" Display,Brake"
    void signal(int line)
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
    Multiplexing multiplex(DbcSignal& s, int line)
    {
        Multiplexing found{.line = line};
        const std::string_view word = scan_.wordIfAny();
        if (word.empty()) return found;
        std::uint64_t value = 0;
        const auto [rest, error] =
            std::from_chars(word.data() + 1, word.data() + word.size(), value);
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

    void scaleAndRange(DbcSignal& s)
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

    void keep(DbcSignal s, const Multiplexing& multiplexing)
    {
        DbcMessage& m = file_.messages.back();
        const int line = multiplexing.line;
        if (s.length < 1 || s.length > 64)
            return scan_.refuse(fmt::format(
                "line {}: the signal {} has {} bits: expected 1 to 64; correct its length", line,
                s.name, s.length));
        if (s.end() > 8 * m.length)
            return scan_.refuse(fmt::format(
                "line {}: the signal {} does not fit its message {}: it ends with bit {} of {}; "
                "correct its first bit, its length or its byte order, or the message's length",
                line, s.name, m.name, s.end(), 8 * m.length));
        if (s.scale == 0.0)
            return warn(line, fmt::format("the signal {} is left out: its scale is 0", s.name));
        if (!names_.insert(s.name).second)
            return warn(line, fmt::format("the signal {} is left out: {} has another of that name",
                                          s.name, m.name));
        m.payload.push_back(std::move(s));
        multiplexing_.push_back(multiplexing);
    }

    /// What the signals of the message have to do with each other is known at its end.
    void endMessage()
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
    void dropSelected(DbcMessage& m, bool isNested)
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
            warn(line, fmt::format("{} multiplexed signals of {} are left out: {}", dropped, m.name,
                                   isNested ? "it has one multiplexor below another"
                                            : "expected one signal marked M"));
    }

    /// The message whose identifier is next; null: it is not known, or was left out.
    DbcMessage* messageNext(std::size_t* index = nullptr)
    {
        const auto found = byId_.find(scan_.whole("a message's identifier", 0xFFFF'FFFF));
        if (found == byId_.end()) return nullptr;
        if (index) *index = found->second;
        return &file_.messages[found->second];
    }

    /// Likewise, of identifier and name.
    DbcSignal* signalNext()
    {
        std::size_t index = 0;
        DbcMessage* m = messageNext(&index);
        const std::string name(scan_.word("a signal's name"));
        const auto found = m ? signals_.find(std::pair(index, name)) : signals_.end();
        return found == signals_.end() ? nullptr : &m->payload[found->second];
    }

    // "CM_ SG_ 256 Speed "Over ground.";"
    void comment()
    {
        std::string other;
        const std::string_view of = scan_.wordIfAny();
        std::string* comment = &other;
        if (of == "BO_") {
            if (DbcMessage* m = messageNext()) comment = &m->comment;
        } else if (of == "SG_") {
            if (DbcSignal* s = signalNext()) comment = &s->comment;
        } else if (!of.empty()) {
            (void)scan_.word("what the comment is about");
        }
        *comment = readable(scan_.text("a comment"), kDbcComment, true);
    }

    // "VAL_ 256 Gear 0 "neutral" 1 "first" ;", but not of an environment variable
    void words(int line)
    {
        if (scan_.isNameNext()) return;
        DbcSignal* s = signalNext();
        if (scan_.isNameNext())
            return warn(line, "the name of a table of words (VAL_TABLE_) is passed over");
        while (scan_.failure().empty() && !scan_.isNext(';') && !scan_.atEnd()) {
            const double raw = scan_.number("a raw value");
            std::string word = readable(scan_.text("the word of a raw value"), kDbcText, false);
            // Of 64 bits the highest are no exact doubles; such a one has no word.
            if (s && std::abs(raw) <= 0x1p53)
                s->words[static_cast<std::int64_t>(std::round(raw))] = std::move(word);
        }
    }

    // "SIG_VALTYPE_ 256 Torque : 1;"
    void valueType(int line)
    {
        DbcSignal* s = signalNext();
        (void)scan_.take(':');
        const std::uint64_t type = scan_.whole("0 (integer), 1 (float) or 2 (double)", 2);
        if (!s || type == 0) return;
        const int bits = type == 1 ? 32 : 64;
        if (s->length != bits)
            return scan_.refuse(fmt::format(
                "line {}: the signal {} is no {} of IEEE 754: it has {} bits, expected {}; correct "
                "its length, or take the line out",
                line, s->name, type == 1 ? "float" : "double", s->length, bits));
        s->type = type == 1 ? DbcSignal::Type::Float : DbcSignal::Type::Double;
    }

    // "SG_MUL_VAL_ 256 Speed Selector 1-1, 4-7;"
    void selections()
    {
        DbcSignal* s = signalNext();
        (void)scan_.word("the name of a multiplexor");
        std::vector<DbcSignal::Selection> ranges;
        do {
            DbcSignal::Selection range;
            range.first = scan_.whole("the first value of a multiplexor", ~std::uint64_t{0});
            scan_.expect('-', "between two values of a multiplexor");
            range.last = scan_.whole("the last value of a multiplexor", ~std::uint64_t{0});
            ranges.push_back(range);
        } while (scan_.take(',') && scan_.failure().empty());
        if (s && !s->selectedBy.empty()) s->selectedBy = std::move(ranges);
    }

    // "BA_ "GenMsgCycleTime" BO_ 256 100;"
    void attribute()
    {
        const std::string name = readable(scan_.text("an attribute's name"), kDbcName, false);
        if (scan_.wordIfAny() != "BO_") return;
        DbcMessage* m = messageNext();
        if (scan_.isNext('"')) return;
        const double value = scan_.number("the attribute's value");
        if (m) m->attributes[name] = value;
    }

    void attributeDefault()
    {
        if (scan_.text("an attribute's name") == "GenMsgCycleTime" && !scan_.isNext('"'))
            cycleTime_ = scan_.number("the attribute's default");
    }

    void takeDefaults()
    {
        if (!(cycleTime_ > 0.0)) return;
        for (DbcMessage& m : file_.messages) m.attributes.emplace("GenMsgCycleTime", cycleTime_);
    }

    DbcScanner scan_;
    DbcFile file_;
    std::unordered_map<std::uint64_t, std::size_t> byId_;
    std::map<std::pair<std::size_t, std::string>, std::size_t> signals_;
    double cycleTime_ = 0.0;  // [ms]
    std::size_t unsaid_ = 0;  // warnings beyond the first few

    // Of the message that is being read.
    bool isOpen_ = false, keeps_ = false;
    std::set<std::string> names_;
    std::vector<Multiplexing> multiplexing_;  // of its signals
};

}  // namespace

Result<DbcFile> readDbc(const std::string& path)
{
    const auto content = readFile(path, kMostDbcBytes);
    if (!content) return content.error();
    return dbcFrom(path, *content);
}

Result<DbcFile> dbcFrom(const std::string& path, std::string_view content)
{
    if (content.find('\0') != std::string_view::npos)
        return fileError(path,
                         "is no text in UTF-8 or ISO 8859-1: expected a DBC file; save it anew as "
                         "such");
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (content.starts_with(kMark)) content.remove_prefix(kMark.size());
    if (isUtf8(content)) return DbcParser(path, content).parse();
    return DbcParser(path, fromLatin1(content)).parse();
}

}  // namespace terratact
