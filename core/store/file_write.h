#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Returns Done if a new file may replace the one at `path`, or if there is none. Errors name it:
///   - It is a directory, a device or a pipe.
///   - It is write-protected, by its mode for this user, or for everybody (which includes root).
///   - It is a recorded session or its journal, by content or by name (*.tts): a recording is never
///     replaced.
Status checkReplaceable(const std::string& path);

/// Atomic replacement of a file. The content is written under a temporary name in the same
/// directory. commit() renames it, so that readers see the old file, or none, or the whole new one.
/// Without commit() the temporary file is removed.
class NewFile {
public:
    /// Creates the empty temporary file. Errors name the file: its directory does not exist or is
    /// not writable, or checkReplaceable() refuses the file at `path`. A symbolic link at `path` is
    /// followed. The permissions of an existing file are kept.
    static Result<NewFile> begin(const std::string& path);

    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&& other) noexcept;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    /// Returns the path to write to. Close the file before commit().
    const std::string& temporaryPath() const { return temporary_; }

    /// Flushes the content to the disk and renames it to its final name.
    Status commit();

private:
    NewFile(std::string path, std::string target, std::string temporary);
    Error failed(int code) const;
    void discard() noexcept;

    std::string path_;       ///< as the caller named it
    std::string target_;     ///< path with links followed
    std::string temporary_;  ///< empty once committed
};

enum class FolderAccess { Everybody, Owner };

/// Creates a directory and its parents; does nothing if it exists. Errors name it. access:
/// permissions of the created directories; Everybody: as the umask allows.
Status makeDirectory(const std::string& path, FolderAccess access = FolderAccess::Everybody);

/// Writes `content` to `path` as NewFile does.
Status writeFileAtomically(const std::string& path, std::string_view content);

}  // namespace terratact
