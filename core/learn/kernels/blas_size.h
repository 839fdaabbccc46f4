#pragma once

#include <Eigen/Core>

namespace terratact {

/// Returns a size in the type of BLAS and LAPACK.
inline int blasSize(Eigen::Index n)
{
    return static_cast<int>(n);
}

}  // namespace terratact
