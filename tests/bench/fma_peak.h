#pragma once

#include <string_view>

namespace terratact {

/// Multiply-adds that nothing waits for, in one instruction set: what a processor can do at best.
/// Both take a number of rounds and return how many floating-point operations they have done.
struct FmaPeak {
    double (*single)(int rounds);
    double (*full)(int rounds);
};

/// kernels: name of CovarianceKernels that this processor runs.
const FmaPeak& fmaPeak(std::string_view kernels);

}  // namespace terratact
