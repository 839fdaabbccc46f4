#define TERRATACT_KERNEL_NAMESPACE kernels_baseline
#define TERRATACT_KERNEL_NAME "baseline"
#define TERRATACT_KERNEL_LANES 2
#define TERRATACT_KERNEL_ROWS 2
#define TERRATACT_KERNEL_VECTORS 4
#include "core/learn/covariance_kernels.inl"
