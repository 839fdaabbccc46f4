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

/// Gaussian process at one scene. The fixed inputs are folded into one log weight per training row:
/// a prediction only costs the moving inputs. The process must outlive this object.
class SceneConditional {
public:
    /// x: d standardised inputs. moving: indices of inputs that are given for each prediction.
    /// precision: of the variance, if usable() grants it. The mean is double, and equal in both
    /// except for rounding. poll: as usable(). Throws std::invalid_argument for another size, or a
    /// value of x that is not finite.
    SceneConditional(const GaussianProcess& gp, const Eigen::VectorXd& x, std::vector<int> moving,
                     Precision precision, const Poll& poll = {},
                     const CovarianceKernels& kernels = covarianceKernels());

    /// Predicts for several values of the moving inputs. A column's result does not depend on the
    /// others. inputs: moving.size() × n standardised; mean, variance: n. Throws
    /// std::invalid_argument for an input that is not finite.
    void predict(const Eigen::MatrixXd& inputs, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) const;

private:
    friend void predictTogether(std::span<const ScenePrediction> asked, PredictionRoom& room,
                                const Poll& poll);
    void addRows(const Eigen::VectorXd& x, const std::vector<int>& order);
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
    const double* panels_ = nullptr;  // panels of the precision in use; the other pointer is null
    // panels of the precision in use; the other pointer is null
    const float* panelsSingle_ = nullptr;
};

/// Buffers of predictTogether, kept between calls; one per thread.
struct PredictionRoom {
    template <class T>
    struct Covariances {
        AlignedArray<T> all;    ///< blocks of 8 columns, see CovarianceKernels
        AlignedArray<T> block;  ///< one more block
    };
    Covariances<double> full;
    Covariances<float> single;
    AlignedArray<double> z, means, blockMeans{kGroup}, squares;
};

/// Question of one scene: SceneConditional::predict(inputs, mean, variance).
struct ScenePrediction {
    const SceneConditional* conditional = nullptr;
    const Eigen::MatrixXd* inputs = nullptr;
    Eigen::VectorXd* mean = nullptr;
    Eigen::VectorXd* variance = nullptr;
};

/// Predicts for several scenes, bit for bit like SceneConditional::predict for each. Scenes of one
/// process pass through its factor together, whatever inputs move in each. The factor, which fills
/// the caches, is then read once, and groups of columns are full.
/// Throws as predict, and what the poll throws; some means and variances may then be new and others
/// not.
void predictTogether(std::span<const ScenePrediction> asked, PredictionRoom& room,
                     const Poll& poll = {});

}  // namespace terratact
