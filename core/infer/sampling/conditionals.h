#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/learn/gp/scene_conditional.h"
#include "core/terrain/bins.h"

namespace terratact {

/// The conditionals p(xᵢ | x_{J∖i}) of one scene, for all i ∈ I, where the states of the other bins stand
/// still.  Belongs to one sampler: it may keep room to work in between calls.
class SceneConditionals {
public:
    virtual ~SceneConditionals() = default;

    /// Mean and variance of the state of bin I[k] given the other unknown bins', for all chains at once.
    ///   states: |I| × chains, row l holds bin I[l]; row k is not read.
    ///   mean, variance: chains; resized, every variance > 0.
    virtual void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                         Eigen::VectorXd& variance) = 0;

    /// What predict asks of a Gaussian process, for a caller who asks for several scenes at once (predictTogether) and
    /// then lets this one complete() its mean and variance; empty: predict does it all.  The answer refers to
    /// this object and the arguments, until either changes.
    virtual std::optional<ScenePrediction> ask(std::size_t k, const Eigen::MatrixXd& states,
                                               Eigen::VectorXd& mean, Eigen::VectorXd& variance)
    {
        (void)k, (void)states, (void)mean, (void)variance;
        return std::nullopt;
    }
    virtual void complete(std::size_t k, Eigen::VectorXd& mean, Eigen::VectorXd& variance) const
    {
        (void)k, (void)mean, (void)variance;
    }
};

/// Mean and deviation of a chain's first state.
struct StartDraw {
    double mean = 0.0;
    double sd = 1.0;  ///< > 0
};

/// Where the Gibbs sampler's Gaussians come from.  A state xᵢ says where the ground of bin i is: its
/// height [m] in the paper's models; an implementation may choose another.
class Conditionals {
public:
    virtual ~Conditionals() = default;

    /// Where chains start in this bin.
    virtual StartDraw start(int bin) const = 0;

    /// The height [m] that a state of this bin stands for.
    virtual double height(int bin, double state) const
    {
        (void)bin;
        return state;
    }

    /// The conditionals with the other bins' states fixed.
    ///   known: states of all bins; those of I are not read.  unknown: I, rear to front.
    /// What is returned may refer to this object.
    virtual std::unique_ptr<SceneConditionals> at(const Heights& known,
                                                  const std::vector<int>& unknown) const = 0;
};

}  // namespace terratact
