#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace terratact {

/// A file on its way into being.  It is written under a temporary name in the directory of its final
/// name, which it takes only when it is whole: whoever looks sees the old file, or none, or the new one.
/// Without commit() the temporary file is removed.
class NewFile {
public:
    /// Creates the empty temporary file.  Errors name the file: no such directory, no right to write (nor
    /// to write the file it would replace), or no file but a directory, device or pipe stands at `path`.  A symbolic link at
    /// `path` is followed; an existing file's permissions are kept.
    static Result<NewFile> begin(const std::string& path);

    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&& other) noexcept;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    /// Where to write.  Close it before commit().
    const std::string& temporaryPath() const { return temporary_; }

    /// Flushes the content to the disk and renames it to its final name.
    Status commit();

private:
    NewFile(std::string path, std::string target, std::string temporary);
    Error failed(int code) const;
    void discard() noexcept;

    std::string path_;       ///< as the caller named it
    std::string target_;     ///< links followed
    std::string temporary_;  ///< empty once committed
};

enum class FolderAccess { Everybody, Owner };

/// Makes a directory and those above it; none of that where it exists.  Errors name it.
/// access: to those that are made; Everybody: as far as the umask says.
Status makeDirectory(const std::string& path, FolderAccess access = FolderAccess::Everybody);

/// Puts `content` at `path` as NewFile does.
Status writeFileAtomically(const std::string& path, std::string_view content);

}  // namespace terratact
