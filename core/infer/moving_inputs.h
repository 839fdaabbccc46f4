#pragma once

#include <Eigen/Core>
#include <vector>

namespace terratact {

/// A bin's Gaussian process takes the ten other bins, rear to front, as its first inputs.  These are the
/// positions among them of the unknown bins other than `bin`.
std::vector<int> movingInputs(const std::vector<int>& unknown, int bin);

/// Those inputs' values: (state − mean) / sd of all unknown bins but the k-th.
///   states: |I| × chains; mean, sd: |I|; inputs: (|I| − 1) × chains, resized.
void standardiseOthers(std::size_t k, const Eigen::MatrixXd& states,
                       const std::vector<double>& mean, const std::vector<double>& sd,
                       Eigen::MatrixXd& inputs);

}  // namespace terratact
