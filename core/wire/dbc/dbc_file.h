#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

inline constexpr std::size_t kMaxDbcBytes = 8U << 20U;

/// What a DBC file describes.
struct DbcFile {
    std::string path;
    std::vector<DbcMessage> messages;  ///< in the file's order; no two with one identifier
    std::vector<std::string> warnings;  ///< "FILE: line 12: …": of what was left out, the first few
};

/// Reads messages with signals of either byte order, IEEE floats, multiplexors also below others, units, words (VAL_),
/// comments, long names (SystemSignalLongSymbol, SystemMessageLongSymbol), parameter groups of J1939 (VFrameFormat) and
/// numeric attributes of messages.  Other sections and comments (//) are passed over.  Text is UTF-8, or else taken as
/// Windows code page 1252.
///
/// What cannot be understood, cannot be or is there twice is left out, a line or a signal at a time, with a warning
/// that names its line.  The Error of a file that describes no message names what was found first.
Result<DbcFile> readDbc(const std::string& path);

/// The same from its content; path: for what is said of it.
Result<DbcFile> dbcFrom(const std::string& path, std::string_view content);

}  // namespace terratact
