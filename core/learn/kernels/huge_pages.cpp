#include "core/learn/kernels/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace terratact {

void preferHugePages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
    const auto before = reinterpret_cast<std::uintptr_t>(data) % kHugePage;
    const std::size_t skipped = before == 0 ? 0 : kHugePage - before;
    if (bytes < skipped + kHugePage) return;
    madvise(static_cast<char*>(data) + skipped, (bytes - skipped) / kHugePage * kHugePage,
            MADV_HUGEPAGE);
#endif
}

}  // namespace terratact
