#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <string>
#include <string_view>

namespace terratact {

/// Compresses the content of a chunk by "lz4", "zstd" or "bz2"; leaves it as it is for other methods.
inline std::string packed(std::string_view method, const std::string& plain)
{
    std::string bytes = plain;
    if (method == "lz4") {
        bytes.resize(LZ4F_compressFrameBound(plain.size(), nullptr));
        bytes.resize(
            LZ4F_compressFrame(bytes.data(), bytes.size(), plain.data(), plain.size(), nullptr));
    } else if (method == "zstd") {
        bytes.resize(ZSTD_compressBound(plain.size()));
        bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), plain.data(), plain.size(), 1));
    } else if (method == "bz2") {
        std::string copy = plain;  // the library takes no const
        auto size = static_cast<unsigned>(plain.size() + plain.size() / 50 + 700);
        bytes.resize(size);
        BZ2_bzBuffToBuffCompress(bytes.data(), &size, copy.data(),
                                 static_cast<unsigned>(copy.size()), 9, 0, 0);
        bytes.resize(size);
    }
    return bytes;
}

}  // namespace terratact
