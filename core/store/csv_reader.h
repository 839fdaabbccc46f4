#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace terratact {

/// Reads a CSV file record by record, as spreadsheets, R, NumPy and other programs of several countries write it.
///   fields   separated by commas, semicolons or tabs; the first line decides which, or a line "sep=;" above it.
///            In quotes as RFC 4180 has it, with separators, doubled quotes and line ends within.  Blanks around a
///            field do not belong to it.
///   lines    end with LF, CR LF or CR; the last one may lack its end.  Blank lines are passed over.
///            Lines that begin with # above the first are remarks, but for one that names the columns; so are those
///            below a header that have another number of fields.  A control-Z of DOS ends the file.
///   numbers  with a decimal point.  Where no comma separates fields, a decimal comma is read too, but not both in one
///            file.
///   bytes    UTF-8, with a byte order mark or without.
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
    static constexpr std::size_t kMaxFields = 100'000;      ///< of a record
    static constexpr std::size_t kMaxFieldLength = 65'536;  ///< bytes

    /// The bytes of a file or pipe.  Errors: it cannot be read, or is larger than 64 MiB.
    static Result<std::string> textOf(const std::string& path);

    /// textOf() and over().
    static Result<CsvReader> open(const std::string& path);

    /// The same for a text at hand, which errors call `name`.  Errors: it is empty; it is no text in UTF-8 but
    /// UTF-16, a workbook or another known kind of file; its fields are separated in another way, or in two.
    static Result<CsvReader> over(std::string name, std::string text);

    /// Goes to the next record; false after the last.  Errors: a quote that does not end, text behind one, too many
    /// fields, too long a field; behind a header also another number of fields than it has, and a wrong unit.
    Result<bool> next();

    /// Makes the present record the header, without empty fields at its end: all further ones have as many fields, more only where the rest is empty;
    /// records of empty fields alone are passed over.  `units`: of each column, empty where it holds text.  A line
    /// below the header that gives units instead of numbers is passed over if they are these.
    void takeHeader(std::vector<std::string> units);

    /// Fields of the present record, valid until next().
    const std::vector<std::string_view>& fields() const { return fields_; }

    /// Number of the line on which the present record begins, the first being 1.
    int line() const { return line_; }

    /// Whether the file ends within the present record's line: it was read, though it may be torn.
    bool lacksLineEnd() const { return lacksLineEnd_; }

    /// Whether the field says that nothing was measured: it is empty, or NaN, NA, N/A, null or none.
    bool isMissing(std::size_t field) const;

    /// Whether the field spells a number, finite or not.
    bool isNumber(std::size_t field) const;

    /// The field as a finite number.  `what` names it in the error.  Errors: it is missing, no number or not finite,
    /// or has a decimal comma where a line before has a decimal point, or the other way round.
    Result<double> number(std::size_t field, std::string_view what);

    /// "file: line 7: cause".
    Error error(std::string_view cause) const;

    const std::string& name() const { return name_; }  ///< the file's path

private:
    CsvReader(std::string name, std::string text);

    Status begin();
    Result<bool> takeSeparatorLine();
    void takeRemarks();
    Status chooseSeparator();
    Result<bool> readRecord();
    Result<bool> takeField();
    Result<std::string_view> takeQuoted();
    std::string_view takePlain();
    void takeLineEnd();
    bool isBlank() const;
    bool isRemark() const;
    Result<bool> isUnits() const;
    Status checkCount();

    std::string name_;
    std::unique_ptr<const std::string> text_;  ///< on the heap: fields_ stay valid when this moves
    std::string_view rest_;
    char separator_ = ',';
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  ///< fields whose quotes were doubled
    int line_ = 0, nextLine_ = 1;
    bool lacksLineEnd_ = false;
    std::size_t columns_ = 0;  ///< of the header; 0: none was taken
    std::vector<std::string> columnNames_, units_;
    bool unitsMayFollow_ = false;
    char decimalMark_ = 0;  ///< of the first number that has one
    int decimalLine_ = 0;
};

}  // namespace terratact
