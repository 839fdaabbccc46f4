#pragma once

#include <string_view>

namespace terratact {

/// Independent multiply-adds in one instruction set: the peak rate of a processor. Both functions take a number of
/// rounds and return the number of floating-point operations.
struct FmaPeak {
    double (*single)(int rounds);
    double (*full)(int rounds);
};

/// kernels: name of CovarianceKernels that this processor supports.
const FmaPeak& fmaPeak(std::string_view kernels);

}  // namespace terratact
