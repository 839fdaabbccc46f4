#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace terratact {

/// application_id of a session file: "TTS1", see resources/desktop.
inline constexpr std::int64_t kSessionApplicationId = 0x54545331;

/// Kind of a file by its first bytes, whatever its name.
enum class ContentKind : std::uint8_t {
    Plain,        ///< none of the other kinds
    Utf16,        ///< text of two bytes per character, with or without a byte order mark
    Utf32,        ///< text of four bytes per character, with a byte order mark
    Zip,          ///< an archive, such as the workbooks .xlsx and .ods
    OldWorkbook,  ///< an OLE file, such as Excel workbooks up to 2003 (.xls)
    Gzip,
    Pdf,
    Sqlite,   ///< an SQLite file other than those below
    Session,  ///< a recorded session (docs/sessions.md)
    Journal,  ///< the write-ahead journal of an SQLite file
};

/// Returns the kind. `head`: the beginning of the file, at least kContentHead bytes if it has them.
ContentKind contentKind(std::string_view head);
inline constexpr std::size_t kContentHead = 72;  ///< bytes

/// Returns the kind of a regular file that can be read; Plain for anything else.
ContentKind contentKindOfFile(const std::string& path);

}  // namespace terratact
