#include "core/store/file_write.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/system_message.h"
#include "core/base/text.h"
#include "core/store/content_kind.h"
#include "core/store/unfinished_files.h"

namespace terratact {
namespace {

Error cannotWrite(const std::string& path, const Message& cause, int code)
{
    return {Message(TR_NOOP("core", "%1: cannot be written: %2"), path, cause), code};
}

Error cannotWrite(const std::string& path, int code)
{
    return cannotWrite(path, systemMessage(code), code);
}

/// Descriptor that its destructor closes; close() returns whether the system kept what was written.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor()
    {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int fd() const { return fd_; }
    bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

private:
    int fd_;
};

/// Creates a file for writing: "<target>.tmp0", or the next free number.
int createBeside(const std::string& target, mode_t mode, std::string& name)
{
    constexpr int kTries = 1000;
    for (int i = 0; i < kTries; ++i) {
        name = target + ".tmp" + std::to_string(i);
        const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
    return -1;
}

/// Returns 0, or errno.
int writeAll(int fd, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t put = ::write(fd, content.data(), content.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        content.remove_prefix(static_cast<std::size_t>(put));
    }
    return 0;
}

/// Returns 0, or errno.
int flushToDisk(const std::string& path, int flags)
{
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags));
    if (file.fd() < 0 || ::fsync(file.fd()) != 0) return errno;
    return 0;
}

/// Returns true for the name of a file that SQLite keeps beside a session.
bool isJournalName(const std::string& path)
{
    const std::string name = lowerCase(std::filesystem::path(path).filename().string());
    return std::ranges::any_of(std::array{".tts-wal", ".tts-shm", ".tts-journal"},
                               [&name](const char* ending) { return name.ends_with(ending); });
}

bool isRecording(const std::string& path)
{
    const ContentKind kind = contentKindOfFile(path);
    return kind == ContentKind::Session || kind == ContentKind::Journal;
}

/// Returns true for the names of open files, which are links of the kernel: /dev/stdout, /dev/fd/3.
bool isKernelName(std::string_view path)
{
    if (path == "/dev/stdout" || path == "/dev/stderr") return true;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"})
        if (path.starts_with(folder))
            return writtenIntegerFrom<unsigned>(path.substr(folder.size())).has_value();
    return false;
}

bool isLink(const std::string& path, struct stat& found)
{
    return ::lstat(path.c_str(), &found) == 0 && S_ISLNK(found.st_mode);
}

/// Checks every part of a directory's path.
Status checkDirectoryLinks(const std::string& path)
{
    std::filesystem::path at;
    for (const std::filesystem::path& part : std::filesystem::path(path)) {
        at /= part;
        struct stat found {};
        if (isLink(at.string(), found) && found.st_uid != 0 && found.st_uid != ::geteuid())
            return Error{Message(TR_NOOP("core", "%1: nothing is written here: %2 is a symbolic "
                                                 "link of another user; name the folder itself"),
                                 path, at.string()),
                         ELOOP};
    }
    return Done{};
}

std::string directoryOf(const std::string& path)
{
    const std::string parent = std::filesystem::path(path).parent_path().string();
    return parent.empty() ? "." : parent;
}

}  // namespace

NewFile::NewFile(std::string path, std::string target, std::string temporary)
    : path_(std::move(path)), target_(std::move(target)), temporary_(std::move(temporary))
{
}

NewFile::NewFile(NewFile&& other) noexcept
    : path_(std::move(other.path_)), target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {}))
{
}

NewFile& NewFile::operator=(NewFile&& other) noexcept
{
    if (this == &other) return *this;
    discard();
    path_ = std::move(other.path_);
    target_ = std::move(other.target_);
    temporary_ = std::exchange(other.temporary_, {});
    return *this;
}

NewFile::~NewFile()
{
    discard();
}

Status checkLinks(const std::string& path)
{
    if (isKernelName(path)) return Done{};
    struct stat found {};
    if (!isLink(path, found)) return checkDirectoryLinks(directoryOf(path));
    std::error_code none;
    const std::string target = std::filesystem::read_symlink(path, none).string();
    return cannotWrite(path,
                       Message(TR_NOOP("core", "it is a symbolic link to %1, and nothing is "
                                               "written through a link: name the file itself"),
                               target),
                       ELOOP);
}

bool isSessionName(const std::string& path)
{
    return lowerCase(std::filesystem::path(path).filename().string()).ends_with(".tts");
}

