#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Whether a new file may take the place of what is at `path`; Done where nothing is there.  Errors name it:
///   it is a directory, a device or a pipe
///   it is write-protected: no right to write it, or no one has (which holds for root as well)
///   it is a recorded session or the journal of one, by its content or by its name (*.tts): a recording is never
///   replaced
Status checkReplaceable(const std::string& path);

/// A file on its way into being.  It is written under a temporary name in the directory of its final
/// name, which it takes only when it is whole: whoever looks sees the old file, or none, or the new one.
/// Without commit() the temporary file is removed.
class NewFile {
public:
    /// Creates the empty temporary file.  Errors name the file: no such directory, no right to write there, or
    /// what stands at `path` is not to be replaced (checkReplaceable()).  A symbolic link at `path` is followed; an
    /// existing file's permissions are kept.
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
