#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace terratact {

// Texts of a DBC file, written by any program in one of two encodings.

inline constexpr std::size_t kDbcName = 128, kDbcText = 2000;  ///< [bytes] longest name and text
inline constexpr std::size_t kDbcUnit = 64, kDbcWord = 255;    ///< [bytes] of a signal's values
inline constexpr std::size_t kDbcShown = 80;  ///< [bytes] longest text in a line for people

/// Converts Windows code page 1252 to UTF-8. It is ISO 8859-1 with letters in place of its control
/// characters.
std::string fromWindows1252(std::string_view text);

/// Returns a text of the file, cut after `most` bytes with "…". Control characters are removed,
/// because they could steer a terminal. Line ends stay only if keepsLines.
std::string readable(std::string_view utf8, std::size_t most, bool keepsLines);

/// Returns a text cut to the length of a line for people.
inline std::string shownDbcText(std::string_view utf8)
{
    return readable(utf8, kDbcShown, false);
}

}  // namespace terratact
