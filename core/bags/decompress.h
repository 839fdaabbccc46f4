#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace terratact {

/// Largest chunk of a recording, compressed or not [bytes].
inline constexpr std::size_t kMaxChunkBytes = std::size_t{64} << 20U;

/// Bounds of what compressed bytes may become.
inline constexpr std::size_t kSmallChunkBytes = std::size_t{16} << 20U, kMaxExpansion = 32;

/// Decompresses a chunk into `into`. method: "" or "none" (not compressed), "lz4" (LZ4 frames), "zstd",
/// "bz2". Memory grows with what comes out, at most kMaxChunkBytes, whatever sizes the bytes declare. A
/// small chunk yields at most kSmallChunkBytes, a larger one kMaxExpansion times its size: more is no
/// recording but an attack.
/// Errors: an unknown method, bytes that the method cannot read, bytes that end too early, or more than
/// that. `into` then holds what came out before.
Status decompress(std::string_view method, std::string_view bytes, std::string& into);

/// Decompresses the chunks of one recording, which together yield no more than kSmallRecordingBytes or
/// kMaxRecordingExpansion times its size. So time does not grow with what a small file repeats.
class ChunkUnpacker {
public:
    static constexpr std::uint64_t kSmallRecordingBytes = std::uint64_t{64} << 20U;
    static constexpr std::uint64_t kMaxRecordingExpansion = 200;

    /// recordingBytes: size of the file
    explicit ChunkUnpacker(std::uint64_t recordingBytes);

    /// decompress(), and the error that the recording yields too much. Then no further chunk is unpacked.
    Status unpack(std::string_view method, std::string_view bytes, std::string& into);

private:
    std::uint64_t most_, left_;
};

}  // namespace terratact
