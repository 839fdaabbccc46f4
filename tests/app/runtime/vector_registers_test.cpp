// Tests that the upper halves of vector registers are cleared.
#include "app/runtime/vector_registers.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

#if defined(__x86_64__)
TEST(VectorRegisters, haveEmptyUpperHalvesAfterwards)
{
    if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "this processor has none";
    using Four = float __attribute__((vector_size(16)));
    const auto upper = [] {
        Four half;
        asm volatile("vextractf128 $1, %%ymm15, %0" : "=x"(half));
        return half[0];
    };
    const float seven = 7.0F;
    asm volatile("vbroadcastss %0, %%ymm15" : : "m"(seven) : "xmm15");
    ASSERT_EQ(upper(), seven);
    clearUpperVectorHalves();
    EXPECT_EQ(upper(), 0.0F);
}
#endif

}  // namespace
}  // namespace terratact
