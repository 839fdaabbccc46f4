#pragma once

#include <string>
#include <vector>

#include "app/modelling/evaluation/two_track_evaluation.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Returns estimates of both sides as CSV, one row per scene, side and bin:
///   run,t_s,side,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,touch,truth_m,one_plane,
///   novelty,p_step,side_verdict,p_either,cross_slope_rad,p_slope,verdict,text
/// p_step: probability of a step ahead on this side; p_either: on either side, from joint draws;
/// cross_slope_rad, p_slope: CrossSlope::steepest and beyond; verdict: TwoTrackVerdict::both; text: as
/// describe() of the verdict. An empty field means no estimate, no ceiling, or unknown truth. Throws
/// std::invalid_argument unless scenes and estimates have the same size.
std::string twoTrackCsv(const std::vector<TwoTrackScene>& scenes, const RobotModel& robot,
                        const TrackEstimates& estimates);

}  // namespace terratact
