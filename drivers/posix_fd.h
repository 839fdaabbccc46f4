#pragma once

#include <unistd.h>

#include <utility>

namespace terratact {

/// Owner of a file descriptor, or of none (-1).
class PosixFd {
public:
    PosixFd() = default;
    explicit PosixFd(int fd) : fd_(fd) {}
    PosixFd(PosixFd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    PosixFd& operator=(PosixFd&& other) noexcept
    {
        if (this != &other) {
            reset();
            fd_ = std::exchange(other.fd_, -1);
        }
        return *this;
    }
    ~PosixFd() { reset(); }

    int get() const { return fd_; }
    explicit operator bool() const { return fd_ >= 0; }

    /// Closes the descriptor. Linux frees it even if close() fails, so an error needs no handling.
    void reset()
    {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

private:
    int fd_ = -1;
};

}  // namespace terratact
