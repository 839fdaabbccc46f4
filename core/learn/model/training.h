#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/data/scene.h"
#include "core/learn/model/model.h"

namespace terratact {

/// A Gaussian process is not trained on fewer rows.
inline constexpr int kMinTrainingRows = 30;

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
/// Scenes that lack a height or a feature are left out, then copies (scene_copies.h); `used` counts the rest.
/// Throws std::invalid_argument when fewer than 30 complete scenes are left or an input never varies.
struct TrainingSet {
    ModelData model;
    int used = 0;
    int leftOut = 0;                       ///< incomplete
    int exactCopies = 0;                   ///< left out
    int nearCopies = 0;                    ///< left out
    std::set<std::string> runsWithCopies;  ///< of the near ones
};
TrainingSet prepareTraining(const std::vector<Scene>& scenes, const RowOptions& options = {});

/// Effort of one optimisation.
struct TrainingOptions {
    int subset = 400;            ///< rows of the first, cheap search
    int subsetEvaluations = 80;  ///< likelihood evaluations on the subset
    int fullEvaluations = 30;    ///< and on all rows, from where that ended
    int fullRows = 0;            ///< on so many of them at most; 0: all
    std::uint64_t seed = 1;      ///< draws the subsets
};

/// fullRows for a process that predicts through inducing rows.  A search on more finds shorter length scales, which want
/// more inducing rows in turn.
inline constexpr int kRowsOfSparseSearch = 1400;

struct TrainedBin {
    Hyperparameters hyper;
    double logLikelihood = 0.0;  ///< log p(y | X) on the rows of the last search
};

/// Box of a search, in the unit of the output; length scales 0.05 … 1000 (standardised inputs).
struct SearchBounds {
    double leastSignal = 1e-3, mostSignal = 10.0;  ///< σ_f
    double leastNoise = 5e-4, mostNoise = 0.5;     ///< σ_n
};

/// Where a search starts: θ = log ℓ_1 … log ℓ_d = ½ log d, log σ_f = log outputSd, log σ_n = log 0.2 outputSd.
Eigen::VectorXd searchStart(Eigen::Index d, double outputSd);

/// Maximises log p(y | X) over θ = (log ℓ, log σ_f, log σ_n) with L-BFGS (NLopt) and analytic gradients, first
/// on options.subset rows, then, where options.fullEvaluations > 0, on all of them or options.fullRows.
///   X: U × d, standardised; y: U, centred; start: d + 2, moved into the bounds.
/// poll: every few milliseconds; what it throws comes out.
/// Same data and seed: the same result on one machine.
TrainedBin maximiseLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                              const Eigen::VectorXd& start, const TrainingOptions& options,
                              const SearchBounds& bounds = {}, const Poll& poll = {});

/// The same for p(hᵢ | h_{J∖i}, s): outputs in metres within the default bounds.
TrainedBin trainBin(const ModelData& model, FeatureSet set, int bin, const TrainingOptions& options,
                    const Poll& poll = {});

}  // namespace terratact
