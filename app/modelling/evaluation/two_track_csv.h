#pragma once

#include <span>
#include <string>

#include "app/modelling/evaluation/two_track_evaluation.h"
#include "core/learn/data/two_track_scene.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Header and rows of a CSV with the estimates of both sides, one row per scene, side and bin:
///   run,t_s,side,bin_m,height_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,touch,truth_m,one_plane,
///   novelty,p_step,side_verdict,p_either,cross_slope_rad,p_slope,verdict,text
/// p_step: probability of a step ahead on this side; p_either: on either side, from joint draws;
/// cross_slope_rad, p_slope: CrossSlope::steepest and beyond; verdict: TwoTrackVerdict::both; text: as
/// describe() of the verdict. An empty field means no estimate, no ceiling, or unknown truth. The rows throw
/// std::invalid_argument unless scenes and estimates have the same size.
std::string twoTrackCsvHeader();
std::string twoTrackCsvRows(std::span<const TwoTrackScene> scenes, const RobotModel& robot,
                            const TrackEstimates& estimates);

}  // namespace terratact
