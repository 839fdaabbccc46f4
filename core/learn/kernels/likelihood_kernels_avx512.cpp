#define TERRATACT_KERNEL_NAMESPACE likelihood_kernels_avx512
#define TERRATACT_KERNEL_NAME "AVX-512"
#define TERRATACT_KERNEL_LANES 8
#define TERRATACT_KERNEL_ROWS 8
#define TERRATACT_KERNEL_VECTORS 3
#include "core/learn/kernels/likelihood_kernels.inl"
