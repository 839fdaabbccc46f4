#include "core/wire/dbc/dbc_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/store/content_kind.h"
#include "core/store/file_read.h"
#include "core/wire/dbc/dbc_messages.h"
#include "core/wire/dbc/dbc_scanner.h"
#include "core/wire/dbc/dbc_text.h"

namespace terratact {
namespace {

/// Parser of a file's sections. Sections refer to messages that stand before them.
class DbcParser {
public:
    DbcParser(const std::string& path, std::string_view utf8) : scan_(utf8) { file_.path = path; }

    void warn(Message what) { warnings_.add(std::move(what)); }

    /// Names the lines with zero bytes. content: the file before they became blanks.
    void warnOfZeros(std::string_view content)
    {
        for (int line = 1; !content.empty(); ++line) {
            const std::string_view text = content.substr(0, content.find('\n'));
            if (text.find('\0') != std::string_view::npos)
                warnings_.add(line, TR_NOOP("core", "has zero bytes, which are read as blanks"));
            content.remove_prefix(std::min(text.size() + 1, content.size()));
        }
    }

    Result<DbcFile> parse()
    {
        while (!scan_.atEnd()) {
            const DbcScanner::Place place = scan_.place();
            const std::string_view keyword =
                scan_.word(TR_NOOP("core", "the keyword of a section (BO_, CM_ …)"));
            if (keyword != "SG_") messages_.endMessage();
            section(keyword, place.line);
            if (scan_.failure().empty()) continue;
            warnings_.addEntry(place.line, scan_.failure());
            scan_.recover(place);
        }
        messages_.endMessage();
        if (file_.messages.empty()) return describesNothing();
        messages_.finish();
        readDefaults();
        warnings_.end();
        return std::move(file_);
    }

private:
    Error describesNothing() const
    {
        if (file_.warnings.empty())
            return fileError(file_.path,
                             TR_NOOP("core", "describes no message: expected lines that "
                                             "begin with BO_; is it a DBC file?"));
        // Without the file's name, which precedes it.
        const Message& first = file_.warnings.front().arguments.back();
        return fileError(
            file_.path,
            Message(TR_NOOP("core",
                            "describes no message: expected lines that begin with BO_; is it "
                            "a DBC file? First fault: %1"),
                    first));
    }

    void section(std::string_view keyword, int line)
    {
        if (keyword == "BO_") return messages_.message(line);
        if (keyword == "SG_") return messages_.signal(line);
        if (keyword == "NS_" || keyword == "BS_" || keyword == "BU_") return scan_.skipIndented();
        if (keyword == "VERSION")
            return static_cast<void>(scan_.lastText(TR_NOOP("core", "the version")));
        if (keyword == "CM_") comment();
        if (keyword == "VAL_") words(line);
        if (keyword == "SIG_VALTYPE_") valueType(line);
        if (keyword == "SG_MUL_VAL_") selections(line);
        if (keyword == "BA_") attribute(line);
        if (keyword == "BA_DEF_") attributeKind();
        if (keyword == "BA_DEF_DEF_") attributeDefault();
        if (!keyword.empty() && !isDbcKeyword(keyword))
            scan_.refuse(Message(TR_NOOP("core", "line %1: expected %2, found %3"), line,
                                 TR_NOOP("core", "the keyword of a section, such as BO_ or CM_"),
                                 shown(keyword)));
        scan_.skipSection();
    }

    // Reads "CM_ SG_ 256 Speed "Over ground.";".
    void comment()
    {
        std::string other;
        const std::string_view of = scan_.wordIfAny();
        std::string* comment = &other;
        if (of == "BO_") {
            if (DbcMessage* m = messages_.messageNext()) comment = &m->comment;
        } else if (of == "SG_") {
            if (const auto place = messages_.signalNext()) comment = &messages_.at(*place).comment;
        } else if (!of.empty()) {
            (void)scan_.word(TR_NOOP("core", "what the comment is about"));
        }
        *comment = readable(scan_.lastText(TR_NOOP("core", "a comment")), kDbcText, true);
    }

    // Reads "VAL_ 256 Gear 0 "neutral" 1 "first" ;", but skips the values of an environment
    // variable.
    void words(int line)
    {
        if (scan_.isNameNext()) return;
        const auto place = messages_.signalNext();
        if (scan_.isNameNext())
            return warnings_.add(
                line, TR_NOOP("core", "the name of a table of words (VAL_TABLE_) is passed over"));
        while (scan_.failure().empty() && !scan_.isNext(';') && !scan_.atEnd()) {
            const std::optional<DbcRaw> raw = scan_.raw(TR_NOOP("core", "a raw value"));
            constexpr SourceText kWhat = TR_NOOP("core", "the word of a raw value");
            std::string word = warnings_.readableUpTo(kDbcWord, scan_.text(kWhat), kWhat, line);
            if (!place || word.find_first_not_of(' ') == std::string::npos) continue;
            if (raw)
                messages_.at(*place).words[*raw] = std::move(word);
            else
                warnings_.add(line,
                              Message(TR_NOOP("core", "the word %1 is left out: expected its "
                                                      "raw value in at most 64 bits, with all "
                                                      "its digits"),
                                      shown(word)));
        }
    }

