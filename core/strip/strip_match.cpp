#include "core/strip/strip_match.h"

#include <algorithm>
#include <cmath>

namespace terratact {
namespace {

constexpr double kMinPoseVariance = 1e-8;  // [m²] a robot at rest may have moved by 0.1 mm
constexpr int kReweights = 4;

/// Symmetric 2 × 2 matrix.
struct Information {
    double xx, xz, zz;

    PoseCovariance inverse() const
    {
        const double determinant = xx * zz - xz * xz;
        return {zz / determinant, -xz / determinant, xx / determinant};
    }
};

double huberWeight(const MatchedBin& bin, const Vec2& e)
{
    const double apart =
        std::abs(bin.difference - (e.z - bin.slope * e.x)) / std::sqrt(bin.variance);
    return apart <= kHuber ? 1.0 : kHuber / apart;
}

}  // namespace

PoseOffset matched(const PoseCovariance& prior, std::span<const MatchedBin> bins)
{
    const PoseCovariance floored{prior.xx + kMinPoseVariance, prior.xz,
                                 prior.zz + kMinPoseVariance};
    const PoseCovariance inverse = Information{floored.xx, floored.xz, floored.zz}.inverse();
    PoseOffset offset{{}, floored};
    for (int round = 0; round < kReweights; ++round) {
        Information sum{inverse.xx, inverse.xz, inverse.zz};
        Vec2 right;
        for (const MatchedBin& bin : bins) {
            const double weight = huberWeight(bin, offset.mean) / (kCorrelatedBins * bin.variance);
            sum.xx += weight * bin.slope * bin.slope;
            sum.xz -= weight * bin.slope;
            sum.zz += weight;
            right.x -= weight * bin.slope * bin.difference;
            right.z += weight * bin.difference;
        }
        offset.covariance = sum.inverse();
        const PoseCovariance& p = offset.covariance;
        offset.mean = {p.xx * right.x + p.xz * right.z, p.xz * right.x + p.zz * right.z};
    }
    return offset;
}

}  // namespace terratact
