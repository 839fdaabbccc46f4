#pragma once

#include <cstdint>

#include "core/infer/estimate/variant.h"
#include "core/learn/kernels/precision.h"
#include "core/limits.h"

namespace terratact {

/// Upper bounds of the settings; larger values would exceed memory or patience.
inline constexpr int kMaxDraws = 10'000'000;
inline constexpr int kMaxChains = 100'000;
inline constexpr int kMaxBurnIn = 10'000'000;

/// Number of independent draws after which a closed form with stopEarly ends. A probability is then
/// known within 0.8 % (one sd).
inline constexpr int kEnoughDraws = 4000;

/// Default hazard rate per bin that is not felt. It equals the risk that Clear accepts (kClearBelow
/// in verdict.h): CLEAR needs every bin felt up to the front flippers' reach. `terratact hazards`
/// prints the results of this and other rates.
inline constexpr double kHazardRate = 0.05;

/// Every setting of an estimate besides scene, robot and model.
struct Settings {
    Method method = Method::Local;
    CeilingRule ceiling = CeilingRule::Truncate;  ///< for the constrained methods
    ContactRule contacts = ContactRule::Isolated;
    double forceThreshold = 2.0;  ///< [N]; an element above it touches the ground (paper: 2 units)
    double contactSd = 0.02;      ///< sd of a contact height [m]
    int draws = 1000;       ///< K: kept sweeps of all chains together, at most; 1 … kMaxDraws
    bool stopEarly = true;  ///< end once the chains have converged; closed forms: at kEnoughDraws
    int chains = 16;        ///< independent chains, which may run in parallel; 1 … kMaxChains
    int burnIn = 50;        ///< discarded sweeps at the start of every chain; 0 … kMaxBurnIn
    ScanOrder scan = ScanOrder::Forward;      ///< order in which a sweep visits the bins
    Precision precision = Precision::Single;  ///< precision of sampled variances; means are double
    /// Largest number of training rows (inducing rows) that a sampling method predicts through; 0:
    /// all that the model was trained for. Fewer rows are faster and less exact
    /// (core/learn/gp/sparse_process.h).
    int inducing = 0;
    std::uint64_t seed = 1;
    /// Probe threshold [m]: the arm is proposed for a bin with a larger sd (paper).
    double probeAbove = kProbeThreshold;
    double rollLimit = 0.10;  ///< roll beyond which the 2-D assumption is doubtful [rad]
    /// Difference of the left and right flipper beyond which the 2-D assumption is doubtful [rad].
    double asymmetryLimit = 0.10;
    /// 0 … 1 per bin (core/infer/estimate/hazards.h); 0: the model's own bands.
    double hazardRate = kHazardRate;
    bool operator==(const Settings&) const = default;
};

}  // namespace terratact
