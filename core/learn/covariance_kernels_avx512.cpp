#define TERRATACT_KERNEL_NAMESPACE kernels_avx512
#define TERRATACT_KERNEL_NAME "AVX-512"
#define TERRATACT_KERNEL_LANES 8
#define TERRATACT_KERNEL_ROWS 8
#define TERRATACT_KERNEL_VECTORS 2
#include "core/learn/covariance_kernels.inl"
