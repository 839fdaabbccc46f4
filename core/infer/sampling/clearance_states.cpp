#include "core/infer/sampling/clearance_states.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/infer/sampling/process_scene.h"

namespace terratact {

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
    auto scene = std::make_unique<ProcessScene>();
    for (const int i : unknown) {
        const auto bin = static_cast<std::size_t>(i);
        scene->add(std::make_unique<SceneConditional>(
                       models_.gp(i, regimeOf(ceiling_[bin]), inducing_, poll_),
                       models_.input(i, known, ceiling_, s_), movingInputs(unknown, i), precision_,
                       poll_),
                   scale(i).mean, scale(i).sd, measured_[bin]);
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
