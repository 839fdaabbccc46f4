#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/data/side_features.h"
#include "core/learn/model/model.h"
#include "core/learn/model/training.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Returns the ceilings at the attitude of training rows: U × 11. features: U × f as in SurfaceData;
/// of sides, the ceilings are those of the own side (sideCeiling). poll: here and below, called
/// every few milliseconds; what it throws is rethrown.
Eigen::MatrixXd bodyCeilings(const Eigen::MatrixXd& features, const RobotModel& robot,
                             const Poll& poll = {});

/// Fills model.clearance except its processes: standardisation, covered bins, empty residuals.
/// ceilings: U × 11 [m], +infinity where the robot does not cover part of a bin. Throws
/// std::invalid_argument if sizes disagree or a feature never varies.
void prepareClearance(SurfaceData& model, const Eigen::MatrixXd& ceilings);

/// Process of a bin in one regime, and the leave-one-out residuals of its training rows.
struct TrainedSurface {
    SurfaceProcess process;
    std::vector<int> rows;
    Eigen::VectorXd residuals;
};

/// Trains a process: hyperparameters from at most options.subset rows (log marginal likelihood),
/// weights from all rows. With fewer than kMinTrainingRows rows, it only has mean and sd. They are
/// of the bin's height (open), or of every covered bin's y (covered). places: place of each
/// training row (placesOf); empty: one row each. Hyperparameters come from the first row of each
/// place, and a residual leaves out every row of its place. kept: the inducing rows are among the
/// first `kept` rows of the model; 0: among all. Weights and residuals always come from all rows.
/// The heights' sd is noise of its row. The residuals are scaled to the variance that they would
/// have with exact heights.
TrainedSurface trainSurface(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const TrainingOptions& options, const Poll& poll = {},
                            const std::vector<int>& places = {}, Eigen::Index kept = 0);

/// Removes all rows but the first `rows`. Processes whose inducing rows are among them stay valid.
void keepRows(SurfaceData& model, Eigen::Index rows);

/// Refits a process for scenes without some features: new weights and residuals with known
/// hyperparameters. The values of these features in the training rows have no effect. known:
/// without length scales if the process has no weights.
TrainedSurface refitSurface(const SurfaceData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const Hyperparameters& known, AbsentFeatures without,
                            const Poll& poll = {}, const std::vector<int>& places = {});

/// Stores a trained bin in the model. Only one thread at a time may call it.
void store(SurfaceData& model, const TrainedSurface& trained, int bin, bool covered);

/// Completes the clearance part once all bins are stored; without: as in ClearanceModel. It
/// computes the scale of novelty, and the bias and sd of a contact as a measurement of its bin.
/// Forces already act through s. A contact therefore counts by what its height z adds to the bin's
/// leave-one-out prediction m. Over the training scenes with an isolated contact, least squares
/// fits
///   h − m = a + b (z − m),   |z − m| ≤ 0.1 m.
/// A measurement with variance Var(h − m) (1 − b) / b has exactly that gain b. The bias is the mean
/// of h − z, not a / b. The residuals already hold the mean of h − m. Var(h − m) is without the
/// mean variance of the true heights. sd is kept within 5 mm … 10 m. It is 10 m, without weight, if
/// contacts add nothing (b ≤ 0).
void finishClearance(SurfaceData& model, const Eigen::MatrixXd& ceilings, const RobotModel& robot,
                     const Poll& poll = {}, AbsentFeatures without = {});

}  // namespace terratact
