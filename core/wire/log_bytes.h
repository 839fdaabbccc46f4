#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// The bytes of a log as they come: of a file, of a pipe that may be endless, packed by gzip or not.  Holds no more
/// than two blocks.
class LogBytes {
public:
    /// Fills what it is given from its beginning and says how many; 0: there is no more.  It waits for one byte, not for
    /// all.
    using Source = std::function<Result<std::size_t>(std::span<char>)>;

    explicit LogBytes(Source source);
    ~LogBytes();
    LogBytes(LogBytes&&) noexcept;
    LogBytes& operator=(LogBytes&&) noexcept;

    /// A file, a pipe, a device; "-": standard input.  Errors name it.
    static Result<Source> sourceOf(const std::string& path);

    /// What is at hand and not taken yet, at least `least` bytes where there are so many.  Errors are sentences without
    /// the file's name.
    Result<std::string_view> peek(std::size_t least);
    void take(std::size_t bytes);

    bool isPacked() const;
    bool isTorn() const;  ///< the packed bytes ended before they were whole
    bool isFollowed()
        const;  ///< bytes that are neither gzip nor zeros stand behind the packed ones; they are left out

private:
    struct Packed;
    Result<std::size_t> more();
    Result<std::size_t> unpack(std::span<char> room);
    Status begin();
    void addWide(std::string_view bytes);

    Source source_;
    std::unique_ptr<Packed> packed_;
    std::string block_;   ///< what is at hand
    std::size_t at_ = 0;  ///< what of it is taken
    bool hasBegun_ = false, hasEnded_ = false;
    bool isWide_ = false, isLowFirst_ = false;  ///< UTF-16, and which of two bytes is first
    std::string half_;                          ///< a byte of UTF-16 that waits for its other
};

}  // namespace terratact
