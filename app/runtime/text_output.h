#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/store/file_write.h"

namespace terratact {

/// Whether a path to write means the standard output: "-", or its name under /dev or /proc.
bool isStandardOutput(std::string_view path);

/// Whether a pipe or a character device (/dev/null, a process substitution) is at `path`: what is written there
/// cannot be renamed into place.
bool isStream(const std::string& path);

/// Where a command says what it did: stdout, or stderr where `out` is the standard output and belongs to the data.
std::FILE* messagesBeside(const std::string& out);

/// Output that is written from its beginning to its end.  To a file as NewFile does it: whole or not at all.  To the
/// standard output, a pipe or a character device at once: what came before an error is there.
class TextOutput {
public:
    /// Errors name the file, as those of NewFile::begin().
    static Result<TextOutput> begin(const std::string& path);

    std::ostream& stream() { return *stream_; }

    /// Flushes and, of a file, renames.  Errors name the file: not all of it could be written.
    Status commit();

private:
    TextOutput(std::string path, std::optional<NewFile> file, std::unique_ptr<std::ostream> stream);

    std::string path_;
    std::optional<NewFile> file_;  ///< empty: a stream
    std::unique_ptr<std::ostream> stream_;
};

/// Puts `content` at `path` as TextOutput does.
Status writeText(const std::string& path, std::string_view content);

}  // namespace terratact
