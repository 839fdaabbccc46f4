#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "core/learn/data/bin_set.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/lazy_processes.h"
#include "core/learn/model/clearance.h"
#include "core/learn/model/training.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Whether the robot is above a bin: its ceiling is finite.
enum class Regime : std::uint8_t { Covered, Open };
inline constexpr std::array kRegimes{Regime::Covered, Regime::Open};

inline Regime regimeOf(double ceiling)
{
    return std::isinf(ceiling) ? Regime::Open : Regime::Covered;
}

/// A scene in a regime that training saw too rarely; says which, in a sentence.
class NotLearnt : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

/// What the conditionals over clearances are trained on, one scene per row.
struct ClearanceTraining {
    Eigen::MatrixXd heights;   ///< U × 11 [m]
    Eigen::MatrixXd ceilings;  ///< U × 11 [m], +infinity where there is none
    Eigen::MatrixXd features;  ///< U × 11, raw, order of featureNames(Paf)
};

/// One bin in one regime.
struct ClearanceRegimeData {
    int rows = 0;             ///< training rows in this regime
    double mean = 0.0;        ///< of y over them
    double sd = 1.0;          ///< likewise; 1 where y does not vary
    Hyperparameters hyper{};  ///< inputs: ten bins, eleven features; no length scales: not trained
    double logLikelihood = 0.0;
};

/// Everything the conditionals p(yᵢ | y_{J∖i}, s) are made of besides the training rows: one Gaussian process
/// per bin and regime, y of core/learn/model/clearance.h.  Input of the i-th: the other bins' y, rear to front, each
/// standardised with mean and sd of that bin in the regime it has in that row or scene; then s.
///   s: the features with log(1 + force / 3 N) for the six forces, standardised.
/// Output: y centred with the mean of (bin, regime).
struct ClearanceConditionalData {
    double offset = kClearanceOffset;        ///< δ it was made with [m]
    Eigen::VectorXd featureMean, featureSd;  ///< 11, of s
    std::array<std::array<ClearanceRegimeData, kRegimes.size()>, kBins> bins{};

    /// Throws std::invalid_argument unless bin is 0 to 10.
    const ClearanceRegimeData& at(int bin, Regime regime) const;
    ClearanceRegimeData& at(int bin, Regime regime);
};

/// At most this many rows, the first ones, go into one Gaussian process.
inline constexpr int kMaxClearanceRows = 1400;

/// The training rows of a model that the conditionals learn from: the first kClearanceScenes.
inline constexpr int kClearanceScenes = 2000;
ClearanceTraining clearanceTraining(const ModelData& model, const RobotModel& robot);

/// The data of the conditionals from a model's hyper-parameters and those rows.
ClearanceConditionalData clearanceConditionalData(const ModelData& model,
                                                  const ClearanceTraining& training);

/// Standardisation; hyper-parameters still unset.
/// Throws std::invalid_argument where sizes disagree, a height or feature is not finite, a ceiling is NaN or
/// −infinity, there are fewer than kMinTrainingRows rows or a feature never varies.
ClearanceConditionalData prepareClearanceConditionals(const ClearanceTraining& training);

/// Maximises the likelihood of one bin in one regime: maximiseLikelihood, σ_f and σ_n up to 10 and 3 in the unit
/// of y.  The seed of the subset is options.seed + 2 bin + regime.
/// Throws std::invalid_argument for fewer than kMinTrainingRows rows in that regime.
TrainedBin trainClearanceConditional(const ClearanceTraining& training,
                                     const ClearanceConditionalData& data, int bin, Regime regime,
                                     const TrainingOptions& options, const Poll& poll = {});

/// The conditionals p(yᵢ | y_{J∖i}, s), ready to predict.  A Gaussian process is factorised when it is first asked
/// for.  Safe to share between threads.
class ClearanceConditionals {
public:
    /// Throws std::invalid_argument as prepareClearanceConditionals, for another offset than kClearanceOffset
    /// and where data and training do not fit each other.
    ClearanceConditionals(ClearanceTraining training, ClearanceConditionalData data);

    const ClearanceConditionalData& data() const { return data_; }

    /// There is a Gaussian process of that bin in that regime.
    bool isTrained(int bin, Regime regime) const;

    /// Of y of one bin in one regime; factorises it at the first call.  Throws std::invalid_argument, a sentence,
    /// unless isTrained: where the regime has fewer than kMinTrainingRows training rows or was not trained.
    /// inducing: predicts through at most so many rows; 0: all.  poll: as BinModels::bin.
    const GaussianProcess& gp(int bin, Regime regime, int inducing = 0,
                              const Poll& poll = {}) const;

    /// The bins whose Gaussian process in that regime has been asked for, and so factorised.
    BinSet factorised(Regime regime) const
    {
        return factorised_[static_cast<std::size_t>(regime)].load();
    }

    /// Standardised input of bin i: the ten other bins, then s.
    ///   y: states of all bins, that of i is not read; ceiling: [m]; s: 11 raw features, order of
    ///   featureNames(Paf).
    Eigen::VectorXd input(int i, const Heights& y, const Heights& ceiling,
                          const Eigen::VectorXd& s) const;

private:
    ClearanceTraining training_;
    ClearanceConditionalData data_;
    mutable std::array<std::array<LazyProcesses, kRegimes.size()>, kBins> lazy_;
    mutable std::array<std::atomic<unsigned long>, kRegimes.size()> factorised_{};
};

}  // namespace terratact
