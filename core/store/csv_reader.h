#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Reads a CSV file record by record. It takes what spreadsheets, R, NumPy and programs of several
/// countries write.
///   fields   Commas, semicolons or tabs separate them. The first line decides which, or a line "sep=;"
///            above it. Quotes follow RFC 4180 and may contain separators, doubled quotes and line ends.
///            Blanks around a field do not belong to it.
///   lines    They end with LF, CR LF or CR; the last one may lack its end. Blank lines are skipped.
///            Lines above the first that begin with # are comments, except one that names the columns.
///            So are such lines below a header that have another number of fields. A DOS Control-Z ends
///            the file.
///   numbers  They have a decimal point. If no comma separates fields, a decimal comma is also read, but
///            not both in one file. If commas separate fields, a decimal comma makes one field too many.
///            The error mentions it.
///   bytes    UTF-8, with or without a byte order mark.
/// Errors name file, line and cause.  Holds no more than the text and one record's fields.
///
///     for (;;) {
///         const Result<bool> more = csv->next();
///         if (!more) return more.error();
///         if (!*more) break;
///         … csv->fields() …
///     }
class CsvReader {
public:
    static constexpr std::size_t kMaxFields = 100'000;      ///< fields of a record
    static constexpr std::size_t kMaxFieldLength = 65'536;  ///< bytes

    static constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;  ///< of most files

    /// Returns the bytes of a file or pipe. Errors: it cannot be read, or has more than `most` bytes.
    static Result<std::string> textOf(const std::string& path, std::size_t most = kMaxBytes);

    /// Calls textOf() and over().
    static Result<CsvReader> open(const std::string& path);

    /// Reads a text; errors call it `name`. Errors: it is empty, UTF-16, a workbook or another
    /// known kind of file. Fields with another separator, or with two kinds of separators, are
    /// errors, too.
    static Result<CsvReader> over(std::string name, std::string text);

    /// Goes to the next record. Returns false after the last. Errors: an unclosed quote, text
    /// behind a quote, too many fields, a field that is too long. Below a header also: a wrong
    /// number of fields, a wrong unit, and the header again: a second table begins there.
    Result<bool> next();

    /// Corrects fields of the current record, the header. A field becomes one of `names` if only upper
    /// or lower case and blanks around it differ. Blanks may be of any kind. Returns a sentence for each
    /// field that it changed.
    std::vector<Message> adoptNames(const std::vector<std::string_view>& names);

    /// Makes the current record the header, without empty fields at its end. All later records have
    /// as many fields, or more if the additional ones are empty. Records of empty fields only are
    /// skipped. `units`: unit of each column, empty for text. A line below the header that gives
    /// these units instead of numbers is skipped.
    void useAsHeader(std::vector<std::string> units);

    /// Returns the fields of the current record, valid until next().
    const std::vector<std::string_view>& fields() const { return fields_; }

    /// Returns the line on which the current record begins; the first line is 1.
    int line() const { return line_; }

    /// Returns true if the file ends within the current record's line. The record was read but may
    /// be truncated.
    bool lacksLineEnd() const { return lacksLineEnd_; }

    /// Returns true if the field means "not measured": it is empty, or NaN, NA, N/A, null or none.
    bool isMissing(std::size_t field) const;

    /// Returns true if the field spells a number, finite or not.
    bool isNumber(std::size_t field) const;

    /// Returns the field as a finite number. `what` names it in the error. Errors: it is missing,
    /// no number, not finite, or has another decimal mark than an earlier line. Where a record below
    /// a header holds words alone, the error asks whether a second table begins there.
    Result<double> number(std::size_t field, std::string_view what);

    /// Returns "file: line 7: cause".
    Error error(const Message& cause) const;
    Error error(std::string_view cause) const;  ///< in English alone

    const std::string& name() const { return name_; }  ///< the file's path

private:
    CsvReader(std::string name, std::string text);

    Status begin();
    Result<bool> readSeparatorLine();
    void skipRemarks();
    Status chooseSeparator();
    Result<bool> readRecord();
    Result<bool> readField();
    Result<std::string_view> readQuoted();
    std::string_view readPlain();
    void skipLineEnd();
    bool isBlank() const;
    bool isRemark() const;
    bool isOfWords();
    Result<bool> isUnits() const;
    Status checkCount();

    std::string name_;
    /// On the heap: fields_ stay valid when this object moves.
    std::unique_ptr<const std::string> text_;
    std::string_view rest_;
    char separator_ = ',';
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  ///< fields that contained doubled quotes
    int line_ = 0, nextLine_ = 1;
    bool lacksLineEnd_ = false;
    std::optional<bool> isOfWords_;  ///< of the current record; empty: not asked yet
    std::size_t columns_ = 0;        ///< columns of the header; 0: there is no header
    std::vector<std::string> columnNames_, units_;
    bool unitsMayFollow_ = false;
    char decimalMark_ = 0;  ///< decimal mark of the first number that has one
    int decimalLine_ = 0;
};

}  // namespace terratact
