#pragma once

#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/gaussian_mixture.h"
#include "core/learn/model/clearance_model.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Share of a local sample's variance that smooths it: every residual is the centre of a Gaussian with
/// κ² times the sample's covariance, and the centres move towards their mean by √(1 − κ²), which keeps mean
/// and covariance.  Source: West, J. R. Stat. Soc. B 55 (1993).
inline constexpr double kSmoothing = 0.25;  ///< κ

/// Distribution of the surface coordinates of all bins given s, before any contact or probe.
///   Joint  one Gaussian: the processes' means, the covariance of their leave-one-out residuals
///   Local  the means plus the residuals of the training scenes most like this one, smoothed
/// Throws std::invalid_argument for another method.
GaussianMixture surfaceDistribution(const ClearanceModel& model, const Eigen::VectorXd& features,
                                    unsigned covered, Method method);

/// Estimates one scene without a chain: contacts, with the model's bias and sd, and arm readings are
/// measurements (measured_bins.h), weak heights too, conditioned exactly in the surface coordinate y (core/learn/model/clearance.h).
/// Their error there is the change of y when the ground lies one sd lower.  A measurement more than two standard
/// deviations from every component makes one Gaussian of the mixture first.
/// poll: at the start and while draws are made.
/// height is the median; settings.draws joint draws, of which kEnoughDraws are enough where settings.stopEarly; rhat is
/// 1 and ess the number of draws.
/// Throws std::invalid_argument for another method than Joint and Local, settings out of range, an s that
/// lacks a feature other than those of model.without(), or a model that gives no finite estimate.
TerrainEstimate reconstructClosedForm(const Proprioception& s, std::span<const ArmReading> arm,
                                      const RobotModel& robot, const ClearanceModel& model,
                                      const Settings& settings, const WeakHeights& weak = {},
                                      const Poll& poll = {});

}  // namespace terratact
