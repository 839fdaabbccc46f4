#include "core/store/csv_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/store/content_kind.h"
#include "core/store/csv_field.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kLineEnds = "\r\n";
constexpr char kEndOfDosText = '\x1A';  // DOS ended a text file with this character

/// Returns why a kind of file cannot be read as CSV, and what to do; empty if nothing prevents it.
Message refusalOf(ContentKind kind)
{
    switch (kind) {
    case ContentKind::Plain: return {};
    case ContentKind::Utf16: return TR_NOOP("core", "is text in UTF-16: save it as CSV in UTF-8");
    case ContentKind::Utf32: return TR_NOOP("core", "is text in UTF-32: save it as CSV in UTF-8");
    case ContentKind::Zip:
        return TR_NOOP("core",
                       "is a workbook or an archive, not text: save the sheet as CSV in UTF-8");
    case ContentKind::OldWorkbook:
        return TR_NOOP(
            "core", "is a workbook of an office program, not text: save the sheet as CSV in UTF-8");
    case ContentKind::Gzip:
        return TR_NOOP("core", "is compressed by gzip, not text: unpack it first");
    case ContentKind::Pdf: return TR_NOOP("core", "is a PDF, not text: export the numbers as CSV");
    case ContentKind::Session:
        return TR_NOOP(
            "core",
            "is a recorded session, not text: terratact session scenes writes its scenes as CSV");
    case ContentKind::Sqlite:
    case ContentKind::Journal: break;
    }
    return TR_NOOP("core", "is an SQLite file, not text");
}

std::string_view lineOf(std::string_view text)
{
    return text.substr(0, text.find_first_of(kLineEnds));
}

/// Returns true for a comment with as many fields as the numbers below it: NumPy writes its header
/// that way. below: the text behind the comment.
bool namesColumns(std::string_view remark, std::string_view below)
{
    if (!remark.starts_with('#')) return false;
    below.remove_prefix(std::min(below.find_first_not_of(kLineEnds), below.size()));
    below = lineOf(below);
    const auto separators = [](std::string_view text) {
        const SeparatorCounts counts = countSeparators(text);
        return std::max({counts.commas, counts.semicolons, counts.tabs});
    };
    const std::string_view first = below.substr(0, below.find_first_of(",;\t"));
    return separators(remark) > 0 && separators(remark) == separators(below)
        && csvNumber(withoutBlanks(first), true);
}

}  // namespace

CsvReader::CsvReader(std::string name, std::string text)
    : name_(std::move(name)), text_(std::make_unique<const std::string>(std::move(text))),
      rest_(*text_)
{
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
    while (rest_.ends_with(kEndOfDosText)) rest_.remove_suffix(1);
}

Result<std::string> CsvReader::textOf(const std::string& path, std::size_t most)
{
    return readFile(path, most);
}

Result<CsvReader> CsvReader::open(const std::string& path)
{
    Result<std::string> text = textOf(path);
    if (!text) return text.error();
    return over(path, *std::move(text));
}

Result<CsvReader> CsvReader::over(std::string name, std::string text)
{
    CsvReader reader(std::move(name), std::move(text));
    if (const Status begun = reader.begin(); !begun) return begun.error();
    return reader;
}

Status CsvReader::begin()
{
    if (const Message why = refusalOf(contentKind(*text_)); !why.empty())
        return fileError(name_, why);
    if (rest_.find('\0') != std::string_view::npos)
        return fileError(
            name_,
            TR_NOOP(
                "core",
                "holds bytes of value 0, which no text in UTF-8 does: save it as CSV in UTF-8"));
    const Result<bool> isNamed = readSeparatorLine();
    if (!isNamed) return isNamed.error();
    skipRemarks();
    if (rest_.empty())
        return fileError(
            name_, TR_NOOP("core", "is empty: expected a line with the names of its columns"));
    return *isNamed ? Status(Done{}) : chooseSeparator();
}

