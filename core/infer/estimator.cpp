#include "core/infer/estimator.h"

#include "core/infer/closed_form.h"
#include "core/infer/reconstruct.h"

namespace terratact {

TerrainEstimate estimateTerrain(const Proprioception& s, std::span<const ArmReading> arm,
                                const RobotModel& robot, const Models& models,
                                const Settings& settings, const Watch& watch)
{
    if (isClosedForm(settings.method))
        return reconstructClosedForm(s, arm, robot, models.clearance, settings);
    return reconstruct(s, arm, robot, usesForces(settings.method) ? models.paf : models.pa,
                       settings, watch);
}

}  // namespace terratact
