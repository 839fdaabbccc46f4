#pragma once

namespace terratact {

/// What a program that is linked with counted_blas.cpp has asked of the BLAS so far, in any thread.
struct BlasWork {
    double multiplications = 0.0;
    double read = 0.0;  ///< entries of matrices
};
BlasWork blasWork();

}  // namespace terratact
