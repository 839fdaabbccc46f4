#pragma once

#include <Eigen/Core>
#include <bitset>
#include <vector>

#include "core/robot/two_tracks.h"

namespace terratact {

/// Number of features of one side of a robot with two tracks. "Own" is that side:
///   pitch; roll, own side up positive;
///   own front, own rear, other front and other rear flipper angle;
///   own front, own rear, other front and other rear current;
///   own forces 1 … 6; other forces 1 … 6
/// One set of processes serves both sides: a mirrored robot on mirrored ground reads the same
/// features.
inline constexpr std::size_t kSideFeatures = 22;
inline constexpr std::size_t kFirstSideCurrent = 6, kFirstSideForce = 10;

/// Features of s that do not count: bit d is feature d of one plane (kFeatures) or of a side.
using AbsentFeatures = std::bitset<kSideFeatures>;
inline AbsentFeatures absentFeatures(const MissingFeatures& missing)
{
    return {missing.to_ullong()};
}

/// Returns the features of one side, 0 where a current or force was not measured.
Eigen::VectorXd sideFeatures(const TwoTrackReadings& s, Side own);

/// Returns the features of that side that were not measured.
AbsentFeatures absentFeatures(const TwoTrackReadings& s, Side own);

/// Returns readings whose left side has these features; the other side is the right one.
TwoTrackReadings readingsOf(const Eigen::VectorXd& sideFeatures);

/// Returns the feature that has the place of d when own and other side are exchanged.
std::size_t otherSideFeature(std::size_t d);

}  // namespace terratact
