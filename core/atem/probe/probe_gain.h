#pragma once

#include <optional>
#include <vector>

#include "core/base/poll.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/robot/robot_model.h"

namespace terratact {

/// Expected information about all bins, of both sides if both were estimated, from touching one bin
/// with the arm.
struct ProbeGain {
    int bin = 0;
    double varianceReduction = 0.0;  ///< reduction of Σ_i Var(h_i) [m²]
    /// Reduction of the entropy of "there is a step of more than stepLimit" [nat].
    double entropyReduction = 0.0;
    ProbeSide side = ProbeSide::Middle;  ///< Middle: of one plane

    ProbePlace place() const { return {bin, side}; }
    bool operator==(const ProbeGain&) const = default;
};

/// Least entropyReduction that counts as a gain [bit]; less is displayed as 0.00.
inline constexpr double kMinBits = 0.005;

/// Uncertainty of an estimate, in the units of ProbeGain: V and H below with equal weights.
struct Uncertainty {
    double variance = 0.0;  ///< [m²]
    double entropy = 0.0;   ///< [nat]
    bool operator==(const Uncertainty&) const = default;
};

/// Returns the uncertainty about a step within firstBin … 10. Throws as probeGains. poll: called
/// during the work.
Uncertainty uncertainty(const TerrainEstimate& estimate, double stepLimit, int firstBin = 0,
                        const Poll& poll = {});

/// Returns the expected gain of measuring each bin in the arm's reach. The largest
/// varianceReduction comes first, of equals the nearer bin. A reading z of bin b reweights the n
/// draws h^d:
///   w_d(z) ∝ N(z; h_b^d, armSd²),   Σ_d w_d = 1,
///   V(w) = Σ_i Σ_d w_d (h_i^d − Σ_e w_e h_i^e)² / (1 − Σ_d w_d²),
///   H(w) = −p log p − (1 − p) log(1 − p),   p = Σ_d w_d [h^d has a step within firstBin … 10],
///   gain = V(1/n) − mean_z V(w(z)), and the same for H.
/// The mean is over 48 evenly spaced quantiles of the expected readings: each draw's height plus
/// noise of armSd. The noise is a golden-ratio sequence, so that nothing is random. The denominator
/// makes V unbiased for bins that are independent of b. H is too small by about 1/2m nat; m = 1/Σ
/// w² is the effective number of draws after a reading. The error is about 0.002 for 1000 draws of
/// 0.2 m sd. A bin with equal draws gains nothing. Monte-Carlo error may make a gain slightly
/// negative. armSd, stepLimit: [m]. Throws std::invalid_argument unless armSd > 0, stepLimit ≥ 0,
/// both finite, 0 ≤ firstBin < 10, and there are draws. Source: self-normalised importance
/// sampling, Owen, "Monte Carlo theory, methods and examples" (2013) ch. 9; expected gain of an
/// experiment, Lindley, Ann. Math. Stat. 27 (1956).
std::vector<ProbeGain> probeGains(const TerrainEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin = 0,
                                  const Poll& poll = {});

/// Return the same of both sides. V sums the variances of all bins of both sides. H is the entropy of
/// "there is a step on either side": draw d of both sides is one joint draw. A reading of one side
/// reweights the joint draws, and so informs about the other side too. Of equal gains the nearer bin
/// comes first, then the left side. An estimate of one plane has the gains above, in the middle.
Uncertainty uncertainty(const TwoTrackEstimate& estimate, double stepLimit, int firstBin = 0,
                        const Poll& poll = {});
std::vector<ProbeGain> probeGains(const TwoTrackEstimate& estimate, const RobotModel& robot,
                                  double armSd, double stepLimit, int firstBin = 0,
                                  const Poll& poll = {});

/// The first of probeGains whose bin was sampled; empty where the arm reaches none.
std::optional<ProbeGain> bestProbe(const TerrainEstimate& estimate, const RobotModel& robot,
                                   double armSd, double stepLimit);

}  // namespace terratact
