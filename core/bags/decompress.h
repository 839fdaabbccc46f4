#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Largest chunk of a recording, compressed or not [bytes].
inline constexpr std::size_t kMaxChunkBytes = std::size_t{64} << 20U;

/// Bounds of the decompressed size.
inline constexpr std::size_t kSmallChunkBytes = std::size_t{16} << 20U, kMaxExpansion = 32;

/// Decompresses a chunk into `into`. method: "" or "none" (not compressed), "lz4" (LZ4 frames), "zstd",
/// "bz2". Memory grows with the output, to at most kMaxChunkBytes, whatever sizes the bytes declare. A
/// small chunk yields at most kSmallChunkBytes, a larger one kMaxExpansion times its size. A larger
/// result is treated as an attack.
/// Errors: an unknown method, bytes that the method cannot read, bytes that end too early, or more than
/// that. `into` then holds the output until the error.
Status decompress(std::string_view method, std::string_view bytes, std::string& into);

/// Decompresses the chunks of one recording. Together they yield at most kSmallRecordingBytes, or
/// kMaxRecordingExpansion times its size. A small file with repeated chunks therefore takes bounded time.
class ChunkUnpacker {
public:
    static constexpr std::uint64_t kSmallRecordingBytes = std::uint64_t{64} << 20U;
    static constexpr std::uint64_t kMaxRecordingExpansion = 200;

    /// recordingBytes: size of the file
    explicit ChunkUnpacker(std::uint64_t recordingBytes);

    /// Calls decompress(). Errors: those of decompress(), or a recording that yields too much. No further
    /// chunk is unpacked then.
    Status unpack(std::string_view method, std::string_view bytes, std::string& into);

private:
    std::uint64_t most_, left_;
};

}  // namespace terratact
