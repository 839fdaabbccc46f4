#define TERRATACT_KERNEL_NAMESPACE kernels_avx512
#define TERRATACT_KERNEL_NAME "AVX-512"
#define TERRATACT_KERNEL_BYTES 64
#define TERRATACT_KERNEL_COLUMNS 8
#define TERRATACT_KERNEL_AHEAD 24
#include "core/learn/kernels/covariance_kernels.inl"
