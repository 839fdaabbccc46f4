#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/clouds/cloud_file.h"

namespace terratact {

/// Decompresses LZF from a file in pieces. A copy reaches back at most 8192 bytes, so no more is held.
/// The format, as the library LibLZF and PCD files have it, is a sequence of
///   000LLLLL <L + 1 bytes>              the bytes themselves
///   LLLooooo oooooooo                   L + 2 bytes copied from o + 1 bytes back, L = 1 … 6
///   111ooooo LLLLLLLL oooooooo          L + 9 bytes copied
class LzfStream {
public:
    /// `file` is at the first of `packed` compressed bytes.
    LzfStream(CloudFile file, std::uint64_t packed);

    /// Reads exactly `count` bytes into `into`. Errors name the file and the byte: the bytes end too early, or
    /// a copy reaches back beyond the first byte.
    Status read(std::size_t count, std::string& into);

    /// Passes over `count` bytes.
    Status skip(std::uint64_t count);

private:
    static constexpr std::size_t kWindow = 8192;

    Status decodeOne();
    bool take(std::size_t count, std::string& into);
    Error damaged(std::string_view what) const;

    CloudFile file_;
    std::uint64_t left_;    ///< compressed bytes
    std::string packed_;    ///< of one instruction
    std::string out_;       ///< the window, and behind it what is not read yet
    std::size_t read_ = 0;  ///< bytes of out_ that were read
};

}  // namespace terratact
