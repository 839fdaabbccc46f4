#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

/// Returns true for a word that may begin a section, such as "BO_" or "BA_DEF_DEF_".
bool isDbcKeyword(std::string_view word);

/// Scanner that splits a DBC file into words, numbers and texts. It keeps the first unexpected
/// token as failure(), and returns no more tokens until recover(). It skips blanks, line ends and
/// comments (//) before each token.
class DbcScanner {
public:
    /// text: UTF-8; must outlive the scanner.
    explicit DbcScanner(std::string_view text) : text_(text) {}

    /// Returns "line 3: expected …, found …"; empty: no failure.
    const Message& failure() const { return failure_; }

    /// Start of a section.
    struct Place {
        std::size_t at = 0;
        int line = 1;
    };
    Place place();
    /// Forgets the failure in the section that begins there. Scanning continues at the next line
    /// that begins like a section.
    void recover(const Place& place);

    int line();  ///< line of the next token
    bool atEnd();
    bool isNext(char c);
    bool isNameNext();
    bool isLineEndNext();  ///< true if the line holds nothing more
    bool consume(char c);  ///< false if another character is next

    // Required tokens; `what` and `place` describe the failure if one is missing.
    void expect(char c, SourceText place);  ///< place: with %1 for the character
    std::string_view word(SourceText what);
    double number(SourceText what);
    /// Returns a number rounded to a whole one. Empty without a failure: it has more than 64 bits,
    /// or is beyond 2⁵³ and written with a point or an exponent.
    std::optional<DbcRaw> raw(SourceText what);
    std::uint64_t whole(SourceText what, std::uint64_t most);
    std::string_view text(SourceText what);  ///< text between quotation marks, unchanged
    /// Returns a text behind which the section's semicolon is expected. A text without it that has
    /// a line like the begin of a section lacks its closing quotation mark: a failure.
    std::string_view lastText(SourceText what);

    std::string_view wordIfAny();   ///< empty without a failure if there is no word
    std::string_view restOfLine();  ///< remaining text of the line
    std::string_view upTo(char c);  ///< text before c in this line; empty if c is not there
    /// Skips this line and the indented or empty lines below it, up to one that describes a message
    /// or signal.
    void skipIndented();
    /// Skips a section up to its semicolon. A section without one ends where a line begins the next
    /// section.
    void skipSection();

    /// Sets the failure to `expected` and the text found here.
    void fail(const Message& expected);
    void refuse(Message failure);  ///< sets the failure to this sentence

private:
    std::string_view numberToken();  ///< without a plus sign
    void failUnclosed(const Place& begin, SourceText what);
    void advance();
    void advanceEscaped();  ///< past a character, and past a backslash with the next one
    void skipBlanks();
    bool isSectionNext();
    bool isMessageLineNext() const;  ///< true for a line of BO_ or SG_, indented or not

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    Message failure_;
};

}  // namespace terratact
