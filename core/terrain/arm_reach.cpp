// This function is defined here and not in core/robot, because only core/terrain defines the bins.
#include <stdexcept>

#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

bool RobotModel::armReaches(int bin) const
{
    if (bin < 0 || bin >= kBins) throw std::invalid_argument("armReaches: no such bin");
    return binCentre(bin) >= armReachBegin && binCentre(bin) <= armReachEnd;
}

}  // namespace terratact
