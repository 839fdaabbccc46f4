#pragma once

#include <string>
#include <utility>

#include "core/base/result.h"
#include "drivers/posix_fd.h"

namespace terratact {

/// STOP from one program of this computer to another: a datagram over a Unix socket. The receiving
/// end is a file of mode 0600. The kernel therefore lets only the same user and root send to it.
/// Nobody else can fill its queue. Each end also asks the kernel for the sender's user.

/// The receiving end, which stops the robot.
class StopLine {
public:
    /// path: of the socket to make, 1 to 100 characters. Error: a file is there, or its folder
    /// cannot be written.
    static Result<StopLine> listen(const std::string& path);

    StopLine(StopLine&& other) noexcept
        : socket_(std::move(other.socket_)), path_(std::exchange(other.path_, {}))
    {
    }
    ~StopLine();  ///< removes the socket

    /// Returns true if STOP was pressed at the other end since the last call, and answers it. Does
    /// not wait. One call reads at most kMaxDatagrams datagrams; the next one reads on.
    bool consume();
    static constexpr int kMaxDatagrams = 8;

private:
    StopLine(PosixFd socket, std::string path) : socket_(std::move(socket)), path_(std::move(path))
    {
    }
    PosixFd socket_;
    std::string path_;  ///< empty once moved from
};

/// The sending end, where STOP is pressed.
class StopCaller {
public:
    static Result<StopCaller> open();

    /// Sends STOP to the program that listens at this path of 1 to 100 characters. Afterwards, only
    /// that program can send to this end. Errors: the program is gone (ECONNREFUSED), its queue is
    /// full, or there is no socket (ENOENT). The last means that the program closed its line, or that
    /// something else removed the file.
    Status press(const std::string& path);
    /// Returns true once the other end has taken it. Does not wait.
    bool isTaken();

private:
    explicit StopCaller(PosixFd socket) : socket_(std::move(socket)) {}
    PosixFd socket_;
};

}  // namespace terratact
