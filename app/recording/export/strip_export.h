#pragma once

#include <optional>
#include <string>

#include "core/robot/robot_model.h"
#include "core/strip/strip.h"

namespace terratact {

inline constexpr double kSectionGap = 1.0;  ///< [m] along x, between two sections of a point cloud

/// Returns a strip as CSV, a line for each bin of each side. StripSource::time is written as time_s. Columns:
///   section, start   number from 1, and why it begins (core/strip/strip_section.h)
///   side, one_plane  left or right; 1 if the estimate was of one plane
///   x_m              centre of the bin along the way, from the IMU of the section's first scene
///   plan_x_m, plan_y_m  the same from above, forward and left, on the line of the track or flipper
///   height_m, sd_m, q10_m, q90_m  as certain as when it was felt, z up from that IMU
///   drift_sd_m       sd of the height by the way since the section's begin
///   felt             arm, contact, track, in part, bounded, not felt or not recorded
///   time_s, estimate scene's time and estimate's number
/// A bin that is not felt has its estimated height, too; only `felt` shows the difference. section: the only one to
/// write, from 1; empty: all. Both functions throw std::invalid_argument if there is no such section.
std::string stripCsv(const Strip& strip, const RobotModel& robot, std::optional<int> section = {});

/// Returns how well the strip's 80 % bands held at later touches of their ground (Strip::ledger()).
/// An example is "80 % bands held at later contacts: 41 of 50, passes: 9 of 10". Empty: nothing was
/// touched again.
std::string ledgerText(const StripLedger& ledger);

/// Returns a strip as a point cloud in PLY (ASCII), a vertex for each bin of each side. Properties: x, y, z [m], sd
/// [m], time [s], side (0 left, 1 right), felt (order of FeltBy), section. x is forward, y left, z up from the IMU of
/// the section's first scene. Only the first section written keeps this frame. The strip does not hold the offset
/// between two sections. A later section is therefore moved along x, to begin kSectionGap ahead of the end of the one
/// before. A comment in the file states it. section: as above.
std::string stripPly(const Strip& strip, const RobotModel& robot, std::optional<int> section = {});

}  // namespace terratact
