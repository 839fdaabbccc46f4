#include "core/wire/dbc_file.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/file_read.h"
#include "core/text.h"
#include "core/wire/dbc_messages.h"
#include "core/wire/dbc_scanner.h"
#include "core/wire/dbc_text.h"

namespace terratact {
namespace {

/// The sections of a file, and what they say of messages that stand before them.
class DbcParser {
public:
    DbcParser(const std::string& path, std::string_view utf8) : scan_(utf8) { file_.path = path; }

    Result<DbcFile> parse()
    {
        while (!scan_.atEnd()) {
            const int line = scan_.line();
            const std::string_view keyword = scan_.word("the keyword of a section (BO_, CM_ …)");
            if (keyword != "SG_") messages_.endMessage();
            section(keyword, line);
        }
        messages_.endMessage();
        if (!scan_.failure().empty()) return fileError(file_.path, scan_.failure());
        if (file_.messages.empty())
            return fileError(file_.path,
                             "describes no message: expected lines that begin with BO_; is it a "
                             "DBC file?");
        takeDefaults();
        warnings_.end();
        return std::move(file_);
    }

private:
    void section(std::string_view keyword, int line)
    {
        if (keyword == "BO_") return messages_.message(line);
        if (keyword == "SG_") return messages_.signal(line);
        if (keyword == "NS_" || keyword == "BS_" || keyword == "BU_") return scan_.skipIndented();
        if (keyword == "VERSION") return static_cast<void>(scan_.text("the version"));
        if (keyword == "CM_") comment();
        if (keyword == "VAL_") words(line);
        if (keyword == "SIG_VALTYPE_") valueType(line);
        if (keyword == "SG_MUL_VAL_") selections();
        if (keyword == "BA_") attribute();
        if (keyword == "BA_DEF_DEF_") attributeDefault();
        if (!keyword.empty() && !isDbcKeyword(keyword))
            scan_.refuse(fmt::format("line {}: expected the keyword of a section, such as BO_ or "
                                     "CM_, found {}; mend the line, or have the file exported anew",
                                     line, shown(keyword)));
        scan_.skipSection();
    }

    // "CM_ SG_ 256 Speed "Over ground.";"
    void comment()
    {
        std::string other;
        const std::string_view of = scan_.wordIfAny();
        std::string* comment = &other;
        if (of == "BO_") {
            if (DbcMessage* m = messages_.messageNext()) comment = &m->comment;
        } else if (of == "SG_") {
            if (DbcSignal* s = messages_.signalNext()) comment = &s->comment;
        } else if (!of.empty()) {
            (void)scan_.word("what the comment is about");
        }
        *comment = readable(scan_.text("a comment"), kDbcComment, true);
    }

    // "VAL_ 256 Gear 0 "neutral" 1 "first" ;", but not of an environment variable
    void words(int line)
    {
        if (scan_.isNameNext()) return;
        DbcSignal* s = messages_.signalNext();
        if (scan_.isNameNext())
            return warnings_.add(line, "the name of a table of words (VAL_TABLE_) is passed over");
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
        DbcSignal* s = messages_.signalNext();
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
        DbcSignal* s = messages_.signalNext();
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
        DbcMessage* m = messages_.messageNext();
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
    DbcWarnings warnings_{file_};
    DbcMessages messages_{scan_, file_, warnings_};
    double cycleTime_ = 0.0;  // [ms]
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
