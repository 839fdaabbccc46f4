#define TERRATACT_KERNEL_NAMESPACE kernels_avx2
#define TERRATACT_KERNEL_NAME "AVX2"
#define TERRATACT_KERNEL_BYTES 32
#define TERRATACT_KERNEL_COLUMNS 4
#define TERRATACT_KERNEL_AHEAD 0
#include "core/learn/kernels/covariance_kernels.inl"
