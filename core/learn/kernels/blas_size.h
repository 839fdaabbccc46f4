#pragma once

#include <Eigen/Core>

namespace terratact {

/// A size as BLAS and LAPACK take it.
inline int blasSize(Eigen::Index n)
{
    return static_cast<int>(n);
}

}  // namespace terratact
