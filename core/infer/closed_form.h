#pragma once

#include <optional>
#include <span>

#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/gaussian_mixture.h"
#include "core/learn/model/clearance_model.h"
#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Bias and sd of a contact as a measurement of its bin [m] (core/learn/model/clearance_training.h).
struct ContactError {
    double bias = 0.0, sd = 0.0;
};
inline ContactError contactErrorOf(const ClearanceModel& model)
{
    return {model.contactBias(), model.contactSd()};
}

/// Smoothing share κ of a local sample. Every residual is the centre of a Gaussian with κ² times
/// the sample's covariance. The centres move towards their mean by √(1 − κ²), which keeps mean and
/// covariance.
/// Source: West, J. R. Stat. Soc. B 55 (1993).
inline constexpr double kSmoothing = 0.25;  ///< κ

/// Returns the distribution of the surface coordinates of all bins given s, before any contact or
/// probe.
///   Joint  one Gaussian: the processes' means, the covariance of their leave-one-out residuals
///   Local  the means plus the residuals of the most similar training scenes, smoothed
/// Throws std::invalid_argument for another method.
GaussianMixture surfaceDistribution(const ClearanceModel& model, const Eigen::VectorXd& features,
                                    unsigned covered, Method method);

/// What earlier scenes felt and measured of one plane's bins.
struct EarlierTouch {
    FeltCells felt{};                                        ///< see addRemembered()
    std::array<std::optional<MeasuredHeight>, kBins> arm{};  ///< conditions bins without a reading
};

/// What a closed form predicts of a scene, before any contact or probe.
struct SurfacePrediction {
    GaussianMixture distribution;         ///< of the surface coordinates
    std::optional<ContactError> contact;  ///< empty: contacts act through the inputs alone
    double novelty = 0.0;                 ///< ClearanceModel::novelty()
    EarlierTouch earlier{};               ///< what earlier scenes felt and measured
};

/// Returns the bins that the robot covers in the pose of one plane.
unsigned coveredAt(const RobotModel& robot, const Proprioception& s);

/// Estimates one scene from its prediction, as reconstructClosedForm() does.
TerrainEstimate estimateFrom(SurfacePrediction prediction, const Proprioception& s,
                             std::span<const ArmReading> arm, const RobotModel& robot,
                             const Settings& settings, const Poll& poll = {});

/// Estimates one scene in closed form, without a Markov chain. Contacts (with the model's bias and
/// sd) and arm readings are measurements (measured_bins.h). Each conditions the mixture exactly in
/// the surface coordinate y (core/learn/model/clearance.h). Its error in y is the change of y when
/// the ground lies one sd lower. If a measurement is more than two standard deviations from every
/// component, the mixture first becomes one Gaussian. earlier: as in SurfacePrediction. poll: called
/// at the start and while draws are made. TerrainEstimate::height is the median. There are
/// settings.draws joint draws, at most kEnoughDraws with settings.stopEarly. rhat is 1 and ess is the
/// number of draws. Throws std::invalid_argument for a method other than Joint and Local, and for
/// settings out of range. It also throws if s lacks a feature that model.without() does not name, or
/// if the estimate is not finite.
TerrainEstimate reconstructClosedForm(const Proprioception& s, std::span<const ArmReading> arm,
                                      const RobotModel& robot, const ClearanceModel& model,
                                      const Settings& settings, const Poll& poll = {},
                                      const EarlierTouch& earlier = {});

}  // namespace terratact
