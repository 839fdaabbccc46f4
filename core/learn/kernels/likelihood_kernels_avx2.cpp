#define TERRATACT_KERNEL_NAMESPACE likelihood_kernels_avx2
#define TERRATACT_KERNEL_NAME "AVX2"
#define TERRATACT_KERNEL_LANES 4
#define TERRATACT_KERNEL_ROWS 4
#define TERRATACT_KERNEL_VECTORS 2
#include "core/learn/kernels/likelihood_kernels.inl"
