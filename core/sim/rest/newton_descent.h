#pragma once

#include <Eigen/Dense>

#include "core/learn/gp/symmetric_eigen.h"

namespace terratact {

/// Returns Newton's step −H⁻¹g for a symmetric H. Its eigenvalues are replaced by their magnitude
/// and kept above 1, so that the step descends.
template <class Matrix, class Vector>
Vector newtonStep(const Matrix& symmetric, const Vector& gradient)
{
    const SymmetricEigen eigen = symmetricEigen(symmetric);
    const Vector curvature = eigen.values.cwiseAbs().cwiseMax(1.0);
    return -(eigen.vectors * (eigen.vectors.transpose() * gradient).cwiseQuotient(curvature));
}

/// Newton's method with a line search that halves a step until it descends far enough. Problem has
///   State, Vector
///   Derivatives  with a member `gradient` (Vector)
///   energy(state, stiffness, derivatives)  returns the energy [J] and fills the derivatives
///   step(state, stiffness, derivatives)    returns a descending step
///   moved(state, step)                     returns the state after a step
///   isLost(state)                          returns true if the search is to end there
template <class Problem>
class NewtonDescent {
public:
    /// settled: a step with a smaller gain ends the search [J].
    NewtonDescent(const Problem& problem, double settled) : problem_(problem), settled_(settled) {}

    /// Returns the number of accepted steps of all runs.
    int iterations() const { return iterations_; }

    /// Descends from the state by at most `iterations` steps.
    void run(typename Problem::State& state, double stiffness, int iterations)
    {
        typename Problem::Derivatives now;
        double energy = problem_.energy(state, stiffness, now);
        for (int k = 0; k < iterations && !problem_.isLost(state); ++k, ++iterations_) {
            const typename Problem::Vector step = problem_.step(state, stiffness, now);
            const double gain = -now.gradient.dot(step);
            if (gain < settled_) return;
            if (!(gain < kRounding ? polish(state, energy, now, step, gain, stiffness)
                                   : lineSearch(state, energy, now, step, stiffness)))
                return;
        }
    }

private:
    static constexpr double kRounding = 1e-12;  // [J] of an energy of some 100 J

    /// Takes a step whose gain is lost in the energy's rounding, if the next gain is smaller.
    bool polish(typename Problem::State& state, double& energy, typename Problem::Derivatives& now,
                const typename Problem::Vector& step, double gain, double stiffness) const
    {
        typename Problem::Derivatives next;
        const typename Problem::State candidate = problem_.moved(state, step);
        const double e = problem_.energy(candidate, stiffness, next);
        const double nextGain = -next.gradient.dot(problem_.step(candidate, stiffness, next));
        if (!(nextGain < gain)) return false;
        state = candidate;
        energy = e;
        now = next;
        return true;
    }

    bool lineSearch(typename Problem::State& state, double& energy,
                    typename Problem::Derivatives& now, const typename Problem::Vector& step,
                    double stiffness) const
    {
        constexpr int kHalvings = 14;  // most halvings of a step that does not descend far enough
        typename Problem::Derivatives next;
        double share = 1.0;
        for (int halving = 0; halving < kHalvings; ++halving, share *= 0.5) {
            const typename Problem::State candidate = problem_.moved(state, share * step);
            const double e = problem_.energy(candidate, stiffness, next);
            if (e <= energy + 1e-4 * share * now.gradient.dot(step)) {
                state = candidate;
                energy = e;
                now = next;
                return true;
            }
        }
        return false;
    }

    const Problem& problem_;
    double settled_;
    int iterations_ = 0;
};

}  // namespace terratact
