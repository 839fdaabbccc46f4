#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/atem/probe/probe_gain.h"
#include "core/infer/verdict/verdict.h"
#include "core/limits.h"
#include "core/robot/probe_side.h"

namespace terratact {

/// Expected value of probing one place. Variance and entropy are of both sides, if both are estimated.
struct ProbeWorth {
    int bin = 0;
    double varianceShare = 0.0;  ///< 0 … 1, expected reduction of the summed variance of all bins
    double bitsAfter = 0.0;  ///< [bit] expected entropy of "is there a step ahead?" after the probe
    ProbeSide side = ProbeSide::Middle;

    ProbePlace place() const { return {bin, side}; }
    bool operator==(const ProbeWorth&) const = default;
};

/// A probe proposal. An answer carries the proposal's id, so that it approves only what was on the screen.
struct ProbeProposal {
    std::uint64_t id = 0;
    int bin = 0;
    ProbeSide side = ProbeSide::Middle;
    double height = 0.0, q10 = 0.0, q90 = 0.0, sd = 0.0;  ///< [m]
    double limit = kProbeThreshold;   ///< [m] probe threshold: above this sd the arm is proposed
    double armSd = 0.03;              ///< [m] sd of the arm's measurement
    double seconds = 45.0;            ///< [s] expected duration of the probe
    double stepLimit = 0.1;           ///< [m] step height that counts as an obstacle
    double bitsBefore = 0.0;          ///< [bit] entropy of "is there a step ahead?" now
    std::optional<ProbeWorth> worth;  ///< worth of this bin; empty: the method cannot compute it
    std::vector<ProbeWorth> others;   ///< other places the operator may choose, best first
    StepVerdict answer = StepVerdict::CannotTell;  ///< verdict of the estimate without the probe

    /// Returns true if the probe informs the step verdict. Otherwise it only refines the terrain's shape, if its worth
    /// is known.
    bool informsOnStep() const { return worth && bitsBefore - worth->bitsAfter >= kMinBits; }
    bool operator==(const ProbeProposal&) const = default;
};

}  // namespace terratact
