#include "drivers/stop_line.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/base/system_message.h"

namespace terratact {
namespace {

constexpr std::string_view kStop = "terratact STOP", kTaken = "terratact STOP taken";

struct Address {
    sockaddr_un content{};
    socklen_t size = 0;
    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&content); }
};

Status check(const std::string& path)
{
    if (path.empty() || path.size() > 100)
        return Error{TR_NOOP("core", "a stop line needs a name of 1 to 100 characters"), EINVAL};
    return Done{};
}

/// Returns the address of a path. Empty: the kernel chooses a name without a file.
Address addressOf(const std::string& path)
{
    Address address;
    address.content.sun_family = AF_UNIX;
    path.copy(address.content.sun_path, sizeof address.content.sun_path - 1);
    const std::size_t length = path.empty() ? 0 : path.size() + 1;
    address.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
    return address;
}

Error lastError(const std::string& path)
{
    const int code = errno;
    return {Message::joined(Message::verbatim(path), systemMessage(code)), code};
}

Result<PosixFd> boundTo(const std::string& path)
{
    PosixFd socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket) return lastError(path);
    const int on = 1;
    if (::setsockopt(socket.get(), SOL_SOCKET, SO_PASSCRED, &on, sizeof on) != 0)
        return lastError(path);
    if (::fchmod(socket.get(), S_IRUSR | S_IWUSR) != 0) return lastError(path);
    const Address address = addressOf(path);
    if (::bind(socket.get(), address.get(), address.size) != 0) return lastError(path);
    return socket;
}

/// Returns true if the kernel names this user or root as the sender.
bool isFromUser(msghdr& message)
{
    const cmsghdr* const header = CMSG_FIRSTHDR(&message);
    if (!header || header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_CREDENTIALS)
        return false;
    ucred sender{};
    std::memcpy(&sender, CMSG_DATA(header), sizeof sender);
    return sender.uid == 0 || sender.uid == ::geteuid();
}

/// Reads one datagram. Returns false if there is none. from: address of its sender.
bool read(int socket, std::string_view wanted, bool& isWanted, Address& from)
{
    std::array<char, 64> text{};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(ucred))> sender{};
    iovec part{.iov_base = text.data(), .iov_len = text.size()};
    msghdr message{};
    message.msg_name = &from.content;
    message.msg_namelen = sizeof from.content;
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = sender.data();
    message.msg_controllen = sender.size();
    const ssize_t count = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    if (count < 0) return false;
    from.size = message.msg_namelen;
    isWanted = isFromUser(message)
            && std::string_view(text.data(), static_cast<std::size_t>(count)) == wanted;
    return true;
}

}  // namespace

Result<StopLine> StopLine::listen(const std::string& path)
{
    if (Status good = check(path); !good) return good.error();
    auto socket = boundTo(path);
    if (!socket) return socket.error();
    return StopLine(std::move(*socket), path);
}

StopLine::~StopLine()
{
    if (!path_.empty()) ::unlink(path_.c_str());
}

bool StopLine::consume()
{
    bool pressed = false, isStop = false;
    Address from;
    for (int i = 0; i < kMaxDatagrams && read(socket_.get(), kStop, isStop, from); ++i) {
        if (!isStop) continue;
        pressed = true;
        (void)::sendto(socket_.get(), kTaken.data(), kTaken.size(), MSG_NOSIGNAL, from.get(),
                       from.size);  // an absent sender needs no answer
    }
    return pressed;
}

Result<StopCaller> StopCaller::open()
{
    auto socket = boundTo({});
    if (!socket) return socket.error();
    return StopCaller(std::move(*socket));
}

Status StopCaller::press(const std::string& path)
{
    if (Status good = check(path); !good) return good;
    const Address address = addressOf(path);
    if (::connect(socket_.get(), address.get(), address.size) != 0) return lastError(path);
    (void)isTaken();  // an answer to an earlier press does not count
    if (::send(socket_.get(), kStop.data(), kStop.size(), MSG_NOSIGNAL) < 0) return lastError(path);
    return Done{};
}

bool StopCaller::isTaken()
{
    bool taken = false, isAnswer = false;
    Address from;
    while (read(socket_.get(), kTaken, isAnswer, from)) taken = taken || isAnswer;
    return taken;
}

}  // namespace terratact
