#include "core/strip/pose_covariance.h"

#include <algorithm>
#include <cmath>

namespace terratact {

PoseCovariance covarianceOf(const ImuMotion& motion)
{
    return {motion.slipForward * motion.slipForward, motion.slipForward * motion.slipUp,
            motion.slipUp * motion.slipUp + motion.upSd * motion.upSd};
}

double heightSd(const PoseCovariance& covariance, const std::array<double, 2>& slopes)
{
    double worst = 0.0;
    for (const double g : slopes)
        worst = std::max(worst, g * g * covariance.xx - 2.0 * g * covariance.xz + covariance.zz);
    return std::sqrt(worst);
}

}  // namespace terratact
