#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// File of records that is read in pieces. No more than the wanted piece is held.
class BagFile {
public:
    /// Errors name the file: it cannot be opened, or is no regular file.
    static Result<BagFile> open(const std::string& path);

    std::uint64_t size() const { return size_; }
    std::uint64_t at() const { return at_; }
    std::uint64_t left() const { return size_ - at_; }

    void goTo(std::uint64_t offset);

    /// Reads exactly the next `count` bytes into `into`. Returns false and reads nothing if the file has
    /// fewer bytes or `count` is above `most`.
    bool read(std::uint64_t count, std::uint64_t most, std::string& into);

private:
    BagFile(std::ifstream file, std::uint64_t size) : file_(std::move(file)), size_(size) {}

    std::ifstream file_;
    std::uint64_t size_ = 0, at_ = 0;
};

}  // namespace terratact
