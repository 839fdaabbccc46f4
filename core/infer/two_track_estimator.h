#pragma once

#include "core/infer/estimator.h"
#include "core/infer/two_track_form.h"

namespace terratact {

/// Estimates both sides of one scene by settings.method, Joint or Local. A scene that is symmetric
/// within its sensors' noise (isSymmetric) is estimated as one plane from the means of both sides,
/// unless the arm measured something; TwoTrackEstimate::onePlane tells. Otherwise models.sides
/// estimates it. Any current or force may be missing, of one side or both: the processes are then
/// trained without it (reduced_clearances.h), and the bands widen.
/// Throws RefusedInput if the model has no two-track part and the scene needs it, and for a
/// differential that has turned: features describe a locked one. Throws std::invalid_argument for
/// another method and for settings out of range. Throws Cancelled.
TwoTrackEstimate estimateTwoTracks(const TwoTrackReadings& s, const SideArms& arms,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch = {});

/// Estimates both sides by models.sides, whatever the symmetry. Throws as estimateTwoTracks().
TwoTrackEstimate estimateByBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                     const RobotModel& robot, const Models& models,
                                     const Settings& settings, const Watch& watch = {});

/// Estimates both sides as one plane from the means of both sides' readings, by any method.
TwoTrackEstimate estimateAsOnePlane(const TwoTrackReadings& s, const RobotModel& robot,
                                    const Models& models, const Settings& settings,
                                    const Watch& watch = {});

}  // namespace terratact
