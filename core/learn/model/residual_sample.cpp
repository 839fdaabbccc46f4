#include "core/learn/model/residual_sample.h"

#include <algorithm>
#include <unordered_map>

namespace terratact {

double nthSmallest(const Eigen::VectorXd& values, int n)
{
    std::vector<double> least(static_cast<std::size_t>(std::min<Eigen::Index>(n, values.size())));
    std::partial_sort_copy(values.begin(), values.end(), least.begin(), least.end());
    return least.back();
}

std::vector<int> fewOfEachPlace(std::span<const int> sorted, std::span<const int> places,
                                std::size_t wanted, int perPlace)
{
    std::unordered_map<int, int> known;
    std::vector<int> chosen;
    chosen.reserve(wanted);
    for (const int row : sorted) {
        if (chosen.size() == wanted) break;
        if (++known[places[static_cast<std::size_t>(row)]] <= perPlace) chosen.push_back(row);
    }
    return chosen;
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
