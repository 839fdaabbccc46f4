#pragma once

#include <array>

#include "core/strip/dead_reckoning.h"

namespace terratact {

/// Covariance of a position error (e_x, e_z) [m²].
struct PoseCovariance {
    double xx = 0.0, xz = 0.0, zz = 0.0;
    bool operator==(const PoseCovariance&) const = default;
};

inline PoseCovariance operator+(const PoseCovariance& a, const PoseCovariance& b)
{
    return {a.xx + b.xx, a.xz + b.xz, a.zz + b.zz};
}
inline PoseCovariance operator-(const PoseCovariance& a, const PoseCovariance& b)
{
    return {a.xx - b.xx, a.xz - b.xz, a.zz - b.zz};
}

/// Returns the covariance that a motion adds: slip, which is fully correlated, and the height's own error.
PoseCovariance covarianceOf(const ImuMotion& motion);

/// Returns the sd of a height on ground of one of these slopes g, the larger one [m]:
///   w² = g² xx − 2 g xz + zz
double heightSd(const PoseCovariance& covariance, const std::array<double, 2>& slopes);

}  // namespace terratact
