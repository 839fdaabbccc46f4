// This function is defined here and not in core/robot, because only core/terrain defines the bins.
#include <stdexcept>

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"
#include "core/terrain/ground_lines.h"

namespace terratact {

bool RobotModel::armReaches(int bin, ProbeSide side) const
{
    if (bin < 0 || bin >= kBins) throw std::invalid_argument("armReaches: no such bin");
    if (binCentre(bin) < armReachBegin || binCentre(bin) > armReachEnd) return false;
    const double y = bin < kFirstFlipperBin ? lateral.trackY : lateral.flipperY;
    return side == ProbeSide::Middle || y <= armReachY;
}

}  // namespace terratact
