#pragma once

#include <array>
#include <atomic>

#include "core/learn/data/bin_set.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/lazy_processes.h"
#include "core/learn/model/model.h"

namespace terratact {

/// Returns the training inputs of the conditionals as V × (11 + f): scanned heights, then the
/// features of the set.
Eigen::MatrixXd rawInputs(const ModelData& model, FeatureSet set);

/// Returns (raw − mean) / sd, column by column.
Eigen::MatrixXd standardised(const Eigen::MatrixXd& raw, const Eigen::VectorXd& mean,
                             const Eigen::VectorXd& sd);

/// Returns the input of bin i's model: all columns except the i-th.
Eigen::MatrixXd withoutBin(const Eigen::MatrixXd& standardisedInputs, int bin);

/// The eleven conditionals p(hᵢ | h_{J∖i}, s) of one feature set, ready to predict. A bin's model
/// is factorised when it is first needed. It may be shared between threads.
class BinModels {
public:
    BinModels(const ModelData& model, FeatureSet set);

    FeatureSet set() const { return data_.set; }
    const BinModelData& data() const { return data_; }

    /// Returns the Gaussian process of a bin, through at most `inducing` rows; 0: as trained. The
    /// first call with these numbers factorises it.
    /// poll: as for GaussianProcess; an exception leaves the bin to the next caller. A thread that
    /// waits for another's factorisation polls too.
    /// Throws std::invalid_argument unless i is 0 to 10 and inducing ≥ 0.
    const GaussianProcess& bin(int i, int inducing = 0, const Poll& poll = {}) const;

    /// Returns the bins whose Gaussian process is already factorised.
    BinSet factorised() const { return factorised_.load(); }

    /// Returns the standardised input of bin i: the ten other heights, then s (see BinModelData).
    Eigen::VectorXd input(int i, const Heights& h, const Eigen::VectorXd& s) const;

    double heightMean(int i) const { return data_.mean[i]; }
    double heightSd(int i) const { return data_.sd[i]; }

private:
    BinModelData data_;
    Eigen::MatrixXd standardised_;  ///< V × (11 + f)
    Eigen::MatrixXd heights_;       ///< V × 11 [m]
    Eigen::MatrixXd truthSd_;       ///< V × 11 [m] sd of these heights; without rows: exact
    int inducing_;                  ///< rows as trained; 0: all
    mutable std::array<LazyProcesses, kBins> lazy_;
    mutable std::atomic<unsigned long> factorised_{0};
};

}  // namespace terratact
