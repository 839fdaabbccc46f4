#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/wire/dbc.h"

namespace terratact {

inline constexpr std::size_t kMostDbcBytes = 8U << 20U;

/// What a DBC file describes.
struct DbcFile {
    std::string path;
    std::vector<DbcMessage> messages;  ///< in the file's order; no two with one identifier
    std::vector<std::string> warnings;  ///< "FILE: line 12: …": of what was left out, the first few
};

/// Reads messages with signals of either byte order, IEEE floats, one multiplexor, units, words (VAL_), comments and
/// numeric attributes of messages.  Other sections are passed over.  Text is UTF-8, or else taken as ISO 8859-1.
///
/// Left out with a warning: signals below nested multiplexors, messages no frame is long enough for, what is
/// there twice.  The Error of a file that cannot be understood, or has a signal that does not fit its message,
/// names file, line, what was expected and what to do.
Result<DbcFile> readDbc(const std::string& path);

/// The same from its content; path: for what is said of it.
Result<DbcFile> dbcFrom(const std::string& path, std::string_view content);

}  // namespace terratact
