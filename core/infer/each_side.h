#pragma once

#include "core/infer/estimator.h"
#include "core/infer/two_track_form.h"

namespace terratact {

/// Estimates each side for itself by the model of one plane, by any method: the side's readings
/// (sideReadings) stand for those of the plane, and its ground lies
///   y sin φ,   y: of the bin's line (core/terrain/ground_lines.h), left positive; φ: roll
/// higher. Errors of both sides count as independent: the right side uses settings.seed + 1. Chains of
/// one side may end before those of the other: the surplus draws of that side are dropped. The
/// sampling methods have no other way to distinguish left and right, because their processes have learnt one
/// plane. An arm's reading counts on its side. Throws as estimateTerrain().
TwoTrackEstimate estimateEachSide(const TwoTrackReadings& s, const SideArms& arms,
                                  const RobotModel& robot, const Models& models,
                                  const Settings& settings, const Watch& watch = {});

}  // namespace terratact
