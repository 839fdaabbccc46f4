#include "tests/bench/fma_peak.h"

namespace terratact {
namespace {

// Twelve independent chains hide a latency of four or five cycles on two units. The loop is repeated per instruction
// set, because a template cannot change its target.
#define TERRATACT_PEAK(name, target, T, bytes)                                                     \
    target double name(int rounds)                                                                 \
    {                                                                                              \
        typedef T V __attribute__((vector_size(bytes)));                                           \
        constexpr int kChains = 12;                                                                \
        V chain[kChains] = {};                                                                     \
        V factor = V{} + T(0.5);                                                                   \
        V term = V{} + T(1);                                                                       \
        asm volatile("" : "+m"(factor), "+m"(term));                                               \
        const V f = factor;                                                                        \
        const V t = term;                                                                          \
        for (int k = 0; k < rounds; ++k)                                                           \
            _Pragma("GCC unroll 12") for (int c = 0; c < kChains; ++c) chain[c] =                  \
                chain[c] * f + t;                                                                  \
        V sum{};                                                                                   \
        for (int c = 0; c < kChains; ++c) sum += chain[c];                                         \
        asm volatile("" : : "m"(sum));                                                             \
        return 2.0 * rounds * kChains * (bytes / sizeof(T));                                       \
    }

#ifdef __x86_64__
#define TERRATACT_AVX512 __attribute__((target("avx512f,fma")))
#define TERRATACT_AVX2 __attribute__((target("avx2,fma")))
TERRATACT_PEAK(single512, TERRATACT_AVX512, float, 64)
TERRATACT_PEAK(double512, TERRATACT_AVX512, double, 64)
TERRATACT_PEAK(single256, TERRATACT_AVX2, float, 32)
TERRATACT_PEAK(double256, TERRATACT_AVX2, double, 32)
#endif
TERRATACT_PEAK(single128, , float, 16)
TERRATACT_PEAK(double128, , double, 16)

}  // namespace

const FmaPeak& fmaPeak(std::string_view kernels)
{
    static const FmaPeak baseline{single128, double128};
#ifdef __x86_64__
    static const FmaPeak avx512{single512, double512};
    static const FmaPeak avx2{single256, double256};
    if (kernels == "AVX-512") return avx512;
    if (kernels == "AVX2") return avx2;
#endif
    (void)kernels;
    return baseline;
}

}  // namespace terratact
