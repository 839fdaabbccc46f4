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

/// The estimate of a scene once some bins have been touched.
using ProbeEstimator = std::function<TerrainEstimate(const Scene&, std::span<const ArmReading>)>;

/// Which bin to touch next, from the present estimate and what was read already; empty: none helps.
using ProbeRule =
    std::function<std::optional<int>(const TerrainEstimate&, std::span<const ArmReading>)>;

struct ProbeLimits {
    double armSd = 0.03;               ///< [m] noise of a reading
    double sdLimit = kProbeThreshold;  ///< [m] enough is known when every bin's sd is below
    int most = 4;                      ///< probes of one scene
    std::uint64_t seed = 1;
};

/// The bins +0.6 and +0.7 that only the arm can reach: what probes are for.
inline constexpr std::array kBinsAhead{9, 10};

/// Mean |error| [m] of an estimate: over the bins ahead, and over all whose truth is known.
struct ProbeErrors {
    double ahead = 0.0, all = 0.0;
    bool operator==(const ProbeErrors&) const = default;
};

/// What one rule did in one scene.
struct ProbeTrial {
    ProbeErrors before{}, after{};  ///< one probe; equal where none was made
    int probes = 0;                 ///< made in all, the readings adding up
    bool settled = false;           ///< in the end every sd was below the limit
};

/// Whether the truth of both bins ahead is known.
bool hasTruthAhead(const Scene& scene);

/// Touches bins that the rule names until every sd is below the limit, the rule names none (or one that was
/// read before or whose truth is unknown), or limits.most probes were made.  A reading is the truth plus
/// N(0, armSd²) by seed, sceneIndex and bin: the same for every rule.
/// first: the estimate without a reading.  Throws std::invalid_argument unless hasTruthAhead(scene),
/// armSd > 0, sdLimit > 0, most ≥ 1.
ProbeTrial tryProbes(std::size_t sceneIndex, const Scene& scene, const TerrainEstimate& first,
                     const ProbeEstimator& estimate, const ProbeRule& rule,
                     const ProbeLimits& limits);

/// What one rule did over many scenes, with the estimates of one method.
struct ProbeSummary {
    std::string label, rule;
    std::size_t scenes = 0;
    std::size_t probed = 0;                 ///< in which at least one probe was made
    ProbeErrors before{}, after{};          ///< [m] means over all scenes
    ProbeErrors beforeProbed, afterProbed;  ///< [m] over the probed ones
    std::size_t settled = 0;
    double probesNeeded = 0.0;  ///< mean; a scene that is not settled counts as limits.most
};
ProbeSummary summariseProbes(const std::string& label, const std::string& rule,
                             std::span<const ProbeTrial> trials, const ProbeLimits& limits);

}  // namespace terratact
