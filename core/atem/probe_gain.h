#pragma once

#include <optional>
#include <vector>

#include "core/base/poll.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// What touching one bin with the arm is expected to tell about all bins.
struct ProbeGain {
    int bin = 0;
    double varianceReduction = 0.0;  ///< [m²] of Σ_i Var(h_i)
    double entropyReduction = 0.0;   ///< [nat] of "there is a step of more than stepLimit"
    bool operator==(const ProbeGain&) const = default;
};

/// [bit] of entropyReduction: less reads 0.00, and is no gain.
inline constexpr double kMinBits = 0.005;

/// What an estimate leaves open, in the units of ProbeGain: V and H below with equal weights.
struct Uncertainty {
    double variance = 0.0;  ///< [m²]
    double entropy = 0.0;   ///< [nat]
    bool operator==(const Uncertainty&) const = default;
};

/// Of a step within firstBin … 10.  Throws as probeGains does.  poll: here and below, in the course of it.
Uncertainty uncertainty(const TerrainEstimate& estimate, double stepLimit, int firstBin = 0,
                        const Poll& poll = {});

/// The expected gain of measuring each bin that the arm reaches, the largest varianceReduction first (of
/// equals the nearer bin).  For readings z of bin b the n draws h^d are reweighted,
///   w_d(z) ∝ N(z; h_b^d, armSd²),   Σ_d w_d = 1,
///   V(w) = Σ_i Σ_d w_d (h_i^d − Σ_e w_e h_i^e)² / (1 − Σ_d w_d²),
///   H(w) = −p log p − (1 − p) log(1 − p),   p = Σ_d w_d [h^d has a step within firstBin … 10],
/// and gain = V(1/n) − mean_z V(w(z)), likewise for H, over 48 evenly spaced quantiles of the readings to
/// expect: each draw's height plus noise of armSd (a golden-ratio sequence, so that nothing is random).
/// The denominator makes V unbiased for bins that have nothing to do with b.  H is estimated too small by
/// about 1/2m nat, m the draws that a reading leaves (1/Σ w²): some 0.002 for 1000 draws of 0.2 m sd.  A bin
/// that stands still in all draws gains nothing; Monte-Carlo error may make a gain slightly negative.
/// armSd, stepLimit: [m].  Throws std::invalid_argument unless armSd > 0, stepLimit ≥ 0, both finite,
/// 0 ≤ firstBin < 10, and there are draws.
/// Source: self-normalised importance sampling, Owen, "Monte Carlo theory, methods and examples" (2013)
/// ch. 9; expected gain of an experiment, Lindley, Ann. Math. Stat. 27 (1956).
std::vector<ProbeGain> probeGains(const TerrainEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin = 0,
                                  const Poll& poll = {});

/// The first of probeGains whose bin was sampled; empty where the arm reaches none.
std::optional<ProbeGain> bestProbe(const TerrainEstimate& estimate, const RobotModel& robot,
                                   double armSd, double stepLimit);

}  // namespace terratact
