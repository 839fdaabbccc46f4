#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace terratact {

/// application_id of a session file: "TTS1", see resources/desktop.
inline constexpr std::int64_t kSessionApplicationId = 0x54545331;

/// What a file is by its first bytes, whatever its name says.
enum class ContentKind : std::uint8_t {
    Plain,        ///< none of the others
    Utf16,        ///< text of two bytes per character, with or without a byte order mark
    Utf32,        ///< text of four bytes per character, with a byte order mark
    Zip,          ///< an archive: workbooks (.xlsx, .ods) are some
    OldWorkbook,  ///< an OLE file: workbooks of Excel up to 2003 (.xls) are some
    Gzip,
    Pdf,
    Sqlite,   ///< an SQLite file of another kind than those below
    Session,  ///< a recorded session (docs/sessions.md)
    Journal,  ///< the write-ahead journal of an SQLite file
};

/// `head`: the beginning of the file, at least kContentHead bytes where it has so many.
ContentKind contentKind(std::string_view head);
inline constexpr std::size_t kContentHead = 72;  ///< bytes

/// Of a regular file that can be read; of anything else Plain.
ContentKind contentKindOfFile(const std::string& path);

}  // namespace terratact
