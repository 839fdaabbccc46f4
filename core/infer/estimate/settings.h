#pragma once

#include <cstdint>

#include "core/infer/estimate/variant.h"
#include "core/learn/kernels/precision.h"
#include "core/limits.h"

namespace terratact {

/// More than a program can hold or anybody waits for.
inline constexpr int kMaxDraws = 10'000'000;
inline constexpr int kMaxChains = 100'000;
inline constexpr int kMaxBurnIn = 10'000'000;

/// Independent draws after which a closed form that may stop early does: a probability is then within 0.8 % (one sd).
inline constexpr int kEnoughDraws = 4000;

/// Default rate of hazards per bin that nobody has felt. At 0.05, the risk that Clear accepts (verdict.h), CLEAR needs
/// every bin felt up to the front flippers' reach. `terratact evaluate --hazards` prints what other rates give.
inline constexpr double kHazardRate = 0.05;

/// Everything besides scene, robot and model that decides an estimate.
struct Settings {
    Method method = Method::Local;
    CeilingRule ceiling = CeilingRule::Truncate;  ///< for the constrained methods
    ContactRule contacts = ContactRule::Isolated;
    double forceThreshold = 2.0;  ///< [N] an element above it touches the ground (paper: 2 units)
    double contactSd = 0.02;      ///< [m] sd of a contact height
    int draws = 1000;             ///< K: kept sweeps, all chains together, at most; 1 to kMaxDraws
    bool stopEarly = true;  ///< ends once the chains have converged; closed forms: at kEnoughDraws
    int chains = 16;        ///< independent chains, run side by side; 1 to kMaxChains
    int burnIn = 50;        ///< sweeps thrown away at the start of every chain; 0 to kMaxBurnIn
    ScanOrder scan = ScanOrder::Forward;      ///< in which a sweep visits the bins
    Precision precision = Precision::Single;  ///< of sampled variances; means are double
    /// Rows of the training set that a sampling method's predictions go through, at most; 0: as trained.  Fewer
    /// are cheaper and less exact (core/learn/gp/sparse_process.h).
    int inducing = 0;
    std::uint64_t seed = 1;
    double probeAbove = kProbeThreshold;  ///< [m] a bin with a larger sd asks for the arm (paper)
    double rollLimit = 0.10;              ///< [rad] beyond it the 2-D assumption is doubtful
    double asymmetryLimit = 0.10;         ///< [rad] left/right flipper difference, likewise
    double hazardRate =
        kHazardRate;  ///< 0 to 1 per bin, see core/infer/estimate/hazards.h; 0: the model's own bands
    bool operator==(const Settings&) const = default;
};

}  // namespace terratact
