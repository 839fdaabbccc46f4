#include "core/store/file_read.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "core/base/system_message.h"

namespace terratact {
namespace {

/// Descriptor that its destructor closes.
class OpenFile {
public:
    explicit OpenFile(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
    {
        // A socket, which some shells and services connect, cannot be opened a second time.
        if (fd_ < 0 && errno == ENXIO && path == "/dev/stdin")
            fd_ = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
    }
    ~OpenFile()
    {
        if (fd_ >= 0) ::close(fd_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int fd() const { return fd_; }

private:
    int fd_;
};

Error systemError(const std::string& path, SourceText what, int code)
{
    return fileError(path, Message::joined(what, systemMessage(code)), code);
}

}  // namespace

Error fileError(const std::string& path, Message cause, int code)
{
    return {Message::joined(Message::verbatim(path), withoutControls(std::move(cause))), code};
}

Error fileError(const std::string& path, std::string_view cause, int code)
{
    Message whole = withoutControls(Message::verbatim(std::string(cause)));
    return {path + ": " + whole.source, code};
}

Result<std::string> readFile(const std::string& path, std::size_t most)
{
    const OpenFile file(path);
    if (file.fd() < 0) return systemError(path, TR_NOOP("core", "cannot be opened"), errno);
    std::string content;
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t got = ::read(file.fd(), block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return systemError(path, TR_NOOP("core", "cannot be read"), errno);
        if (got == 0) return content;
        if (content.size() + static_cast<std::size_t>(got) > most)
            return fileError(
                path, Message(TR_NOOP("core", "is larger than the %1 bytes allowed here"), most));
        content.append(block.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace terratact
