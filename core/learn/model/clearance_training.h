#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/model/model.h"
#include "core/learn/model/training.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Ceilings at the pitch and flipper angles of training rows: U × 11.  features: U × 11 as in ModelData.
/// poll: here and below, every few milliseconds; what it throws comes out.
Eigen::MatrixXd bodyCeilings(const Eigen::MatrixXd& features, const RobotModel& robot,
                             const Poll& poll = {});

/// Fills model.clearance up to its processes: standardisation, covered bins, empty residuals.
/// ceilings: U × 11 [m], +infinity where nothing of the robot is above part of a bin.
/// Throws std::invalid_argument where sizes disagree or a feature never varies.
void prepareClearance(ModelData& model, const Eigen::MatrixXd& ceilings);

/// A bin in one regime: its process, and the leave-one-out residuals of the rows it learnt from.
struct TrainedSurface {
    SurfaceProcess process;
    std::vector<int> rows;
    Eigen::VectorXd residuals;
};

/// Hyper-parameters from at most options.subset rows (log marginal likelihood), the weights from all.
/// With fewer than kMinTrainingRows rows: mean and sd of the bin's height (open) or of every covered bin's y (covered).
TrainedSurface trainSurface(const ModelData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const TrainingOptions& options, const Poll& poll = {});

/// The same for scenes without some features, whatever their value in the training rows: weights and residuals anew,
/// with hyper-parameters that are known.  known: without length scales where the process has no weights.
TrainedSurface refitSurface(const ModelData& model, const Eigen::MatrixXd& ceilings, int bin,
                            bool covered, const Hyperparameters& known, MissingFeatures without,
                            const Poll& poll = {});

/// Puts a trained bin into the model.  Not safe to call from several threads at once.
void store(ModelData& model, const TrainedSurface& trained, int bin, bool covered);

/// To be called once all are stored.  without: as ClearanceModel's.  Finds the scale of novelty, and the bias and sd with which a contact counts
/// as a measurement of its bin.  Forces speak through s already, so what counts is what a contact's height z
/// adds to the leave-one-out prediction m of the bin: over the training scenes with an isolated contact,
///   h − m = a + b (z − m)   by least squares, |z − m| ≤ 0.1 m,
/// and a measurement of z + a / b with variance Var(h − m) (1 − b) / b has just that gain b.
/// sd is kept within 5 mm … 10 m: 10 m, no weight at all, where contacts add nothing (b ≤ 0).
void finishClearance(ModelData& model, const Eigen::MatrixXd& ceilings, const RobotModel& robot,
                     const Poll& poll = {}, MissingFeatures without = {});

}  // namespace terratact