    // Reads "SIG_VALTYPE_ 256 Torque : 1;".
    void valueType(int line)
    {
        const auto place = messages_.signalNext();
        (void)scan_.consume(':');
        const std::uint64_t type =
            scan_.whole(TR_NOOP("core", "0 (integer), 1 (float) or 2 (double)"), 2);
        if (!place || type == 0) return;
        DbcSignal& s = messages_.at(*place);
        const int bits = type == 1 ? 32 : 64;
        if (s.length == bits) {
            s.type = type == 1 ? DbcSignal::Type::Float : DbcSignal::Type::Double;
            return;
        }
        warnings_.add(line, Message(TR_NOOP("core", "the signal %1 is left out: it is no %2 of "
                                                    "IEEE 754, it has %3 bits, expected %4"),
                                    s.name, type == 1 ? "float" : "double", s.length, bits));
        messages_.leaveOut(*place);
    }

    // Reads "SG_MUL_VAL_ 256 Speed Selector 1-1, 4-7;".
    void selections(int line)
    {
        const auto place = messages_.signalNext();
        const std::string multiplexor(scan_.word(TR_NOOP("core", "the name of a multiplexor")));
        std::vector<DbcSignal::Selection> ranges;
        do {
            DbcSignal::Selection range;
            range.first =
                scan_.whole(TR_NOOP("core", "the first value of a multiplexor"), ~std::uint64_t{0});
            scan_.expect('-', TR_NOOP("core", "%1 between two values of a multiplexor"));
            range.last =
                scan_.whole(TR_NOOP("core", "the last value of a multiplexor"), ~std::uint64_t{0});
            ranges.push_back(range);
        } while (scan_.consume(',') && scan_.failure().empty());
        if (place && scan_.failure().empty())
            messages_.select(*place, multiplexor, std::move(ranges), line);
    }

    // Reads "BA_ "GenMsgCycleTime" BO_ 256 100;".
    void attribute(int line)
    {
        const std::string name =
            readable(scan_.text(TR_NOOP("core", "an attribute's name")), kDbcName, false);
        if (name == "ProtocolType" && scan_.isNext('"')) {
            isJ1939_ = scan_.text(TR_NOOP("core", "the protocol")) == "J1939";
            return;
        }
        const std::string_view of = scan_.wordIfAny();
        if (of == "SG_" && name == "SystemSignalLongSymbol") return signalName(line);
        if (of != "BO_") return;
        std::size_t index = 0;
        DbcMessage* m = messages_.messageNext(&index);
        if (name == "SystemMessageLongSymbol") return messageName(m, line);
        if (name == "VFrameFormat") return frameFormat(m, index);
        if (scan_.isNext('"')) return;
        const double value = scan_.number(TR_NOOP("core", "the attribute's value"));
        if (m) m->attributes[name] = value;
    }

    std::string longName(int line)
    {
        constexpr SourceText kWhat = TR_NOOP("core", "a long name");
        return warnings_.readableUpTo(kDbcName, scan_.text(kWhat), kWhat, line);
    }

    void signalName(int line)
    {
        const auto place = messages_.signalNext();
        std::string name = longName(line);
        if (place && !name.empty()) messages_.rename(*place, std::move(name), line);
    }

    void messageName(DbcMessage* m, int line)
    {
        std::string name = longName(line);
        if (m && !name.empty()) m->name = std::move(name);
    }

    /// Reads a format: its name, or its number in the file's list of formats.
    std::string formatNext()
    {
        if (scan_.isNext('"')) return std::string(scan_.text(TR_NOOP("core", "a frame format")));
        const std::uint64_t number =
            scan_.whole(TR_NOOP("core", "the number of a frame format"), 65535);
        if (formats_.empty()) return number == kJ1939Format ? kJ1939 : "";
        return number < formats_.size() ? formats_[number] : "";
    }

    // Reads "BA_ "VFrameFormat" BO_ 2566834709 3;".
    void frameFormat(const DbcMessage* m, std::size_t index)
    {
        std::string format = formatNext();
        if (m) formatOf_[index] = std::move(format);
    }

    // Reads "BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG";".
    void attributeKind()
    {
        if (scan_.wordIfAny() != "BO_"
            || scan_.text(TR_NOOP("core", "an attribute's name")) != "VFrameFormat"
            || scan_.wordIfAny() != "ENUM")
            return;
        formats_.clear();
        do formats_.emplace_back(scan_.text(TR_NOOP("core", "a frame format")));
        while (scan_.consume(',') && scan_.failure().empty());
    }

