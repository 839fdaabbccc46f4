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

/// Which rows the conditionals learn from, and how well a scanner knows their heights: exact heights make the
/// conditionals overconfident (their σ_n falls to its bound, and chains freeze where they start).
struct RowOptions {
    int conditionalRows = 1400;  ///< the first ones; the paper's number
    double scannerSd = 0.0;      ///< [m] of the noise added to their heights
    std::uint64_t seed = 1;      ///< of that noise
};

/// Training rows of a model: heights, features and their standardisation, hyper-parameters still unset.
/// Scenes that lack a height or a feature are left out; `used` counts the rest.
/// Throws std::invalid_argument when fewer than 30 complete scenes are left or an input never varies.
struct TrainingSet {
    ModelData model;
    int used = 0;
    int leftOut = 0;
};
TrainingSet prepareTraining(const std::vector<Scene>& scenes, const RowOptions& options = {});

/// Effort of one optimisation.
struct TrainingOptions {
    int subset = 400;            ///< rows of the first, cheap search
    int subsetEvaluations = 80;  ///< likelihood evaluations on the subset
    int fullEvaluations = 30;    ///< and on all rows, from where that ended
    double mostNoiseSd = 0.5;    ///< upper bound of σ_n
    std::uint64_t seed = 1;      ///< draws the subset
};

struct TrainedBin {
    Hyperparameters hyper;
    double logLikelihood = 0.0;  ///< log p(y | X) on all rows
};

/// Maximises the log marginal likelihood log p(y | X) over log ℓ, log σ_f, log σ_n with L-BFGS (NLopt) and
/// analytic gradients, first on a subset of the rows, then on all where options.fullEvaluations > 0.
/// X: U × d standardised, y: U centred.  Bounds: ℓ 0.05 … 1000, σ_f 0.001 … 10, σ_n 0.0005 …
/// options.mostNoiseSd.  cancelled: polled at every evaluation; when true the best so far is returned.
/// Same data and seed: the same result on one machine.
TrainedBin trainProcess(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                        const TrainingOptions& options,
                        const std::function<bool()>& cancelled = {});

/// trainProcess() for p(hᵢ | h_{J∖i}, s); the subset is drawn with options.seed + bin.
TrainedBin trainBin(const ModelData& model, FeatureSet set, int bin, const TrainingOptions& options,
                    const std::function<bool()>& cancelled = {});

}  // namespace terratact
