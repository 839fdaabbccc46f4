#include "core/infer/sampling/process_scene.h"

#include <utility>

namespace terratact {

Normal product(const Normal& a, const Normal& b)
{
    const double variance = 1.0 / (1.0 / a.variance + 1.0 / b.variance);
    return {variance * (a.mean / a.variance + b.mean / b.variance), variance};
}

std::vector<int> movingInputs(const std::vector<int>& unknown, int bin)
{
    std::vector<int> moving;
    for (const int j : unknown)
        if (j != bin) moving.push_back(j < bin ? j : j - 1);
    return moving;
}

void ProcessScene::add(std::unique_ptr<const SceneConditional> conditional, double mean, double sd,
                       const std::optional<Normal>& measured)
{
    bins_.push_back({std::move(conditional), mean, sd, measured});
}

void ProcessScene::predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                           Eigen::VectorXd& variance)
{
    PredictionRoom room;
    const ScenePrediction asked = *ask(k, states, mean, variance);
    predictTogether({&asked, 1}, room);
    complete(k, mean, variance);
}

std::optional<ScenePrediction> ProcessScene::ask(std::size_t k, const Eigen::MatrixXd& states,
                                                 Eigen::VectorXd& mean, Eigen::VectorXd& variance)
{
    inputs_.resize(states.rows() - 1, states.cols());
    Eigen::Index row = 0;
    for (std::size_t l = 0; l < bins_.size(); ++l) {
        if (l == k) continue;
        inputs_.row(row++) =
            (states.row(static_cast<Eigen::Index>(l)).array() - bins_[l].mean) / bins_[l].sd;
    }
    return ScenePrediction{bins_[k].conditional.get(), &inputs_, &mean, &variance};
}

void ProcessScene::complete(std::size_t k, Eigen::VectorXd& mean, Eigen::VectorXd& variance) const
{
    if (!bins_[k].measured) return;
    for (Eigen::Index c = 0; c < mean.size(); ++c) {
        const Normal both = product({mean[c], variance[c]}, *bins_[k].measured);
        mean[c] = both.mean;
        variance[c] = both.variance;
    }
}

}  // namespace terratact
