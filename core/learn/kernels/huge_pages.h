#pragma once

#include <cstddef>

namespace terratact {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;  ///< [bytes]

/// Asks the system for pages of 2 MiB where these bytes hold whole ones (madvise(2), MADV_HUGEPAGE): kernels that
/// stream through factors of many megabytes then wait for fewer addresses to be translated, and what is freed goes
/// back at once instead of 4 KiB by 4 KiB.  A wish: elsewhere than on Linux, or where the system has none, nothing
/// changes.
void preferHugePages(void* data, std::size_t bytes);

}  // namespace terratact
