#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/learn/gp/scene_conditional.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Conditionals p(xᵢ | x_{J∖i}) of one scene for all i ∈ I, with the states of all other bins
/// fixed. One sampler owns this object, which may keep buffers between calls.
class SceneConditionals {
public:
    virtual ~SceneConditionals() = default;

    /// Mean and variance of the state of bin I[k] given the other unknown bins, for all chains at
    /// once.
    ///   states: |I| × chains, row l holds bin I[l]; row k is not read.
    ///   mean, variance: chains; resized, every variance > 0.
    virtual void predict(std::size_t k, const Eigen::MatrixXd& states, Eigen::VectorXd& mean,
                         Eigen::VectorXd& variance) = 0;

    /// Returns what predict() asks of a Gaussian process; empty if predict() needs no process. A
    /// caller collects the questions of several scenes (predictTogether), then calls complete().
    /// The answer refers to this object and the arguments, and holds until either changes.
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

/// Mean and standard deviation of a chain's first state.
struct StartDraw {
    double mean = 0.0;
    double sd = 1.0;  ///< > 0
};

/// Source of the Gibbs sampler's Gaussians. A state xᵢ describes the ground of bin i: its height
/// [m] in the paper's models, another quantity in other implementations.
class Conditionals {
public:
    virtual ~Conditionals() = default;

    /// Returns the distribution that chains start from in this bin.
    virtual StartDraw start(int bin) const = 0;

    /// Returns the height [m] of a state of this bin.
    virtual double height(int bin, double state) const
    {
        (void)bin;
        return state;
    }

    /// Returns the conditionals with the known bins' states fixed.
    ///   known: states of all bins; those of I are not read.  unknown: I, rear to front.
    /// The result may refer to this object.
    virtual std::unique_ptr<SceneConditionals> at(const Heights& known,
                                                  const std::vector<int>& unknown) const = 0;
};

}  // namespace terratact
