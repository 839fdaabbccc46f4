#include "drivers/can_socket.h"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <optional>
#include <system_error>

#include "core/base/system_message.h"

namespace terratact {
namespace {

constexpr std::size_t kBatch = 64;  // frames per system call

Error errorOf(int code)
{
    return {systemMessage(code), code};
}

Error errorOf(int code, const std::string& interface, Message what)
{
    return {Message::joined(Message::verbatim(interface), std::move(what)), code};
}

ifreq requestFor(const std::string& interface)
{
    ifreq request{};
    interface.copy(request.ifr_name, sizeof request.ifr_name - 1);
    return request;
}

/// Returns the index of the interface that has this name now; 0: none.
int indexOf(int socket, const std::string& interface)
{
    ifreq request = requestFor(interface);
    return ::ioctl(socket, SIOCGIFINDEX, &request) == 0 ? request.ifr_ifindex : 0;
}

/// Buffer of one datagram for the kernel.
struct Slot {
    canfd_frame frame;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> control;
    iovec vector;
};

/// Returns seconds since 1970; 0 without a stamp.
double stampOf(msghdr& header)
{
    for (cmsghdr* c = CMSG_FIRSTHDR(&header); c; c = CMSG_NXTHDR(&header, c)) {
        if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMPNS) continue;
        timespec stamp{};
        std::memcpy(&stamp, CMSG_DATA(c), sizeof stamp);
        return static_cast<double>(stamp.tv_sec) + 1e-9 * static_cast<double>(stamp.tv_nsec);
    }
    return 0.0;
}

/// Converts the kernel's frame to plain values; empty if the datagram is no frame.
std::optional<CanFrame> frameOf(const canfd_frame& raw, std::size_t bytes)
{
    const bool fd = bytes == CANFD_MTU;
    if (!fd && bytes != CAN_MTU) return std::nullopt;
    if (raw.len > (fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN)) return std::nullopt;

    CanFrame frame;
    frame.fd = fd;
    frame.error = raw.can_id & CAN_ERR_FLAG;
    frame.extended = !frame.error && (raw.can_id & CAN_EFF_FLAG);
    frame.remote = !frame.error && !fd && (raw.can_id & CAN_RTR_FLAG);
    frame.id = raw.can_id & (frame.error || frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.length = raw.len;
    std::copy_n(raw.data, std::min<std::size_t>(raw.len, frame.data.size()), frame.data.begin());
    return frame;
}

can_frame rawOf(const CanFrame& frame)
{
    can_frame raw{};
    raw.can_id =
        frame.id | (frame.extended ? CAN_EFF_FLAG : 0u) | (frame.remote ? CAN_RTR_FLAG : 0u);
    raw.len = frame.length;
    std::copy_n(frame.data.begin(), std::min<std::size_t>(frame.length, CAN_MAX_DLEN), raw.data);
    return raw;
}

class RawCanSocket final : public CanSocket {
public:
    RawCanSocket(PosixFd fd, std::string interface, int index)
        : fd_(std::move(fd)), interface_(std::move(interface)), index_(index)
    {
    }

    Result<Reading> read(std::span<BusFrame> frames, double patience) override
    {
        pollfd wanted{.fd = fd_.get(), .events = POLLIN, .revents = 0};
        const timespec limit = timespecOf(patience);
        const int ready = ::ppoll(&wanted, 1, &limit, nullptr);
        if (ready == 0 || (ready < 0 && errno == EINTR)) return Reading{.emptied = true};
        if (ready < 0) return errorOf(errno);
        return readNow(frames.first(std::min(frames.size(), kBatch)));
    }

    Status write(const CanFrame& frame) override
    {
        const can_frame raw = rawOf(frame);
        const ssize_t written = ::send(fd_.get(), &raw, sizeof raw, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (written < 0) return errorOf(errno);
        if (written != sizeof raw) return Error{TR_NOOP("core", "the frame was cut short"), EIO};
        return Done{};
    }

    Link link() const override
    {
        ifreq request = requestFor(interface_);
        if (indexOf(fd_.get(), interface_) != index_) return Link::Gone;
        if (::ioctl(fd_.get(), SIOCGIFFLAGS, &request) != 0) return Link::Gone;
        return request.ifr_flags & IFF_UP ? Link::Up : Link::Down;
    }

    // SO_RXQ_OVFL is no alternative: its count comes with the next frame, and never if none
    // follows.
    std::uint64_t drops() const override
    {
        std::array<std::uint32_t, SK_MEMINFO_VARS> information{};
        socklen_t size = sizeof information;
        const int got = ::getsockopt(fd_.get(), SOL_SOCKET, SO_MEMINFO, information.data(), &size);
        return got == 0 ? information[SK_MEMINFO_DROPS] : 0;
    }

    std::size_t receiveBuffer() const override
    {
        int bytes = 0;
        socklen_t size = sizeof bytes;
        const int got = ::getsockopt(fd_.get(), SOL_SOCKET, SO_RCVBUF, &bytes, &size);
        return got == 0 && bytes > 0 ? static_cast<std::size_t>(bytes) : 0;
    }

private:
    static timespec timespecOf(double seconds)
    {
        const double whole = std::floor(std::max(0.0, seconds));
        return {.tv_sec = static_cast<time_t>(whole),
                .tv_nsec = static_cast<long>(1e9 * (std::max(0.0, seconds) - whole))};
    }

    Result<Reading> readNow(std::span<BusFrame> frames)
    {
        std::array<mmsghdr, kBatch> messages{};
        for (std::size_t i = 0; i < frames.size(); ++i) {
            slots_[i].vector = {.iov_base = &slots_[i].frame, .iov_len = sizeof slots_[i].frame};
            messages[i].msg_hdr.msg_iov = &slots_[i].vector;
            messages[i].msg_hdr.msg_iovlen = 1;
            messages[i].msg_hdr.msg_control = slots_[i].control.data();
            messages[i].msg_hdr.msg_controllen = slots_[i].control.size();
        }
        const int got = ::recvmmsg(fd_.get(), messages.data(), static_cast<unsigned>(frames.size()),
                                   MSG_DONTWAIT, nullptr);
        if (got < 0 && (errno == EAGAIN || errno == EINTR)) return Reading{.emptied = true};
        if (got < 0) return errorOf(errno);

        Reading reading{.emptied = static_cast<std::size_t>(got) < frames.size()};
        for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
            msghdr& header = messages[i].msg_hdr;
            const auto frame = header.msg_flags & MSG_TRUNC
                                 ? std::nullopt
                                 : frameOf(slots_[i].frame, messages[i].msg_len);
            if (!frame) {
                ++reading.malformed;
                continue;
            }
            frames[reading.frames++] = {.frame = *frame,
                                        .time = 0.0,
                                        .wallTime = stampOf(header),
                                        .echo = (header.msg_flags & MSG_CONFIRM) != 0,
                                        .local = (header.msg_flags & MSG_DONTROUTE) != 0};
        }
        return reading;
    }

    PosixFd fd_;
    std::string interface_;
    int index_;
    std::array<Slot, kBatch> slots_{};  // buffers of read()
};

template <class T>
bool set(const PosixFd& fd, int level, int option, const T& value)
{
    return ::setsockopt(fd.get(), level, option, &value, sizeof value) == 0;
}

bool configure(const PosixFd& fd, int receiveBuffer)
{
    const int on = 1;
    const can_err_mask_t errors = CAN_ERR_MASK;
    // SO_RCVBUFFORCE needs a privilege; receiveBuffer() returns the granted size.
    if (!set(fd, SOL_SOCKET, SO_RCVBUFFORCE, receiveBuffer))
        set(fd, SOL_SOCKET, SO_RCVBUF, receiveBuffer);
    return set(fd, SOL_SOCKET, SO_TIMESTAMPNS, on) && set(fd, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, on)
        && set(fd, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, on)
        && set(fd, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, errors);
}

Message whyNoSocket(int code)
{
    switch (code) {
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
    case ESOCKTNOSUPPORT:
        return TR_NOOP("core", "the kernel has no CAN here: load it (sudo modprobe can_raw), or "
                               "use another kernel");
    case EPERM:
    case EACCES:
        return TR_NOOP("core", "this process may not open CAN sockets: a sandbox or container "
                               "forbids it, start it outside (or: sudo setcap cap_net_raw+ep "
                               "PROGRAM)");
    default: return {TR_NOOP("core", "no socket: %1"), systemMessage(code)};
    }
}

}  // namespace

Result<std::unique_ptr<CanSocket>> openCanSocket(const std::string& interface, int receiveBuffer)
{
    PosixFd fd(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW));
    if (!fd) return errorOf(errno, interface, whyNoSocket(errno));

