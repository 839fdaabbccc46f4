#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/infer/closed_form.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/sampling/gaussian_mixture.h"
#include "core/learn/model/clearance_model.h"
#include "core/robot/two_tracks.h"

namespace terratact {

/// Arm readings of both sides: left, right.
using SideArms = std::array<std::span<const ArmReading>, 2>;

/// Models of both sides: left, right. They are one model if both sides have all sensors, or lack the
/// same sensors. Otherwise each model lacks its side's absent features (absentFeatures).
struct SideModels {
    const ClearanceModel& left;
    const ClearanceModel& right;
};

/// Returns contacts and arm readings of one side, by measureBins() in the plane of its flippers
/// (core/robot/side_plane.h). A contact counts in bins of the flippers' line only. ceiling: of the side.
MeasuredBins measuredOnSide(Side side, const TwoTrackReadings& s, std::span<const ArmReading> arm,
                            const RobotModel& robot, const Heights& ceiling,
                            const Settings& settings);

/// Returns the distribution of the surface coordinates of both sides, left above right: 22
/// coordinates. It is surfaceDistribution() with the residuals of both sides together, because
/// their errors correlate. covered: bins of both sides. Throws std::invalid_argument for a method
/// other than Joint and Local.
GaussianMixture sideDistribution(const SideModels& models, const TwoTrackReadings& s,
                                 const ClearanceModel::SideBins& covered, Method method);

/// Prediction of a closed form for both sides of a scene, before any contact or probe.
struct SidesPrediction {
    GaussianMixture distribution;  ///< of the surface coordinates, left above right
    std::array<std::optional<ContactError>, 2> contact;  ///< as in SurfacePrediction
    double novelty = 0.0;
    std::array<EarlierTouch, 2> earlier{};  ///< as in SurfacePrediction
};

/// Returns the bins that the robot covers on each side.
ClearanceModel::SideBins coveredOnSides(const RobotModel& robot, const TwoTrackReadings& s);

/// Estimates both sides from their prediction, as reconstructBothSides() does.
TwoTrackEstimate estimateFrom(SidesPrediction prediction, const TwoTrackReadings& s,
                              const SideArms& arms, const RobotModel& robot,
                              const Settings& settings, const Poll& poll = {});

/// Estimates both sides of one scene in closed form, as reconstructClosedForm() does for one plane.
/// Ceilings, contacts, felt bins and arm readings are those of each side's plane
/// (core/robot/side_plane.h). A contact counts in bins of the flippers' line only. A measurement on
/// one side also moves the other side, as far as their errors correlate. earlier: of the left and the
/// right side. Throws std::invalid_argument as reconstructClosedForm().
TwoTrackEstimate reconstructBothSides(const TwoTrackReadings& s, const SideArms& arms,
                                      const RobotModel& robot, const SideModels& models,
                                      const Settings& settings, const Poll& poll = {},
                                      const std::array<EarlierTouch, 2>& earlier = {});

}  // namespace terratact
