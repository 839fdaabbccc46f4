#include "app/runtime/vector_registers.h"

namespace terratact {

void clearUpperVectorHalves()
{
#if defined(__x86_64__) && defined(__GNUC__)
    // SSE code keeps no values in the upper halves.
    static const bool hasThem = __builtin_cpu_supports("avx");
    if (hasThem) asm volatile("vzeroupper");
#endif
}

}  // namespace terratact