// Reads the line "sep=;" that spreadsheets write above the header.
Result<bool> CsvReader::readSeparatorLine()
{
    const std::string_view whole = lineOf(rest_);
    const bool quoted = whole.size() > 1 && whole.starts_with('"') && whole.ends_with('"');
    const std::string_view line = quoted ? whole.substr(1, whole.size() - 2) : whole;
    if (line.size() != 5 || lowerCase(line.substr(0, 4)) != "sep=") return false;
    separator_ = line[4];
    rest_.remove_prefix(whole.size());
    skipLineEnd();
    if (separator_ == ',' || separator_ == ';' || separator_ == '\t') return true;
    return fileError(
        name_, TR_NOOP("core", "line 1: names a separator that is no comma, semicolon or tab"));
}

// Skips comments and blank lines.
void CsvReader::skipRemarks()
{
    while (!rest_.empty()) {
        const std::string_view line = lineOf(rest_);
        if (!line.starts_with('#') && !withoutBlanks(line).empty()) return;
        if (namesColumns(line, rest_.substr(line.size()))) {
            rest_.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
            return;
        }
        rest_.remove_prefix(line.size());
        skipLineEnd();
    }
}

Status CsvReader::chooseSeparator()
{
    const std::string_view line = lineOf(rest_);
    const SeparatorCounts n = countSeparators(line);
    const auto refuse = [this](SourceText how) {
        return fileError(
            name_, Message(TR_NOOP("core", "line %1: %2: save them separated by commas, numbers "
                                           "with a point"),
                           nextLine_, how));
    };
    const std::size_t most = std::max({n.commas, n.semicolons, n.tabs});
    if (most == 0) {
        if (line.find('|') != std::string_view::npos)
            return refuse(TR_NOOP("core", "the fields are separated by |"));
        if (line.find('"') == std::string_view::npos
            && withoutBlanks(line).find_first_of(kCsvBlanks) != std::string_view::npos)
            return refuse(TR_NOOP("core", "the fields are separated by blanks"));
        return Done{};
    }
    const bool isPlain = line.find('"') == std::string_view::npos;
    for (const auto& [separator, count] :
         // decimal commas may occur as well
         {std::pair(';', n.semicolons), std::pair('\t', n.tabs)})
        if (count > 0 && n.commas > 0 && isPlain && allNumbers(line, separator)) {
            separator_ = separator;
            return Done{};
        }
    if ((n.commas == most) + (n.semicolons == most) + (n.tabs == most) > 1)
        return refuse(TR_NOOP("core", "the fields are separated in more than one way"));
    separator_ = n.commas == most ? ',' : n.semicolons == most ? ';' : '\t';
    return Done{};
}

void CsvReader::skipLineEnd()
{
    if (rest_.empty()) return;
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
    ++nextLine_;
}

std::string_view CsvReader::readPlain()
{
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != separator_
           && kLineEnds.find(rest_[end]) == std::string_view::npos)
        ++end;
    const std::string_view field = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return withoutBlanks(field);
}

// Reads a quoted field. The opening quote is the first character.
Result<std::string_view> CsvReader::readQuoted()
{
    rest_.remove_prefix(1);
    const std::string_view begin = rest_;
    bool isDoubled = false;
    for (std::size_t end = 0;; ++end) {
        end = begin.find('"', end);
        if (end == std::string_view::npos)
            return error(TR_NOOP("core", "a quote does not end: close it, or delete the line"));
        if (begin.substr(end).starts_with("\"\"")) {
            isDoubled = true;
            ++end;
            continue;
        }
        const std::string_view inside = begin.substr(0, end);
        rest_ = begin.substr(end + 1);
        for (std::size_t i = 0; i < inside.size(); ++i)
            nextLine_ +=
                inside[i] == '\n' || (inside[i] == '\r' && !inside.substr(i).starts_with("\r\n"));
        if (!isDoubled) return inside;
        std::string text;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            text += inside[i];
            if (inside[i] == '"') ++i;
        }
        return std::string_view(unquoted_.emplace_back(std::move(text)));
    }
}

