#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/learn/data/scene.h"
#include "core/limits.h"

namespace terratact {

/// Returns the estimate of a scene after some bins have been touched.
using ProbeEstimator = std::function<TerrainEstimate(const Scene&, std::span<const ArmReading>)>;

/// Returns the bin to touch next, from the present estimate and the readings so far; empty: none
/// helps.
using ProbeRule =
    std::function<std::optional<int>(const TerrainEstimate&, std::span<const ArmReading>)>;

struct ProbeLimits {
    double armSd = 0.03;               ///< sd of a reading [m]
    double sdLimit = kProbeThreshold;  ///< probing ends once every bin's sd is below it [m]
    int most = 4;                      ///< most probes of one scene
    std::uint64_t seed = 1;
};

/// The bins +0.6 and +0.7, which only the arm can reach.
inline constexpr std::array kBinsAhead{9, 10};

/// Mean |error| of an estimate [m]: over the bins ahead, and over all bins with a known truth.
struct ProbeErrors {
    double ahead = 0.0, all = 0.0;
    bool operator==(const ProbeErrors&) const = default;
};

/// Result of one rule in one scene.
struct ProbeTrial {
    ProbeErrors before{}, after{};  ///< after one probe; equal to before without a probe
    int probes = 0;                 ///< number of probes in all; their readings accumulate
    bool settled = false;           ///< every sd was below the limit at the end
};

/// Returns true if the truth of both bins ahead is known.
bool hasTruthAhead(const Scene& scene);

/// Probes a scene. It ends if every sd is below the limit, or after limits.most probes. It also
/// ends if the rule names no bin, a bin that was read before, or one without truth. A reading is
/// the truth plus N(0, armSd²). It depends on seed, sceneIndex and bin only, so it is the same for
/// every rule. first: the estimate without a reading. Throws std::invalid_argument unless
/// hasTruthAhead(scene), armSd > 0, sdLimit > 0, most ≥ 1.
ProbeTrial tryProbes(std::size_t sceneIndex, const Scene& scene, const TerrainEstimate& first,
                     const ProbeEstimator& estimate, const ProbeRule& rule,
                     const ProbeLimits& limits);

/// Result of one rule over many scenes, with the estimates of one method.
struct ProbeSummary {
    std::string label, rule;
    std::size_t scenes = 0;
    std::size_t probed = 0;                 ///< scenes with at least one probe
    ProbeErrors before{}, after{};          ///< means over all scenes [m]
    ProbeErrors beforeProbed, afterProbed;  ///< means over the scenes with a probe [m]
    std::size_t settled = 0;
    /// Mean number of probes; a scene that is not settled counts as limits.most.
    double probesNeeded = 0.0;
};
ProbeSummary summariseProbes(const std::string& label, const std::string& rule,
                             std::span<const ProbeTrial> trials, const ProbeLimits& limits);

}  // namespace terratact
