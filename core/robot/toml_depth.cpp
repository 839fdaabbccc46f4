#include "core/robot/toml_depth.h"

#include <algorithm>

namespace terratact {
namespace {

constexpr std::size_t kEnd = std::string_view::npos;

/// Returns the position after a closing triple quote at `at`. One or two quotes of the content may
/// touch it, and are skipped too.
std::size_t pastTriple(std::string_view text, std::size_t at)
{
    std::size_t past = at + 3;
    while (past < text.size() && past < at + 5 && text[past] == text[at]) ++past;
    return past;
}

/// Returns the position after the string that opens at `at`: "basic", 'literal', or either in
/// triple quotes.
std::size_t pastString(std::string_view text, std::size_t at)
{
    const char quote = text[at];
    const std::string_view triple = quote == '"' ? R"(""")" : "'''";
    const bool lines = text.substr(at, 3) == triple;
    for (std::size_t i = at + (lines ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"')
            ++i;
        else if (lines && text.substr(i, 3) == triple)
            return pastTriple(text, i);
        else if (!lines && (text[i] == quote || text[i] == '\n'))
            return i + 1;
    }
    return kEnd;
}

}  // namespace

int nestingDepth(std::string_view toml)
{
    int deepest = 0, brackets = 0, dots = 0;
    for (std::size_t i = 0; i < toml.size();) {
        switch (toml[i]) {
        case '"':
        case '\'': i = pastString(toml, i); continue;
        case '#': i = toml.find('\n', i); continue;
        case '[':
        case '{':
            ++brackets;
            dots = 0;
            break;
        case ']':
        case '}':
            brackets = std::max(brackets - 1, 0);
            dots = 0;
            break;
        case '.': ++dots; break;
        case '=':
        case ',':
        case '\n': dots = 0; break;
        default: break;
        }
        deepest = std::max(deepest, brackets + dots);
        ++i;
    }
    return deepest;
}

}  // namespace terratact
