#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/base/poll.h"
#include "core/learn/data/scene.h"
#include "core/learn/model/model.h"

namespace terratact {

/// Least number of rows to train a Gaussian process.
inline constexpr int kMinTrainingRows = 30;

/// Returns true if all eleven heights and all features of s are known.
bool isComplete(const Scene& scene);

/// Training rows of the conditionals, and the scanner noise of their heights. Exact heights make
/// the conditionals overconfident: σ_n falls to its bound, and chains stay where they start.
struct RowOptions {
    int conditionalRows = 1400;  ///< the first rows; the paper's number
    double scannerSd = 0.0;      ///< sd of the noise that is added to their heights [m]
    std::uint64_t seed = 1;      ///< seed of that noise
};

/// Training rows of a model: heights, features and their standardisation; hyperparameters are
/// still unset. Scenes that lack a feature or every height are left out, and then exact copies
/// (scene_copies.h); `used` counts the rest. The first scenes of all places come first, those with
/// all heights before those with some, then the near copies. The conditionals learn from complete
/// first scenes only. Throws std::invalid_argument if fewer than 30 of these are left, or if an
/// input never varies. heightSd has rows if a scene states the sd of a height.
struct TrainingSet {
    ModelData model;
    int used = 0;
    int leftOut = 0;                       ///< scenes that were left out for unknown values
    int withHoles = 0;                     ///< those of `used` with unknown heights
    int exactCopies = 0;                   ///< exact copies that were left out
    int nearCopies = 0;                    ///< near copies: the last rows of `used`
    std::set<std::string> runsWithCopies;  ///< drives of the near copies
};
TrainingSet prepareTraining(const std::vector<Scene>& scenes, const RowOptions& options = {});

/// Effort of one optimisation.
struct TrainingOptions {
    int subset = 400;            ///< rows of the first, cheap search
    int subsetEvaluations = 80;  ///< likelihood evaluations on the subset
    int fullEvaluations = 30;    ///< likelihood evaluations on all rows, starting from its result
    int fullRows = 0;            ///< largest number of rows of the second search; 0: all
    std::uint64_t seed = 1;      ///< decides the subsets
};

/// fullRows for a process that predicts through inducing rows. More rows would lead to shorter
/// length scales, which would need more inducing rows.
inline constexpr int kRowsOfSparseSearch = 1400;

struct TrainedBin {
    Hyperparameters hyper;
    double logLikelihood = 0.0;  ///< log p(y | X) on the rows of the last search
};

/// Bounds of a search, in the unit of the output; length scales 0.05 … 1000 (standardised inputs).
struct SearchBounds {
    double leastSignal = 1e-3, mostSignal = 10.0;  ///< σ_f
    double leastNoise = 5e-4, mostNoise = 0.5;     ///< σ_n
};

/// Returns the heights' variances of a bin in the first rows; empty if heights are exact.
Eigen::VectorXd heightVariance(const SurfaceData& data, int bin, Eigen::Index rows);

/// Returns the start of a search: θ = log ℓ_1 … log ℓ_d = ½ log d, log σ_f = log outputSd, log σ_n
/// = log 0.2 outputSd.
Eigen::VectorXd searchStart(Eigen::Index d, double outputSd);

/// Maximises log p(y | X) over θ = (log ℓ, log σ_f, log σ_n) with L-BFGS (NLopt) and analytic
/// gradients. It first uses options.subset rows. If options.fullEvaluations > 0, it then uses all
/// rows, or options.fullRows.
///   X: U × d, standardised; y: U, centred; start: d + 2, moved into the bounds.
/// poll: called every few milliseconds; what it throws is rethrown. The same data and seed give the
/// same result on one machine. rowVariance: variance of each output besides σ_n² (GaussianProcess).
TrainedBin maximiseLikelihood(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                              const Eigen::VectorXd& start, const TrainingOptions& options,
                              const SearchBounds& bounds = {}, const Poll& poll = {},
                              const Eigen::VectorXd& rowVariance = {});

/// Trains p(hᵢ | h_{J∖i}, s) in the same way: outputs in metres, default bounds, the heights' sd as noise per row.
TrainedBin trainBin(const ModelData& model, FeatureSet set, int bin, const TrainingOptions& options,
                    const Poll& poll = {});

}  // namespace terratact
