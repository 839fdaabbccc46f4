#pragma once

#include <optional>
#include <vector>

#include "core/infer/closed_form.h"
#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/hazards.h"
#include "core/infer/estimate/measured_bins.h"
#include "core/infer/sampling/gaussian_mixture.h"
#include "core/learn/model/clearance_model.h"

namespace terratact {

// Steps that the closed forms of one plane and of two tracks share. A mixture holds the surface
// coordinates of eleven bins from coordinate `first` on: 0, or kBins for the right side.

/// Throws std::invalid_argument for settings out of range, or a method without a closed form.
void requireClosedForm(const Settings& settings);

/// Returns the means plus the residuals of similar training scenes, smoothed (kSmoothing). mean: one
/// number per row of the residuals.
GaussianMixture smoothed(const Eigen::VectorXd& mean, const ResidualSample& sample);

/// Adds the heights that the arm measured earlier to bins that it did not measure now. A contact
/// stays where the form conditions on contacts, else it gives way. Their origin is Sampled: the
/// present scene did not measure them.
void addEarlierArm(MeasuredBins& measured, const EarlierTouch& earlier, bool usesContacts);

/// Turns bins into Touch::Remembered by addRemembered(). robot: of the plane; s: of the scene there.
void writeRemembered(TerrainEstimate& estimate, const EarlierTouch& earlier,
                     const RobotModel& robot, const Proprioception& s);

/// Conditions the mixture on contacts and arm readings, and writes origins and warnings. The
/// ceilings must be known. contact: error of a contact; empty: contacts act through the inputs alone.
/// Returns the hazards that the arm may have found ahead, now or earlier. A reading that is almost
/// surely a hazard's does not condition the mixture.
std::vector<MeasuredHazard> applyMeasurements(GaussianMixture& distribution, int first,
                                              MeasuredBins measured,
                                              const std::optional<ContactError>& contact,
                                              TerrainEstimate& estimate);

/// Adds a warning if estimate.novelty is above 1.
void warnIfNovel(TerrainEstimate& estimate);

/// Returns the number of joint draws.
int drawsOf(const Settings& settings);

/// Writes mean, sd, quantiles, height, R-hat and ESS of all bins.
void writeBins(const GaussianMixture& distribution, int first, TerrainEstimate& estimate);

/// Returns the heights of one draw of surface coordinates.
Heights heightsOf(const Eigen::VectorXd& y, int first, const Heights& ceiling);

}  // namespace terratact
