#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace terratact {

// What a DBC file says in words: of any program, in one of two encodings.

inline constexpr std::size_t kDbcName = 128, kDbcText = 2000;  ///< [bytes] at most
inline constexpr std::size_t kDbcShown = 80;  ///< [bytes] of a text in a line for people

bool isUtf8(std::string_view text);
/// Windows code page 1252 in UTF-8: it has ISO 8859-1, and letters where that has control characters.
std::string fromWindows1252(std::string_view text);

/// What a text of the file says, at most so many bytes and "…", without control characters: those of a
/// terminal have no business here.  Lines are kept only where they may be.
std::string readable(std::string_view utf8, std::size_t most, bool keepsLines);

/// As much of it as a line for people has room for.
inline std::string shownDbcText(std::string_view utf8)
{
    return readable(utf8, kDbcShown, false);
}

}  // namespace terratact
