#pragma once

#include <cstddef>
#include <span>

#include "core/infer/estimator.h"
#include "core/infer/two_track_form.h"

namespace terratact {

/// Return true if the method Trail can estimate a scene. There must be networks that know the covered
/// bins' regimes, and a usable history.
bool remembers(const Models& models, const TrailHistory* history, const RobotModel& robot,
               const Proprioception& s);
bool remembers(const Models& models, const TrailHistory* history, const RobotModel& robot,
               const TwoTrackReadings& s);

/// Estimates one scene by the networks of one plane (core/trail/trail_model.h), otherwise as
/// reconstructClosedForm() by Local. A contact acts through the inputs alone. Throws
/// std::invalid_argument if s lacks a feature.
TerrainEstimate trailEstimate(const Proprioception& s, const TrailHistory& history,
                              std::span<const ArmReading> arm, const RobotModel& robot,
                              const Models& models, const Settings& settings,
                              const Poll& poll = {});

/// Estimates both sides by the networks of both sides, otherwise as reconstructBothSides() by Local.
TwoTrackEstimate trailEstimate(const TwoTrackReadings& s, const TrailHistory& history,
                               const SideArms& arms, const RobotModel& robot, const Models& models,
                               const Settings& settings, const Poll& poll = {});

/// Returns the heights that the arm measured earlier, for an estimate by Local in place of Trail. They
/// need no networks. Ground felt earlier is left out: the networks alone know its height
/// (addRemembered()). plane: of the history. Nothing is returned without a usable history.
EarlierTouch earlierArm(const TrailHistory* history, std::size_t plane);

/// Returns true if an estimate by Local uses a height that the arm measured earlier. The present scene did not measure
/// that bin. earlier: of the estimate.
bool usesEarlierArm(const TerrainEstimate& estimate, const EarlierTouch& earlier);

/// Adds the warning that the networks' memory is not used. earlier: of the estimate.
void warnForgotten(TerrainEstimate& estimate, const EarlierTouch& earlier);
/// Returns true if the estimate has that warning.
bool isForgotten(const TerrainEstimate& estimate);

}  // namespace terratact
