#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace terratact {

/// "BO_", "BA_DEF_DEF_", and whatever else may begin a section.
bool isDbcKeyword(std::string_view word);

/// Takes a DBC file apart into words, numbers and texts.  The first thing that is not as expected is kept as
/// failure(), and nothing more is found from there on until recover().  Blanks, line ends and comments (//) before what
/// is looked for are passed over.
class DbcScanner {
public:
    /// text: in UTF-8; outlives the scanner.
    explicit DbcScanner(std::string_view text) : text_(text) {}

    const std::string& failure() const
    {
        return failure_;
    }  ///< "line 3: expected …, found …"; empty: none

    /// Where a section begins.
    struct Place {
        std::size_t at = 0;
        int line = 1;
    };
    Place place();
    /// Forgets the failure in the section that begins there, and goes on with the next line below its first that
    /// begins as a section does.
    void recover(const Place& place);

    int line();  ///< of what is next
    bool atEnd();
    bool isNext(char c);
    bool isNameNext();
    bool isLineEndNext();  ///< nothing more stands in this line
    bool take(char c);     ///< false where another is next

    // What has to be there; `what` and `place` tell the failure of it.
    void expect(char c, std::string_view place);
    std::string_view word(std::string_view what);
    double number(std::string_view what);
    std::uint64_t whole(std::string_view what, std::uint64_t most);
    std::string_view text(std::string_view what);  ///< between quotation marks, as it is

    std::string_view wordIfAny();   ///< empty where there is none; nothing is wrong then
    std::string_view restOfLine();  ///< what is left of it
    std::string_view
    upTo(char c);  ///< what stands before it in this line; empty where it is not there
    /// Passes over this line and the indented or empty ones below it, up to one that describes a message or signal.
    void skipIndented();
    /// Passes over a section up to its semicolon; one without ends where a line begins with the next.
    void skipSection();

    void fail(std::string_view expected);  ///< with what was expected here
    void refuse(std::string failure);      ///< with a sentence of its own

private:
    void advance();
    void skipBlanks();
    bool isSectionNext();
    bool isMessageLineNext() const;  ///< a line of BO_ or SG_, indented or not

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::string failure_;
};

}  // namespace terratact
