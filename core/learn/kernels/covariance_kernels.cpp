#include "core/learn/kernels/covariance_kernels.h"

#include <array>

namespace terratact {

namespace kernels_baseline {
extern const CovarianceKernels kKernels;
}
#ifdef TERRATACT_X86_KERNELS
namespace kernels_avx2 {
extern const CovarianceKernels kKernels;
}
namespace kernels_avx512 {
extern const CovarianceKernels kKernels;
}
#endif

namespace {

struct Available {
    std::array<const CovarianceKernels*, 3> kernels{};
    int count = 0;

    Available()
    {
#ifdef TERRATACT_X86_KERNELS
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
            add(kernels_avx512::kKernels);
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            add(kernels_avx2::kKernels);
#endif
        add(kernels_baseline::kKernels);
    }
    void add(const CovarianceKernels& k)
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

const CovarianceKernels& covarianceKernels()
{
    return *available().kernels.front();
}

const CovarianceKernels* const* availableCovarianceKernels(int& count)
{
    count = available().count;
    return available().kernels.data();
}

}  // namespace terratact
