#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace terratact {

/// Reads a CSV file line by line: fields separated by commas, no quotes, LF or CRLF, a UTF-8 byte order
/// mark allowed.  Errors name file, line and cause.  Holds no more than the text and one line's fields.
///
///     for (;;) {
///         const Result<bool> more = csv->next();
///         if (!more) return more.error();
///         if (!*more) break;
///         … csv->fields() …
///     }
class CsvReader {
public:
    static constexpr std::size_t kMostFields = 100'000;  ///< of a line
    static constexpr std::size_t kLongestField = 4096;   ///< bytes

    /// Errors: cannot be read, larger than 64 MiB, empty, or its last line is torn (no line end).
    static Result<CsvReader> open(const std::string& path);

    /// The same for a text at hand, which errors call `name`.
    static Result<CsvReader> over(std::string name, std::string text);

    /// Goes to the next line; false after the last.  Errors: a blank line, a quoted field, too many fields, too
    /// long a field.
    Result<bool> next();

    /// Fields of the present line, valid until next().
    const std::vector<std::string_view>& fields() const { return fields_; }

    /// Number of the present line, the first being 1.
    int line() const { return line_; }

    /// The field as a finite number; blanks around it are allowed.  `what` names it in the error.
    Result<double> number(std::size_t field, std::string_view what) const;

    /// "file: line 7: cause".
    Error error(std::string_view cause) const;

    const std::string& name() const { return name_; }  ///< the file's path

private:
    CsvReader(std::string name, std::string text);

    std::string name_;
    std::unique_ptr<const std::string> text_;  ///< on the heap: fields_ stay valid when this moves
    std::string_view rest_;
    std::vector<std::string_view> fields_;
    int line_ = 0;
};

}  // namespace terratact
