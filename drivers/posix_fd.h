#pragma once

#include <unistd.h>

#include <utility>

namespace terratact {

/// Owns a file descriptor, or none (-1).
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

    /// Closes it.  Linux frees the descriptor even where close() fails, so nothing can be done about that.
    void reset()
    {
        if (fd_ >= 0) ::close(fd_);
        fd_ = -1;
    }

private:
    int fd_ = -1;
};

}  // namespace terratact
