#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/infer/sampling/conditionals.h"
#include "core/learn/gp/gaussian_process.h"
#include "core/learn/gp/scene_conditional.h"

namespace terratact {

/// Conditionals of one scene from Gaussian processes. The inputs of a bin are the standardised
/// states of the other bins. A measured bin multiplies its conditional by the measurement's
/// Gaussian: p(xᵢ | x_{J∖i}, s) N(xᵢ; m, v).
class ProcessScene final : public SceneConditionals {
public:
    /// Adds the next bin of I. mean, sd: standardise its states as inputs of the others.
    void add(std::unique_ptr<const SceneConditional> conditional, double mean, double sd,
             const std::optional<Normal>& measured = {});

    void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                 Eigen::VectorXd& variance) override;
    std::optional<ScenePrediction> ask(std::size_t k, const Eigen::MatrixXd& states,
                                       Eigen::VectorXd& mean, Eigen::VectorXd& variance) override;
    void complete(std::size_t k, Eigen::VectorXd& mean, Eigen::VectorXd& variance) const override;

private:
    struct Bin {
        std::unique_ptr<const SceneConditional> conditional;
        double mean, sd;
        std::optional<Normal> measured;
    };
    std::vector<Bin> bins_;
    Eigen::MatrixXd inputs_;
};

/// Returns the product of two Gaussians of one quantity: their precisions add.
Normal product(const Normal& a, const Normal& b);

/// A bin's Gaussian process takes the ten other bins, rear to front, as its first inputs. Returns
/// the positions of the unknown bins other than `bin` among them.
std::vector<int> movingInputs(const std::vector<int>& unknown, int bin);

}  // namespace terratact
