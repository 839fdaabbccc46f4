#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "core/base/message.h"
#include "core/learn/data/bin_set.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/lazy_processes.h"
#include "core/learn/model/clearance.h"
#include "core/learn/model/training.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Regime of a bin: Covered if its ceiling is finite (the robot is above it), else Open.
enum class Regime : std::uint8_t { Covered, Open };
inline constexpr std::array kRegimes{Regime::Covered, Regime::Open};

inline Regime regimeOf(double ceiling)
{
    return std::isinf(ceiling) ? Regime::Open : Regime::Covered;
}

/// Thrown for a scene in a regime that training saw too rarely; the sentence names it.
class NotLearnt : public RefusedInput {
public:
    using RefusedInput::RefusedInput;
};

/// Training data of the conditionals over clearances, one scene per row.
struct ClearanceTraining {
    Eigen::MatrixXd heights;   ///< U × 11 [m]
    Eigen::MatrixXd ceilings;  ///< U × 11 [m], +infinity: no ceiling
    Eigen::MatrixXd features;  ///< U × 11, raw, in the order of featureNames(Paf)
    Eigen::MatrixXd heightSd;  ///< U × 11 [m] sd of each height; without rows: heights are exact
};

/// Data of one bin in one regime.
struct ClearanceRegimeData {
    int rows = 0;       ///< training rows in this regime
    double mean = 0.0;  ///< mean of y over these rows
    double sd = 1.0;    ///< sd of y over these rows; 1 if y does not vary
    /// inputs: ten bins, eleven features; without length scales: not trained
    Hyperparameters hyper{};
    double logLikelihood = 0.0;
};

/// Data of the conditionals p(yᵢ | y_{J∖i}, s), besides the training rows. There is one Gaussian
/// process per bin and regime, with y of core/learn/model/clearance.h. The input of the i-th is the
/// other bins' y, rear to front, then s. Each y is standardised with mean and sd of its bin, in its
/// regime in that row or scene.
///   s: the features with log(1 + force / 3 N) for the six forces, standardised.
/// The output is y, centred with the mean of (bin, regime).
struct ClearanceConditionalData {
    double offset = kClearanceOffset;        ///< δ of the training [m]
    Eigen::VectorXd featureMean, featureSd;  ///< 11, for s
    std::array<std::array<ClearanceRegimeData, kRegimes.size()>, kBins> bins{};

    /// Return the data of a bin and regime. Throw std::invalid_argument unless bin is 0 to 10.
    const ClearanceRegimeData& at(int bin, Regime regime) const;
    ClearanceRegimeData& at(int bin, Regime regime);
};

/// Largest number of rows of one Gaussian process; the first rows are used.
inline constexpr int kMaxClearanceRows = 1400;

/// Number of the model's first complete training rows that the conditionals learn from.
inline constexpr int kClearanceScenes = 2000;
ClearanceTraining clearanceTraining(const ModelData& model, const RobotModel& robot);

/// Returns the data of the conditionals from a model's hyperparameters and those rows.
ClearanceConditionalData clearanceConditionalData(const ModelData& model,
                                                  const ClearanceTraining& training);

/// Returns the data with standardisation, but without hyperparameters. Throws
/// std::invalid_argument if sizes disagree, a height or feature is not finite, or a ceiling is NaN
/// or −infinity. It also throws for fewer than kMinTrainingRows rows, and if a feature never
/// varies.
ClearanceConditionalData prepareClearanceConditionals(const ClearanceTraining& training);

/// Trains one bin in one regime with maximiseLikelihood. σ_f and σ_n may reach 10 and 3 in the unit
/// of y. The seed of the subset is options.seed + 2 bin + regime. Throws std::invalid_argument for
/// fewer than kMinTrainingRows rows in that regime.
TrainedBin trainClearanceConditional(const ClearanceTraining& training,
                                     const ClearanceConditionalData& data, int bin, Regime regime,
                                     const TrainingOptions& options, const Poll& poll = {});

/// The conditionals p(yᵢ | y_{J∖i}, s), ready to predict. A Gaussian process is factorised when it
/// is first needed. It may be shared between threads.
class ClearanceConditionals {
public:
    /// Throws std::invalid_argument as prepareClearanceConditionals, for an offset other than
    /// kClearanceOffset, and if data and training do not fit each other.
    ClearanceConditionals(ClearanceTraining training, ClearanceConditionalData data);

    const ClearanceConditionalData& data() const { return data_; }

    /// Returns true if that bin has a Gaussian process in that regime.
    bool isTrained(int bin, Regime regime) const;

    /// Returns the process for y of one bin in one regime; the first call factorises it. Throws
    /// std::invalid_argument with a sentence unless isTrained. inducing: number of rows to predict
    /// through; 0: all. poll: as BinModels::bin.
    const GaussianProcess& gp(int bin, Regime regime, int inducing = 0,
                              const Poll& poll = {}) const;

    /// Returns the bins whose Gaussian process in that regime is already factorised.
    BinSet factorised(Regime regime) const
    {
        return factorised_[static_cast<std::size_t>(regime)].load();
    }

    /// Returns the standardised input of bin i: the ten other bins, then s.
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
