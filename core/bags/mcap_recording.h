#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/bags/recording.h"

namespace terratact {

inline constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);

/// Opens an MCAP file (specification of version 0): chunks without compression, with lz4 or zstd. A
/// valid summary names all topics, and chunks without a selected topic are then not read. Without one,
/// the file is read from its beginning, as far as it goes. A chunk that cannot be decompressed or has a
/// wrong checksum is left out with a remark. Records of more than kMaxChunkBytes are passed over.
/// Errors name the file: it cannot be read, or is no MCAP file.
Result<std::unique_ptr<Recording>> openMcap(const std::string& path);

}  // namespace terratact
