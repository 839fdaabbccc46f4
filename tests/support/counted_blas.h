#pragma once

namespace terratact {

/// Work of the BLAS so far in all threads, for a program linked with counted_blas.cpp.
struct BlasWork {
    double multiplications = 0.0;
    double read = 0.0;  ///< matrix entries
};
BlasWork blasWork();

}  // namespace terratact
