#include "core/learn/model/residual_sample.h"

#include <algorithm>
#include <vector>

namespace terratact {

double nthSmallest(const Eigen::VectorXd& values, int n)
{
    std::vector<double> least(static_cast<std::size_t>(std::min<Eigen::Index>(n, values.size())));
    std::partial_sort_copy(values.begin(), values.end(), least.begin(), least.end());
    return least.back();
}

Eigen::VectorXd residualWeights(const Eigen::VectorXd& squared)
{
    const auto middle = static_cast<int>(std::max<Eigen::Index>(squared.size() / 2, 1));
    const double least = squared.minCoeff();
    const double width = std::max(nthSmallest(squared, middle) - least, 1e-9);
    Eigen::VectorXd weight = (-0.5 * (squared.array() - least) / width).exp().matrix();
    weight /= weight.sum();
    return weight;
}

}  // namespace terratact