Status checkReplaceable(const std::string& path)
{
    if (Status direct = checkLinks(path); !direct) return direct;
    if (isJournalName(path))
        return cannotWrite(
            path, TR_NOOP("core", "it has the name of a session's journal: name another file"), 0);
    struct stat old {};
    if (::stat(path.c_str(), &old) != 0) return Done{};
    if (S_ISDIR(old.st_mode)) return cannotWrite(path, EISDIR);
    if (!S_ISREG(old.st_mode))
        return cannotWrite(path, TR_NOOP("core", "it is not a regular file"), 0);
    if (isSessionName(path) || isRecording(path))
        return cannotWrite(
            path,
            TR_NOOP("core",
                    "a recorded session is there, which is never replaced: name another file"),
            0);
    if (::access(path.c_str(), W_OK) != 0) return cannotWrite(path, errno);
    if ((old.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
        return cannotWrite(path, TR_NOOP("core", "it is write-protected: name another file"),
                           EACCES);
    return Done{};
}

Result<NewFile> NewFile::begin(const std::string& path, Access access)
{
    if (const Status allowed = checkReplaceable(path); !allowed) return allowed.error();
    struct stat old {};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    std::error_code none;
    const std::string target = exists ? std::filesystem::canonical(path, none).string() : path;
    if (none) return cannotWrite(path, none.value());

    std::string temporary;
    constexpr mode_t kOwner = S_IRUSR | S_IWUSR;
    const bool byUmask = !exists && access == Access::Everybody;
    const bool keepsMode = exists && access != Access::OwnerAlways;
    const Descriptor file(createBeside(target, byUmask ? 0666 : kOwner, temporary));
    if (file.fd() < 0) return cannotWrite(path, errno);
    noteUnfinished(temporary);
    NewFile created(path, target, temporary);
    const mode_t mode = keepsMode ? old.st_mode & 07777 : kOwner;
    if (!byUmask && ::fchmod(file.fd(), mode) != 0) return cannotWrite(path, errno);
    return created;
}

Result<NewFile> NewFile::filled(const std::string& path, std::string_view content, Access access)
{
    Result<NewFile> file = begin(path, access);
    if (!file) return file;
    Descriptor out(file->openTemporary());
    if (out.fd() < 0) return cannotWrite(path, errno);
    if (const int code = writeAll(out.fd(), content)) return cannotWrite(path, code);
    if (::fsync(out.fd()) != 0 || !out.close()) return cannotWrite(path, errno);
    return file;
}

int NewFile::openTemporary() const
{
    return ::open(temporary_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
}

Status NewFile::flush() const
{
    const int code = flushToDisk(temporary_, 0);
    return code == 0 ? Status(Done{}) : failed(code);
}

Status NewFile::commit()
{
    if (Status flushed = flush(); !flushed) return flushed;
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) return failed(errno);
    forgetUnfinished(temporary_);
    temporary_.clear();
    if (const int code = flushToDisk(directoryOf(target_), O_DIRECTORY)) return failed(code);
    return Done{};
}

Error NewFile::failed(int code) const
{
    return cannotWrite(path_, code);
}

void NewFile::discard() noexcept
{
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    forgetUnfinished(temporary_);
    temporary_.clear();
}

Status makeDirectory(const std::string& path, Access access)
{
    if (Status direct = checkDirectoryLinks(path); !direct) return direct;
    std::error_code failed;
    if (access != Access::Everybody) {
        std::vector<std::string> missing;
        for (std::filesystem::path at = path; !at.empty() && !std::filesystem::exists(at, failed);
             at = at.parent_path())
            missing.push_back(at.string());
        std::reverse(missing.begin(), missing.end());
        for (const std::string& at : missing)
            if (::mkdir(at.c_str(), S_IRWXU) == 0)   // if it fails, the next step fails too
                (void)::chmod(at.c_str(), S_IRWXU);  // the umask may have taken away more
    }
    std::filesystem::create_directories(path, failed);
    if (failed)
        return Error{Message(TR_NOOP("core", "%1: the directory cannot be made: %2"), path,
                             systemMessage(failed.value())),
                     failed.value()};
    return Done{};
}

Status writeFileAtomically(const std::string& path, std::string_view content, Access access)
{
    Result<NewFile> file = NewFile::filled(path, content, access);
    return file ? file->commit() : Status(file.error());
}

}  // namespace terratact
