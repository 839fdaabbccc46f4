#pragma once

#include <string>

#include "core/base/result.h"
#include "drivers/posix_fd.h"

namespace terratact {

/// STOP from one program of this computer to another: a datagram over a Unix socket in the abstract
/// namespace. The socket leaves no file and disappears with its listener. Such a socket has no
/// permissions, so each end asks the kernel for the sender's user: only datagrams of the same user
/// or of root count.

/// The receiving end, which stops the robot.
class StopLine {
public:
    /// name: 1 to 100 characters. Error: another program uses it.
    static Result<StopLine> listen(const std::string& name);

    /// Returns true if STOP was pressed at the other end since the last call, and answers it. Does
    /// not wait.
    bool consume();

private:
    explicit StopLine(PosixFd socket) : socket_(std::move(socket)) {}
    PosixFd socket_;
};

/// The sending end, where STOP is pressed.
class StopCaller {
public:
    static Result<StopCaller> open();

    /// Sends STOP. Error: no program listens under this name of 1 to 100 characters, or its queue
    /// is full.
    Status press(const std::string& name);
    /// Returns true once the other end has taken it. Does not wait.
    bool isTaken();

private:
    explicit StopCaller(PosixFd socket) : socket_(std::move(socket)) {}
    PosixFd socket_;
};

}  // namespace terratact
