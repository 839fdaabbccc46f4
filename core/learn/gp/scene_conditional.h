#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/learn/gp/gaussian_process.h"
#include "core/learn/kernels/aligned_array.h"
#include "core/learn/kernels/covariance_kernels.h"

namespace terratact {

struct PredictionRoom;
struct ScenePrediction;

/// A Gaussian process at one scene: the inputs that stay fixed are folded into one log weight per
/// training row, so a prediction costs only the inputs that move.  Refers to the process.
class SceneConditional {
public:
    /// x: d standardised input; moving: indices of inputs that will be given anew for each prediction.
    /// precision: of the variance, where usable() grants it; the mean is double in both, and the same but
    /// for rounding.  poll: likewise.
    /// Throws std::invalid_argument for another size or a value of x that is not finite.
    SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x, std::vector<int> moving,
                     Precision precision, const Poll& poll = {},
                     const CovarianceKernels& kernels = covarianceKernels());

    /// Predicts for several settings of the moving inputs at once.  A column's result does not depend on
    /// the others.  inputs: moving.size() × n standardised; mean, variance: n.
    /// Throws std::invalid_argument for an input that is not finite.
    void predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) const;

private:
    friend void predictTogether(std::span<const ScenePrediction> asked, PredictionRoom& room,
                                const Poll& poll);
    void takeRows(const Eigen::VectorXd& x, const std::vector<int>& order);
    bool sharesFactorWith(const SceneConditional& other) const;
    void copyInputs(const Eigen::MatrixXd& inputs, Eigen::Index first, int count, double* z) const;
    template <class T>
    void covariances(const Eigen::MatrixXd& inputs, int first, PredictionRoom& room,
                     const Poll& poll) const;
    template <class T>
    static void pass(std::span<const ScenePrediction> asked, PredictionRoom& room,
                     const Poll& poll);
    void finish(const PredictionRoom& room, int first, Eigen::VectorXd& mean,
                Eigen::VectorXd& variance) const;

    const GaussianProcess& gp_;
    const CovarianceKernels& kernels_;
    std::vector<int> moving_;
    int kept_ = 0;                            // the first rows, which variances need
    AlignedArray<double> X_;                  // U × m, row-major
    AlignedArray<double> perLength_;          // m
    AlignedArray<double> logWeight_, alpha_;  // U
    const double* panels_ = nullptr;       // of the precision that is used; the other one is null
    const float* panelsSingle_ = nullptr;  // likewise
};

/// What predictTogether works in, kept from call to call; one per thread.
struct PredictionRoom {
    template <class T>
    struct Covariances {
        AlignedArray<T> all;    ///< blocks of 8 columns, see CovarianceKernels
        AlignedArray<T> block;  ///< one more
    };
    Covariances<double> full;
    Covariances<float> single;
    AlignedArray<double> z, means, blockMeans{kGroup}, squares;
};

/// What one scene asks: SceneConditional::predict(inputs, mean, variance).
struct ScenePrediction {
    const SceneConditional* conditional = nullptr;
    const Eigen::MatrixXd* inputs = nullptr;
    Eigen::VectorXd* mean = nullptr;
    Eigen::VectorXd* variance = nullptr;
};

/// SceneConditional::predict for every one, bit for bit the same.  The columns of scenes of one process go through
/// its factor side by side, whatever inputs move in each: the factor, which is what fills the caches, is then
/// read once, and groups of columns are full that a scene alone would leave half empty.
/// Throws as predict, and what the poll throws; then some means and variances may be new and others not.
void predictTogether(std::span<const ScenePrediction> asked, PredictionRoom& room,
                     const Poll& poll = {});

}  // namespace terratact
