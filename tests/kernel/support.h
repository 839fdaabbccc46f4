#pragma once

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>

#include "drivers/posix_fd.h"

namespace terratact {

/// Runs a shell command; throws if it fails.
inline void shell(const std::string& command)
{
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

/// Returns the number of open descriptors of this process.
inline std::size_t openDescriptors()
{
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
        count += entry.exists() || entry.is_symlink();
    return count;
}

/// Another program on an interface: a plain socket that sends any frame.
class Peer {
public:
    explicit Peer(const std::string& interface)
        : fd_(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW))
    {
        const int on = 1;
        ::setsockopt(fd_.get(), SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on);
        sockaddr_can address{};
        address.can_family = AF_CAN;
        address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
        if (::bind(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error("no peer on " + interface);
    }

    /// Sends a classic frame with all flags in the identifier, in the kernel's format; false if the kernel refuses it.
    bool send(canid_t id, std::uint8_t length = 8, std::uint64_t data = 0) const
    {
        can_frame frame{};
        frame.can_id = id;
        frame.len = length;
        std::memcpy(frame.data, &data, sizeof data);
        return ::send(fd_.get(), &frame, sizeof frame, 0) == sizeof frame;
    }
    bool sendFd(canid_t id, std::uint8_t length) const
    {
        canfd_frame frame{};
        frame.can_id = id;
        frame.len = length;
        return ::send(fd_.get(), &frame, sizeof frame, 0) == sizeof frame;
    }

    /// Returns the number of received classic frames; waits `patience` [s] for each.
    int count(double patience) const
    {
        const timeval limit{
            .tv_sec = static_cast<time_t>(patience),
            .tv_usec = static_cast<suseconds_t>(
                1e6 * (patience - static_cast<double>(static_cast<time_t>(patience))))};
        ::setsockopt(fd_.get(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        int frames = 0;
        can_frame frame{};
        while (::recv(fd_.get(), &frame, sizeof frame, 0) == sizeof frame) ++frames;
        return frames;
    }

private:
    PosixFd fd_;
};

/// Stalls the bus as if no node acknowledged: frames stay in a queue of `bytes`.
inline void stall(const std::string& interface, int bytes)
{
    shell("tc qdisc replace dev " + interface + " root tbf rate 8bit burst 16 limit "
          + std::to_string(bytes));
}

/// Ends the stall. Throws if the interface accepts no frame, which this queue needs as a trigger.
inline void letGo(const std::string& interface)
{
    shell("tc qdisc change dev " + interface + " root tbf rate 10mbit burst 10000 limit 100000");
    if (!Peer(interface).send(0x7ff)) throw std::runtime_error(interface + " takes no frame");
}

}  // namespace terratact
