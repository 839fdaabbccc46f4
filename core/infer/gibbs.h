#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/infer/variant.h"
#include "core/infer/watch.h"
#include "core/learn/bin_models.h"
#include "core/terrain/bins.h"

namespace terratact {

/// What the sampler is asked: draw the heights h_I of the unknown bins from the conditionals
/// p(hᵢ | h_{J∖i}, s), given the known ones.
struct GibbsProblem {
    Eigen::VectorXd s;      ///< features of the models' set
    OptionalHeights known;  ///< [m] kept as they are
    Heights ceiling{};      ///< [m] +infinity where there is none
    CeilingRule rule = CeilingRule::Truncate;
    int chains = 16;
    int burnIn = 50;        ///< sweeps per chain that are thrown away
    int keptPerChain = 63;  ///< sweeps per chain that are kept
    std::uint64_t seed = 1;
};

struct GibbsDraws {
    std::vector<int> bins;               ///< I, rear to front
    std::vector<Eigen::MatrixXd> draws;  ///< per bin of I: kept sweeps × chains [m]
};

/// Section 4.3: random start (from the training set's mean and deviation, below the ceiling), then sweeps
/// that draw every unknown bin in turn, rear to front, ceilings applied by `rule`.  Chains advance side
/// by side, each with its own random numbers: a chain's draws do not depend on how many others run.
/// The conditionals are trained one by one and need not belong to one joint distribution: the result may
/// depend on the order of the scan (domain: "dependency network").
/// Throws std::invalid_argument unless chains ≥ 1, burnIn ≥ 0, keptPerChain ≥ 1; Cancelled.
GibbsDraws sampleHeights(const BinModels& models, const GibbsProblem& problem,
                         const Watch& watch = {});

}  // namespace terratact
