#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/store/file_group.h"
#include "core/store/file_write.h"

namespace terratact {

/// Returns true if an output path means standard output: "-", or its name under /dev or /proc.
bool isStandardOutput(std::string_view path);

/// Returns true for a pipe or character device (/dev/null, a process substitution), which cannot be replaced by a
/// rename.
bool isStream(const std::string& path);

/// Returns the stream for messages: stdout, or stderr if `out` is standard output and carries data.
std::FILE* messagesBeside(const std::string& out);

/// Sequential output. A file is written completely or not at all, like NewFile. Standard output, a pipe or a character
/// device is written at once, so output before an error remains. On a terminal it is printableLines(): texts of files
/// move no cursor. There an unfinished line appears at the end.
class TextOutput {
public:
    /// Opens the output. Errors name the file, like those of NewFile::begin().
    static Result<TextOutput> begin(const std::string& path);

    std::ostream& stream() { return *stream_; }

    /// Flushes and, for a file, renames. Errors name the file that could not be written completely.
    Status commit();

    /// Ends the output. Flushes a file to the disk and adds it to the group, which renames it. Errors as commit().
    Status addTo(FileGroup& files);

private:
    /// Writes what the stream holds and closes it.
    Status end();
    TextOutput(std::string path, std::optional<NewFile> file, std::unique_ptr<std::ostream> stream);

    std::string path_;
    std::optional<NewFile> file_;  ///< empty: a stream
    std::unique_ptr<std::ostream> stream_;
};

/// Writes `content` to `path` through TextOutput.
Status writeText(const std::string& path, std::string_view content);

/// Adds a file to a group. A stream takes the content at once.
Status addText(FileGroup& files, const std::string& path, std::string_view content);

/// Writes the files of a group and one more, all of them or none. Standard output and other streams take the content
/// after the files are written.
Status writeTogether(FileGroup& files, const std::string& path, std::string_view content);

}  // namespace terratact