// Reads a field. Returns false after the last field of its record.
Result<bool> CsvReader::readField()
{
    if (fields_.size() == kMaxFields)
        return error(Message(TR_NOOP("core", "has more than %1 fields"), kMaxFields));
    const auto skipBlanks = [this] {
        while (!rest_.empty() && rest_.front() != separator_
               && kCsvBlanks.find(rest_.front()) != std::string_view::npos)
            rest_.remove_prefix(1);
    };
    skipBlanks();
    if (rest_.starts_with('"')) {
        const Result<std::string_view> field = readQuoted();
        if (!field) return field.error();
        fields_.push_back(*field);
        skipBlanks();
    } else {
        fields_.push_back(readPlain());
    }
    if (fields_.back().size() > kMaxFieldLength)
        return error(
            Message(TR_NOOP("core", "has a field of more than %1 bytes"), kMaxFieldLength));
    if (rest_.starts_with(separator_)) {
        rest_.remove_prefix(1);
        return true;
    }
    if (rest_.empty() || kLineEnds.find(rest_.front()) != std::string_view::npos) return false;
    return error(TR_NOOP("core", "has text behind a closing quote"));
}

// Reads a record. Returns false at the end of the file.
Result<bool> CsvReader::readRecord()
{
    fields_.clear();
    unquoted_.clear();
    isOfWords_.reset();
    if (rest_.empty()) return false;
    line_ = nextLine_;
    for (;;) {
        const Result<bool> more = readField();
        if (!more) return more.error();
        if (*more) continue;
        lacksLineEnd_ = rest_.empty();
        skipLineEnd();
        return true;
    }
}

bool CsvReader::isBlank() const
{
    const auto isEmpty = [](std::string_view field) { return field.empty(); };
    return (fields_.size() == 1 || columns_ != 0) && std::ranges::all_of(fields_, isEmpty);
}

/// Returns true for a line below a header that begins with # and has another number of fields. With
/// the right number of fields, it may be a text that begins with #.
bool CsvReader::isRemark() const
{
    return columns_ > 1 && fields_.front().starts_with('#') && fields_.size() != columns_;
}

/// Returns true for a record of several words without a number, as the header of another table is.
bool CsvReader::isOfWords()
{
    constexpr std::string_view kNumberBegins = "+-.0123456789";
    if (!isOfWords_) {
        std::size_t words = 0, i = 0;
        for (; i < fields_.size(); ++i) {
            if (fields_[i].empty()) continue;
            if (kNumberBegins.find(fields_[i].front()) != std::string_view::npos) break;
            if (isMissing(i) || isNumber(i)) break;
            ++words;
        }
        isOfWords_ = i == fields_.size() && words > 1;
    }
    return *isOfWords_;
}

Result<bool> CsvReader::next()
{
    for (;;) {
        Result<bool> more = readRecord();
        if (!more || !*more) return more;
        if (isBlank() || isRemark()) continue;
        if (columns_ == 0) return true;
        if (const Status counted = checkCount(); !counted) return counted.error();
        if (std::ranges::equal(fields_, columnNames_)) return error(kSecondTable);
        if (!std::exchange(unitsMayFollow_, false)) return true;
        const Result<bool> units = isUnits();
        if (!units || !*units) return units ? Result<bool>(true) : units;
    }
}

std::vector<Message> CsvReader::adoptNames(const std::vector<std::string_view>& names)
{
    std::vector<Message> sentences;
    for (std::string_view& field : fields_) {
        const std::string meant = lowerCase(withoutPadding(field));
        const auto name = std::ranges::find_if(
            names, [&](std::string_view known) { return lowerCase(known) == meant; });
        if (name == names.end() || *name == field) continue;
        sentences.emplace_back(TR_NOOP("core", "%1: the column %2 was read as %3"), name_,
                               shown(field), *name);
        field = unquoted_.emplace_back(*name);
    }
    return sentences;
}

