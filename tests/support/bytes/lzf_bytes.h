#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace terratact {

/// Returns bytes compressed as LZF: a slow encoder that finds copies of at least three bytes, from the format's
/// description.
inline std::string lzfBytes(std::string_view data)
{
    std::string packed, literal;
    const auto flush = [&] {
        if (literal.empty()) return;
        packed += static_cast<char>(literal.size() - 1);
        packed += literal;
        literal.clear();
    };
    for (std::size_t at = 0; at < data.size();) {
        std::size_t best = 0, back = 0;
        for (std::size_t b = 1; b <= std::min<std::size_t>(at, 8192); ++b) {
            std::size_t n = 0;
            while (n < 264 && at + n < data.size() && data[at + n] == data[at + n - b]) ++n;
            if (n > best) {
                best = n;
                back = b;
            }
        }
        if (best < 3) {
            literal += data[at++];
            if (literal.size() == 32) flush();
            continue;
        }
        flush();
        const std::size_t offset = back - 1, length = best - 2;
        packed += static_cast<char>((std::min<std::size_t>(length, 7) << 5U) | (offset >> 8U));
        if (length >= 7) packed += static_cast<char>(length - 7);
        packed += static_cast<char>(offset & 0xffU);
        at += best;
    }
    flush();
    return packed;
}

}  // namespace terratact