    void attributeDefault()
    {
        const std::string_view name = scan_.text(TR_NOOP("core", "an attribute's name"));
        if (name == "VFrameFormat") defaultFormat_ = formatNext();
        if (name == "ProtocolType" && scan_.isNext('"'))
            isJ1939_ = isJ1939_ || scan_.text(TR_NOOP("core", "the protocol")) == "J1939";
        if (name == "GenMsgCycleTime" && !scan_.isNext('"'))
            cycleTime_ = scan_.number(TR_NOOP("core", "the attribute's default"));
    }

    void readDefaults()
    {
        if (defaultFormat_.empty() && formats_.empty() && isJ1939_) defaultFormat_ = kJ1939;
        for (std::size_t i = 0; i < file_.messages.size(); ++i) {
            DbcMessage& m = file_.messages[i];
            if (cycleTime_ > 0.0) m.attributes.emplace("GenMsgCycleTime", cycleTime_);
            const auto format = formatOf_.find(i);
            m.isParameterGroup =
                m.extended
                && (format == formatOf_.end() ? defaultFormat_ : format->second) == kJ1939;
        }
    }

    DbcScanner scan_;
    DbcFile file_;
    DbcWarnings warnings_{file_};
    DbcMessages messages_{scan_, file_, warnings_};
    double cycleTime_ = 0.0;  // [ms]

    static constexpr const char* kJ1939 = "J1939PG";
    // number of the J1939 format if a file does not list its formats
    static constexpr std::uint64_t kJ1939Format = 3;
    std::vector<std::string> formats_;
    std::map<std::size_t, std::string> formatOf_;  // frame format of each message
    std::string defaultFormat_;
    bool isJ1939_ = false;
};

}  // namespace

Result<DbcFile> readDbc(const std::string& path)
{
    const auto content = readFile(path, kMaxDbcBytes);
    if (!content) return content.error();
    return dbcFrom(path, *content);
}

namespace {

/// Returns true if a text has bytes that Windows code pages 1250 and 1252 map to different letters.
/// It ignores ² and ³, which occur in units.
bool dependsOnCodePage(std::string_view text)
{
    constexpr std::string_view kSame = "\x80\x82\x84\x85\x86\x87\x89\x8A\x8B\x8E\x91\x92\x93\x94"
                                       "\x95\x96\x97\x99\x9A\x9B\x9E\xA0\xA4\xA6"
                                       "\xA7\xA8\xA9\xAB\xAC\xAD\xAE\xB0\xB1\xB2\xB3\xB4\xB5\xB6"
                                       "\xB7\xB8\xBB\xC1\xC2\xC4\xC7\xC9\xCB\xCD"
                                       "\xCE\xD3\xD4\xD6\xD7\xDA\xDC\xDD\xDF\xE1\xE2\xE4\xE7\xE9"
                                       "\xEB\xED\xEE\xF3\xF4\xF6\xF7\xFA\xFC\xFD";
    return std::any_of(text.begin(), text.end(), [&](char c) {
        return static_cast<unsigned char>(c) >= 0x80 && kSame.find(c) == std::string_view::npos;
    });
}

/// Returns true for a content with zero bytes that has more control characters than line ends.
bool isNoText(std::string_view content)
{
    constexpr std::string_view kOfText = "\t\r\n\x1A";  // the last ended a text file of DOS
    const auto isStray = [&](char c) {
        return isControl(c) && kOfText.find(c) == std::string_view::npos;
    };
    const auto isLineEnd = [](char c) { return c == '\r' || c == '\n'; };
    return content.find('\0') != std::string_view::npos
        && std::ranges::count_if(content, isStray) > std::ranges::count_if(content, isLineEnd);
}

/// Converts line ends of old programs (CR alone) to LF.
std::string withLineFeeds(std::string_view text)
{
    std::string lines(text);
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    return lines;
}

}  // namespace

Result<DbcFile> dbcFrom(const std::string& path, std::string_view content)
{
    if (contentKind(content.substr(0, kContentHead)) == ContentKind::Utf16)
        return fileError(path, TR_NOOP("core", "is text in UTF-16: save it as UTF-8"));
    if (isNoText(content))
        return fileError(path, TR_NOOP("core", "is no text in UTF-8 or Windows code page 1252: "
                                               "expected a DBC file; save it again as one"));
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (content.starts_with(kMark)) content.remove_prefix(kMark.size());
    if (content.find('\n') == std::string_view::npos
        && content.find('\r') != std::string_view::npos)
        return dbcFrom(path, withLineFeeds(content));
    const bool isUnicode = isUtf8(content);
    std::string text = isUnicode ? std::string(content) : fromWindows1252(content);
    std::ranges::replace(text, '\0', ' ');
    DbcParser parser(path, text);
    parser.warnOfZeros(content);
    if (!isUnicode && dependsOnCodePage(content))
        parser.warn(TR_NOOP("core", "is not UTF-8: read as Windows code page 1252; if characters "
                                    "look wrong, save it as UTF-8"));
    return parser.parse();
}

}  // namespace terratact