void CsvReader::useAsHeader(std::vector<std::string> units)
{
    while (fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
    columns_ = fields_.size();
    columnNames_.assign(fields_.begin(), fields_.end());
    units_ = std::move(units);
    units_.resize(columns_);
    unitsMayFollow_ = true;
}

Status CsvReader::checkCount()
{
    while (fields_.size() > columns_ && fields_.back().empty()) fields_.pop_back();
    if (fields_.size() == columns_) return Done{};
    const Message cause(TR_NOOP("core", "has %1 fields where the header has %2"), fields_.size(),
                        columns_);
    if (fields_.size() < columns_ && lacksLineEnd_)
        return error(
            Message(TR_NOOP("core", "is torn: has %1 fields where the header has %2, and "
                                    "the file does not end with a line end: delete the line"),
                    fields_.size(), columns_));
    if (isOfWords())
        return error(Message(TR_NOOP("core", "%1, and no number: does a second table begin here? "
                                             "save it as a file of its own, or correct the line"),
                             cause));
    if (fields_.size() > columns_ && separator_ == ',')
        return error(Message(
            TR_NOOP("core", "%1: are there decimal commas? save numbers with a point"), cause));
    return error(Message(TR_NOOP("core", "%1: correct or delete the line"), cause));
}

// Returns true for a line below the header without any number, where numbers are expected.
Result<bool> CsvReader::isUnits() const
{
    bool any = false;
    for (std::size_t i = 0; i < columns_; ++i) {
        if (units_[i].empty() || fields_[i].empty()) continue;
        if (isMissing(i) || isNumber(i)) return false;
        any = any || (fields_[i] != "-" && fields_[i].find(',') == std::string_view::npos);
    }
    for (std::size_t i = 0; any && i < columns_; ++i) {
        const std::string_view unit = withoutBrackets(fields_[i]);
        if (units_[i].empty() || unit.empty() || unit == "-") continue;
        if (lowerCase(unit) != lowerCase(units_[i]))
            return error(Message(TR_NOOP("core", "%1 is %2, expected a number, or its unit %3"),
                                 columnNames_[i], shown(fields_[i]), units_[i]));
    }
    return any;
}

bool CsvReader::isMissing(std::size_t field) const
{
    return isMissingWord(fields_.at(field));
}

bool CsvReader::isNumber(std::size_t field) const
{
    return csvNumber(fields_.at(field), separator_ != ',').has_value();
}

Result<double> CsvReader::number(std::size_t field, std::string_view what)
{
    const std::string_view text = withoutBlanks(fields_.at(field));
    if (text.empty()) return error(Message(TR_NOOP("core", "%1 is empty"), what));
    const std::optional<double> value = csvNumber(text, separator_ != ',');
    if ((!value || std::isnan(*value)) && isMissingWord(text))
        return error(Message(TR_NOOP("core", "%1 is not measured: %2"), what, shown(text)));
    if (!value) {
        const bool grouped = text.find(',') != std::string_view::npos
                          && text.find_first_not_of("0123456789.,+-") == std::string_view::npos;
        const SourceText refusal =
            grouped ? TR_NOOP("core", "%1 is not a number: %2: save numbers with a point, and "
                                      "nothing between thousands")
            : columns_ != 0 && isOfWords()
                ? TR_NOOP("core", "%1 is not a number: %2, and its line holds none: does a second "
                                  "table begin here? save it as a file of its own, or write a "
                                  "number there")
                : TR_NOOP("core", "%1 is not a number: %2: write a number there");
        return error(Message(refusal, what, shown(text)));
    }
    if (!std::isfinite(*value))
        return error(Message(TR_NOOP("core", "%1 is not finite: %2: write a finite number there"),
                             what, shown(text)));
    if (separator_ == ',') return *value;
    const std::size_t mark = text.find_first_of(",.");
    if (mark == std::string_view::npos) return *value;
    if (decimalMark_ == 0) {
        decimalMark_ = text[mark];
        decimalLine_ = line_;
    }
    if (decimalMark_ == text[mark]) return *value;
    const SourceText refusal =
        decimalMark_ == ','
            ? TR_NOOP("core", "%1 is %2, and line %3 has a decimal comma: save all numbers with a "
                              "decimal point")
            : TR_NOOP("core", "%1 is %2, and line %3 has a decimal point: save all numbers with a "
                              "decimal point");
    return error(Message(refusal, what, shown(text), decimalLine_));
}

Error CsvReader::error(const Message& cause) const
{
    return fileError(name_, Message(TR_NOOP("core", "line %1: %2"), line_, cause));
}

Error CsvReader::error(std::string_view cause) const
{
    return fileError(name_, "line " + std::to_string(line_) + ": " + std::string(cause));
}

}  // namespace terratact
