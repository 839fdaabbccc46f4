#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/wire/dbc/dbc.h"

namespace terratact {

inline constexpr std::size_t kMaxDbcBytes = 8U << 20U;

/// Contents of a DBC file.
struct DbcFile {
    std::string path;
    std::vector<DbcMessage> messages;  ///< in the file's order; every identifier is unique
    /// "FILE: line 12: …": what was skipped, the first few. The last names the lines of the others.
    std::vector<Message> warnings;
};

/// Reads a DBC file. It reads messages, signals of either byte order, IEEE floats, nested
/// multiplexors, units, value texts (VAL_) and comments. It also reads long names
/// (SystemSignalLongSymbol, SystemMessageLongSymbol), J1939 parameter groups (VFrameFormat) and
/// numeric attributes of messages. Other sections and comments (//) are skipped. Text is UTF-8, or
/// else Windows code page 1252.
///
/// A blank value text is none. A value text is left out with a warning if its raw value has more
/// than 64 bits. So is one beyond 2⁵³ without all its digits. Zero bytes are read as blanks; a
/// warning names their lines. A content with zero bytes is refused as no text if it has more
/// control characters than line ends.
///
/// A line or signal that is not understood, impossible or a duplicate is skipped; a warning names
/// its line. So is a signal beyond the first DbcMessage::kMaxSignals of a message, and a comment
/// without its closing quotation mark. Units, value texts and long names are cut (kDbcUnit,
/// kDbcWord, kDbcName), with a warning that names the line. A long name that another signal
/// of the message has is left out in the same way. A warning also names a message of which one
/// frame can have more signals than are decoded (mostSignals()). If the file describes no message,
/// the Error names the first thing that was skipped.
Result<DbcFile> readDbc(const std::string& path);

/// Reads the same from a text; errors and warnings call it `path`.
Result<DbcFile> dbcFrom(const std::string& path, std::string_view content);

}  // namespace terratact
