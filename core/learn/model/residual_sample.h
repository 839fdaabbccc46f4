#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <numeric>
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

/// Returns the first rows of an order, at most perPlace of one place, and at most `wanted`. places: of
/// every row. isBefore(a, b): row a comes before row b.
template <class Order>
std::vector<int> nearestOfPlaces(std::span<const int> places, Order isBefore, std::size_t wanted,
                                 int perPlace = 1)
{
    std::vector<int> rows(places.size());
    std::iota(rows.begin(), rows.end(), 0);
    for (std::size_t sorted = 2 * wanted;; sorted *= 2) {
        const auto end = rows.begin() + static_cast<std::ptrdiff_t>(std::min(sorted, rows.size()));
        std::partial_sort(rows.begin(), end, rows.end(), isBefore);
        std::vector<int> chosen = fewOfEachPlace({rows.begin(), end}, places, wanted, perPlace);
        if (chosen.size() == wanted || end == rows.end()) return chosen;
    }
}

/// Returns the n-th smallest value, n from 1; the largest if there are fewer.
double nthSmallest(const Eigen::VectorXd& values, int n);

}  // namespace terratact
