#pragma once

// The kernels keep vectors in arrays, which scalable vectors do not allow. Bits 4 and 6 are AVX3_SPR and AVX3_ZEN4 of
// Highway 1.1 and later: they would gain nothing over AVX3 here, and cost compile time.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | (1LL << 4) | (1LL << 6))

#include <hwy/targets.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace terratact {

/// Returns the name of an instruction set of Highway; "baseline": every processor runs it.
constexpr const char* nameOfTarget(std::int64_t target)
{
    if (target == HWY_STATIC_TARGET) return "baseline";
    if (target == HWY_AVX3) return "AVX-512";
    if (target == HWY_AVX2) return "AVX2";
    return target == HWY_SSE4 ? "SSE4" : "SSSE3";
}

/// The variants of a set of kernels that this processor runs, fastest first.
template <class Kernels>
class KernelVariants {
public:
    struct Compiled {
        std::int64_t target;
        const Kernels* kernels;
    };
    /// compiled: fastest first, at most five; the last one runs on every processor.
    KernelVariants(std::initializer_list<Compiled> compiled)
    {
        for (const Compiled& one : compiled)
            if (one.target == HWY_STATIC_TARGET || (hwy::SupportedTargets() & one.target) != 0)
                variants_[static_cast<std::size_t>(count_++)] = one.kernels;
    }

    const Kernels& fastest() const { return *variants_.front(); }
    const Kernels* const* all() const { return variants_.data(); }
    int count() const { return count_; }

private:
    std::array<const Kernels*, 5> variants_{};
    int count_ = 0;
};

}  // namespace terratact

/// Lists the compiled variants of the constant `kernels`, for KernelVariants. On x86-64 the baseline
/// is EMU128 for Highway 1.0, and SSE2 for later versions. A better instruction set has a smaller
/// number.
#if (HWY_TARGETS & HWY_AVX2) && HWY_STATIC_TARGET > HWY_SSSE3
#define TERRATACT_KERNEL_VARIANTS(kernels)                                                         \
    {                                                                                              \
        {HWY_AVX3, &N_AVX3::kernels}, {HWY_AVX2, &N_AVX2::kernels}, {HWY_SSE4, &N_SSE4::kernels},  \
            {HWY_SSSE3, &N_SSSE3::kernels},                                                        \
        {                                                                                          \
            HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(kernels)                                       \
        }                                                                                          \
    }
#else
#define TERRATACT_KERNEL_VARIANTS(kernels)                                                         \
    {                                                                                              \
        {                                                                                          \
            HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(kernels)                                       \
        }                                                                                          \
    }
#endif
