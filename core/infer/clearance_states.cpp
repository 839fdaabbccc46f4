#include "core/infer/clearance_states.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/infer/moving_inputs.h"

namespace terratact {

namespace {

/// The product of two Gaussians of one quantity: precisions add.
Normal product(const Normal& a, const Normal& b)
{
    const double variance = 1.0 / (1.0 / a.variance + 1.0 / b.variance);
    return {variance * (a.mean / a.variance + b.mean / b.variance), variance};
}

struct Bin {
    std::unique_ptr<SceneConditional> conditional;
    std::optional<Normal> measured;
};

class ClearanceScene final : public SceneConditionals {
public:
    void add(std::unique_ptr<SceneConditional> conditional, const std::optional<Normal>& measured,
             const ClearanceRegimeData& scale)
    {
        bins_.push_back({std::move(conditional), measured});
        mean_.push_back(scale.mean);
        sd_.push_back(scale.sd);
    }

    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override
    {
        standardiseOthers(k, states, mean_, sd_, inputs_);
        bins_[k].conditional->predict(inputs_, mean, variance);
        if (!bins_[k].measured) return;
        for (Eigen::Index c = 0; c < mean.size(); ++c) {
            const Normal both = product({mean[c], variance[c]}, *bins_[k].measured);
            mean[c] = both.mean;
            variance[c] = both.variance;
        }
    }

private:
    std::vector<Bin> bins_;
    std::vector<double> mean_, sd_;  // of the bins' states in their regimes
    Eigen::MatrixXd inputs_;
};

}  // namespace

ClearanceStates::ClearanceStates(const ClearanceConditionals& models, const Heights& ceiling,
                                 Eigen::VectorXd s, Measured measured, Precision precision,
                                 int inducing, Poll poll)
    : models_(models), ceiling_(ceiling), s_(std::move(s)), measured_(measured),
      precision_(precision), inducing_(inducing), poll_(std::move(poll))
{
}

const ClearanceRegimeData& ClearanceStates::scale(int bin) const
{
    return models_.data().at(bin, regimeOf(ceiling_[static_cast<std::size_t>(bin)]));
}

StartDraw ClearanceStates::start(int bin) const
{
    Normal p{scale(bin).mean, scale(bin).sd * scale(bin).sd};
    if (const auto& measured = measured_[static_cast<std::size_t>(bin)]) p = product(p, *measured);
    return {p.mean, std::sqrt(p.variance)};
}

double ClearanceStates::height(int bin, double state) const
{
    return fromLogClearance(state, ceiling_[static_cast<std::size_t>(bin)]);
}

std::unique_ptr<SceneConditionals> ClearanceStates::at(const Heights& known,
                                                       const std::vector<int>& unknown) const
{
    auto scene = std::make_unique<ClearanceScene>();
    for (const int i : unknown) {
        const auto bin = static_cast<std::size_t>(i);
        scene->add(std::make_unique<SceneConditional>(
                       models_.gp(i, regimeOf(ceiling_[bin]), inducing_, poll_),
                       models_.input(i, known, ceiling_, s_), movingInputs(unknown, i), precision_,
                       poll_),
                   measured_[bin], scale(i));
    }
    return scene;
}

Normal measuredState(double z, double sd, double ceiling)
{
    if (!std::isfinite(z) || !(sd > 0.0))
        throw std::invalid_argument("a measured height needs a finite height and a positive sd");
    if (regimeOf(ceiling) == Regime::Open) return {z, sd * sd};
    const double inY = sd / (std::max(ceiling - z, 0.0) + kClearanceOffset);
    return {toLogClearance(z, ceiling), inY * inY};
}

}  // namespace terratact
