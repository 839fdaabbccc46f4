#pragma once

#include <string>

#include "core/base/result.h"
#include "drivers/posix_fd.h"

namespace terratact {

/// STOP from one program of this computer to another: a datagram over a Unix socket in the abstract namespace, which
/// leaves no file behind and is gone with whoever listens.  The most that anybody can do with it is to stop a robot.

/// The end that stops.
class StopLine {
public:
    /// name: 1 to 100 characters.  Error where it is taken.
    static Result<StopLine> listen(const std::string& name);

    /// True where STOP was pressed at the other end since the last time; then that end is answered.  Does not wait.
    bool take();

private:
    explicit StopLine(PosixFd socket) : socket_(std::move(socket)) {}
    PosixFd socket_;
};

/// The end where STOP is pressed.
class StopCaller {
public:
    static Result<StopCaller> open();

    /// Error: nobody listens under this name, of 1 to 100 characters, or takes what was sent before.
    Status press(const std::string& name);
    /// True once somebody has taken it.  Does not wait.
    bool isTaken();

private:
    explicit StopCaller(PosixFd socket) : socket_(std::move(socket)) {}
    PosixFd socket_;
};

}  // namespace terratact
