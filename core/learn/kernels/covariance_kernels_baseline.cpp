#define TERRATACT_KERNEL_NAMESPACE kernels_baseline
#define TERRATACT_KERNEL_NAME "baseline"
#define TERRATACT_KERNEL_BYTES 16
#define TERRATACT_KERNEL_COLUMNS 4
#define TERRATACT_KERNEL_AHEAD 0
#include "core/learn/kernels/covariance_kernels.inl"
