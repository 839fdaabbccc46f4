#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Permissions of a written file.
enum class Access {
    Everybody,   ///< a new file has what the umask allows; a replaced one keeps its permissions
    Owner,       ///< a new file is for its owner alone whatever the umask; a replaced one as above
    OwnerAlways  ///< for its owner alone, also where it replaces a file
};

/// Returns Done if an output path leads through no symbolic link of somebody else. The output itself
/// must not be a link at all, so that nothing is written through it. A folder above it may be a link
/// of this user or of root. Links of the kernel pass under these names only: /dev/stdout, /dev/stderr
/// and the numbers in /dev/fd and /proc/self/fd. Errors name the link.
Status checkLinks(const std::string& path);

/// Returns true for the name of a session, *.tts in letters of either case.
bool isSessionName(const std::string& path);

/// Returns Done if a new file may replace the one at `path`, or if there is none. Errors name it:
///   - checkLinks() refuses it.
///   - It is a directory, a device or a pipe.
///   - It is write-protected, by its mode for this user, or for everybody (which includes root).
///   - It is a recorded session or its journal, by content or by name (*.tts): a recording is never
///     replaced.
Status checkReplaceable(const std::string& path);

/// Atomic replacement of a file. The content is written under a temporary name in the same
/// directory. commit() renames it, so readers never find a part of the new file. Without commit() the
/// temporary file is removed.
class NewFile {
public:
    /// Creates the empty temporary file. Errors name the file: its directory does not exist or is
    /// not writable, or checkReplaceable() refuses the file at `path`. A file may hold recorded data.
    /// Only files that are made to be passed on are therefore for everybody.
    static Result<NewFile> begin(const std::string& path, Access access = Access::Owner);

    /// Creates the temporary file with this content, flushed to the disk. Errors: as begin(), or the
    /// content does not fit on the disk.
    static Result<NewFile> filled(const std::string& path, std::string_view content,
                                  Access access = Access::Owner);

    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&& other) noexcept;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    /// Returns the path to write to. Close the file before commit().
    const std::string& temporaryPath() const { return temporary_; }

    /// Opens the temporary file for writing; it follows no link that somebody has put there since.
    /// Returns a descriptor that the caller closes, or -1 and sets errno.
    int openTemporary() const;

    /// Flushes the content to the disk. Errors name the file.
    Status flush() const;

    /// Flushes the content to the disk and renames it to its final name.
    Status commit();

private:
    NewFile(std::string path, std::string target, std::string temporary);
    Error failed(int code) const;
    void discard() noexcept;

    std::string path_;       ///< as the caller named it
    std::string target_;     ///< path; for a name of the kernel the file that it means
    std::string temporary_;  ///< empty once committed
};

/// Creates a directory and its parents; does nothing if it exists. Errors name it. A part of the
/// path must not be a symbolic link that belongs neither to this user nor to root. Unless `access`
/// is Everybody, those that are made are for their owner alone.
Status makeDirectory(const std::string& path, Access access = Access::Everybody);

/// Writes `content` to `path` as NewFile does.
Status writeFileAtomically(const std::string& path, std::string_view content,
                           Access access = Access::Owner);

}  // namespace terratact
