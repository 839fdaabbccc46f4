#include "core/learn/kernels/likelihood_kernels.h"

#include <array>

namespace terratact {

namespace likelihood_kernels_baseline {
extern const LikelihoodKernels kKernels;
}
#ifdef TERRATACT_X86_KERNELS
namespace likelihood_kernels_avx2 {
extern const LikelihoodKernels kKernels;
}
namespace likelihood_kernels_avx512 {
extern const LikelihoodKernels kKernels;
}
#endif

namespace {

struct Available {
    std::array<const LikelihoodKernels*, 3> kernels{};
    int count = 0;

    Available()
    {
#ifdef TERRATACT_X86_KERNELS
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
            add(likelihood_kernels_avx512::kKernels);
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            add(likelihood_kernels_avx2::kKernels);
#endif
        add(likelihood_kernels_baseline::kKernels);
    }
    void add(const LikelihoodKernels& k)
    {
        kernels[static_cast<std::size_t>(count++)] = &k;
    }
};

const Available& available()
{
    static const Available found;
    return found;
}

}  // namespace

const LikelihoodKernels& likelihoodKernels()
{
    return *available().kernels.front();
}

const LikelihoodKernels* const* availableLikelihoodKernels(int& count)
{
    count = available().count;
    return available().kernels.data();
}

}  // namespace terratact
