#pragma once

#include <cstddef>
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

}  // namespace terratact
