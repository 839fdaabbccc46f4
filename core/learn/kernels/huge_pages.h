#pragma once

#include <cstddef>

namespace terratact {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;  ///< [bytes]

/// Asks the system for pages of 2 MiB where these bytes hold whole ones (madvise(2),
/// MADV_HUGEPAGE). Kernels that stream through large factors then wait for fewer address
/// translations, and memory is released in larger pieces. The request has no effect outside Linux,
/// or if the system has no huge pages.
void preferHugePages(void* data, std::size_t bytes);

}  // namespace terratact
