#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Bytes of a log from a file or a pipe, which may be endless and may be packed by gzip. It holds
/// at most two blocks in memory. Packed bytes that grow to more than 64 MB and to more than 200
/// times their size are refused. A small file cannot take long to read.
class LogBytes {
public:
    /// Fills the span from its beginning and returns the number of bytes; 0: end of the log. It
    /// waits for one byte, not for a full span.
    using Source = std::function<Result<std::size_t>(std::span<char>)>;

    explicit LogBytes(Source source);
    ~LogBytes();
    LogBytes(LogBytes&&) noexcept;
    LogBytes& operator=(LogBytes&&) noexcept;

    /// Opens a file, a pipe, a device, or "-" for standard input. Errors name it.
    static Result<Source> sourceOf(const std::string& path);

    /// Returns the bytes that are available and not taken yet, at least `least` bytes unless the
    /// log ends. Errors are sentences without the file's name.
    Result<std::string_view> peek(std::size_t least);
    void consume(std::size_t bytes);

    bool isPacked() const;
    bool isTorn() const;  ///< the packed bytes ended too early
    /// Bytes that are neither gzip nor zeros follow the packed bytes; they are ignored.
    bool isFollowed() const;

private:
    struct Packed;
    Result<std::size_t> more();
    Result<std::size_t> unpack(std::span<char> room);
    Status begin();
    void addWide(std::string_view bytes);

    Source source_;
    std::unique_ptr<Packed> packed_;
    std::string block_;   ///< available bytes
    std::size_t at_ = 0;  ///< number of taken bytes of the block
    bool hasBegun_ = false, hasEnded_ = false;
    bool isWide_ = false, isLowFirst_ = false;  ///< UTF-16, and its byte order
    std::string half_;                          ///< one byte of UTF-16 that waits for its second
};

}  // namespace terratact
