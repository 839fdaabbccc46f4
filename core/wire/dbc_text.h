#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace terratact {

// What a DBC file says in words: of any program, in one of two encodings.

inline constexpr std::size_t kDbcName = 128, kDbcText = 80, kDbcComment = 2000;  ///< [bytes]

bool isUtf8(std::string_view text);
std::string fromLatin1(std::string_view text);  ///< ISO 8859-1 in UTF-8

/// What a text of the file says, at most so many bytes and "…", without control characters: those of a
/// terminal have no business here.  Lines are kept only where they may be.
std::string readable(std::string_view utf8, std::size_t most, bool keepsLines);

}  // namespace terratact
