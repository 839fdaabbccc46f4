#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace terratact {

/// Number of training places whose residuals form the errors of a scene.
inline constexpr int kNeighbours = 30;

/// Unexplained part of training scenes: K weighted vectors of residuals [y].
struct ResidualSample {
    Eigen::VectorXd weight;    ///< K, sum 1
    Eigen::MatrixXd residual;  ///< 11 × K; of both sides: 22 × K, left above right
};

/// Returns the weights of scenes at these squared distances:
///   weight ∝ exp(−½ (D² − D²_min) / (D²_median − D²_min))
Eigen::VectorXd residualWeights(const Eigen::VectorXd& squared);

/// Returns the first rows of each place, in order: at most perPlace of one place, and at most `wanted`.
/// sorted: rows; places: of every row.
std::vector<int> fewOfEachPlace(std::span<const int> sorted, std::span<const int> places,
                                std::size_t wanted, int perPlace = 1);

/// Returns the n-th smallest value, n from 1; the largest if there are fewer.
double nthSmallest(const Eigen::VectorXd& values, int n);

}  // namespace terratact
