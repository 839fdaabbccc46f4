#pragma once

#include "core/infer/estimator.h"
#include "core/infer/two_track_form.h"

namespace terratact {

/// Estimates both sides of one scene by settings.method, Joint or Local. A symmetric scene without
/// readings of the arm is estimated as one plane, from both sides' means. Symmetric means within the
/// sensors' noise (isSymmetric(), core/robot/side_plane.h). Otherwise models.sides estimates it.
/// TwoTrackEstimate::onePlane holds which. Any current or force may be missing, of one side or
/// both. The processes are then trained without it (reduced_clearances.h), and the bands widen.
/// Throws RefusedInput if the model has no two-track part and the scene needs it. It refuses a
/// differential that has turned, too: features describe a locked one. Throws std::invalid_argument
/// for another method and for settings out of range. Throws Cancelled.
TwoTrackEstimate estimateTwoTracks(const TwoTrackReadings& s, const SideArms& arms,
                                   const RobotModel& robot, const Models& models,
                                   const Settings& settings, const Watch& watch = {});

/// Returns true if the line holds both sides: every known mean of a force has a known side.
/// Sessions of versions 1 to 3, files of scenes and some sources have means only.
bool hasSides(const Measurement& line);

/// Returns true if this method may estimate both sides of such a line by estimateMeasured(), with a
/// two-track model. That takes hasSides(), a method Joint, Local or Clearance, and a differential
/// that has not turned. Clearance estimates each side for itself (each_side.h). The paper's four gain
/// little by that (docs/two_tracks.md), and stay with one plane.
bool allowsBothSides(const Measurement& line, Method method);

/// Estimates a line of telemetry. Both sides are estimated on three conditions. The model has a part
/// of two tracks, allowsBothSides() holds, and the scene is not symmetric within its sensors' noise. A
/// reading of the arm on a side makes a symmetric scene one of both sides. Otherwise it is estimated
/// as one plane by estimateTerrain() with warnIfNotPlanar(); sides do not count there. Forces and
/// currents that one side alone has count for both, with a warning that names the side without them.
/// They do not make the sides differ. A scene of different sides that only its method or its
/// differential makes one plane gets a warning. Both sides ignore a reading in the middle, which is of
/// neither line, with a warning. Throws like estimateTerrain().
TwoTrackEstimate estimateMeasured(const Measurement& line, std::span<const ArmReading> readings,
                                  const RobotModel& robot, const Models& models,
                                  const Settings& settings, const Watch& watch = {},
                                  const TrailHistory* history = nullptr);

/// Estimates both sides by models.sides, or by models.trail with a history, whatever the symmetry.
/// The history acts as in estimateTerrain().
/// Throws as estimateTwoTracks().
TwoTrackEstimate estimateByBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                     const RobotModel& robot, const Models& models,
                                     const Settings& settings, const Watch& watch = {},
                                     const TrailHistory* history = nullptr);

/// Estimates both sides as one plane from the means of both sides' readings, by any method.
TwoTrackEstimate estimateAsOnePlane(const TwoTrackReadings& s, const RobotModel& robot,
                                    const Models& models, const Settings& settings,
                                    const Watch& watch = {});

}  // namespace terratact