    ifreq request = requestFor(interface);
    if (::ioctl(fd.get(), SIOCGIFHWADDR, &request) != 0)
        return Error{describe(BusState::Absent, interface), ENODEV};
    if (request.ifr_hwaddr.sa_family != ARPHRD_CAN)
        return errorOf(
            EPFNOSUPPORT, interface,
            TR_NOOP("core", "is no CAN interface (ip -brief link show type can lists those)"));
    if (!configure(fd, receiveBuffer))
        return errorOf(
            errno, interface,
            Message(TR_NOOP("core", "the kernel's CAN is too old: %1"), errorOf(errno).text));

    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = indexOf(fd.get(), interface);
    if (address.can_ifindex == 0) return Error{describe(BusState::Absent, interface), ENODEV};
    if (::bind(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        const int code = errno;
        return code == ENODEV
                 ? Error{describe(BusState::Absent, interface), ENODEV}
                 : errorOf(code, interface,
                           Message(TR_NOOP("core", "not bound: %1"), errorOf(code).text));
    }
    return std::unique_ptr<CanSocket>(
        std::make_unique<RawCanSocket>(std::move(fd), interface, address.can_ifindex));
}

std::unique_ptr<CanSocket> canSocketOn(PosixFd fd, const std::string& interface)
{
    const int index = indexOf(fd.get(), interface);
    return std::make_unique<RawCanSocket>(std::move(fd), interface, index);
}

}  // namespace terratact
