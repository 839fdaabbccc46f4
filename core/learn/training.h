#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/learn/model.h"
#include "core/learn/scene.h"

namespace terratact {

/// All eleven heights and all features of s are known.
bool isComplete(const Scene& scene);

/// Training rows of a model: heights, features and their standardisation, hyper-parameters still unset.
/// Scenes that lack a height or a feature are left out; `used` counts the rest.
/// Throws std::invalid_argument when fewer than 30 complete scenes are left or an input never varies.
struct TrainingSet {
    ModelData model;
    int used = 0;
    int leftOut = 0;
};
TrainingSet prepareTraining(const std::vector<Scene>& scenes);

/// Effort of one optimisation.
struct TrainingOptions {
    int subset = 400;            ///< rows of the first, cheap search
    int subsetEvaluations = 80;  ///< likelihood evaluations on the subset
    int fullEvaluations = 30;    ///< and on all rows, from where that ended
    std::uint64_t seed = 1;      ///< draws the subset
};

struct TrainedBin {
    Hyperparameters hyper;
    double logLikelihood = 0.0;  ///< log p(y | X) on all rows
};

/// Maximises the log marginal likelihood log p(y | X) over log ℓ, log σ_f, log σ_n with L-BFGS (NLopt) and
/// analytic gradients, first on a subset of the rows, then on all.  Bounds: ℓ 0.05 … 1000 (standardised),
/// σ_f 1 mm … 10 m, σ_n 0.5 mm … 0.5 m.
///
/// X: U × d standardised inputs; y: U outputs [m], centred; outputSd: of y [m], where the search begins.
/// cancelled: polled at every evaluation; when true the best so far is returned.
/// Same data and seed: the same result on one machine.
TrainedBin trainProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y, double outputSd,
                        const TrainingOptions& options,
                        const std::function<bool()>& cancelled = {});

/// The same of p(hᵢ | h_{J∖i}, s); the subset is drawn with options.seed + bin.
TrainedBin trainBin(const ModelData& model, FeatureSet set, int bin, const TrainingOptions& options,
                    const std::function<bool()>& cancelled = {});

}  // namespace terratact
