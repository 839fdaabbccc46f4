#define TERRATACT_KERNEL_NAMESPACE likelihood_kernels_baseline
#define TERRATACT_KERNEL_NAME "baseline"
#define TERRATACT_KERNEL_LANES 2
#define TERRATACT_KERNEL_ROWS 4
#define TERRATACT_KERNEL_VECTORS 2
#include "core/learn/kernels/likelihood_kernels.inl"
