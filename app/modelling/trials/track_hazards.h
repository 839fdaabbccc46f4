#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/modelling/trials/hazard_trials.h"
#include "app/modelling/trials/verdict_counts.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/learn/data/two_track_scene.h"

namespace terratact {

/// One row of the result of two tracks.
struct TrackHazardLine {
    std::string ground;  ///< name of kHazardGrounds
    std::string hazard;  ///< "none", or name of the hazard, with ", one side" or ", both sides"
    PressStyle style = PressStyle::Random;
    /// The robot's answer (TwoTrackVerdict::both). A step counts on either side. CLEAR is false if
    /// a side has a true step before its own horizon. Ground is flat if both sides are flat. Bands
    /// are those of both sides.
    VerdictCounts robot;
    VerdictCounts sides;  ///< both sides' own answers, each by its own ground: two a scene
};

/// Counts one scene whose truth is known. stepLimit: [m].
void countScene(const TwoTrackScene& scene, const RobotModel& robot,
                const TwoTrackEstimate& estimate, double stepLimit, TrackHazardLine& line);

/// Drives the simulated robot with two tracks as tryHazards() does, with hazards on one side and on
/// both. Estimates and judges both sides. Of trial.rates, the last one is used. Throws RefusedInput
/// if the model has no two tracks.
std::vector<TrackHazardLine> tryTrackHazards(const EstimatorBundle& bundle,
                                             const HazardTrial& trial);

/// Returns a table for the terminal: rows by ground and hazard for the robot, then totals for the robot and the sides.
std::string trackHazardTable(std::span<const TrackHazardLine> lines);

}  // namespace terratact
