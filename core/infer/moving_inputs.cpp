#include "core/infer/moving_inputs.h"

namespace terratact {

std::vector<int> movingInputs(const std::vector<int>& unknown, int bin)
{
    std::vector<int> moving;
    for (const int j : unknown)
        if (j != bin) moving.push_back(j < bin ? j : j - 1);
    return moving;
}

void standardiseOthers(std::size_t k, const Eigen::MatrixXd& states,
                       const std::vector<double>& mean, const std::vector<double>& sd,
                       Eigen::MatrixXd& inputs)
{
    inputs.resize(states.rows() - 1, states.cols());
    Eigen::Index row = 0;
    for (std::size_t l = 0; l < mean.size(); ++l) {
        if (l == k) continue;
        inputs.row(row++) = (states.row(static_cast<Eigen::Index>(l)).array() - mean[l]) / sd[l];
    }
}

}  // namespace terratact
