#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/sim/hazard_terrain.h"

namespace terratact {

/// What is driven over in a trial of the verdict.
struct HazardTrial {
    int drives = 40;          ///< per kind of hazard and roughness, and as many without a hazard
    std::uint64_t seed = 1;   ///< of ground, drives and noise
    double stepLimit = 0.10;  ///< [m] see hasStep()
    Settings settings;        ///< of the estimates; the rate comes from the trial
    std::vector<double> rates{0.002, 0.01, kHazardRate};  ///< of hazards per unfelt bin
};

/// How the verdict did in a set of scenes.
struct VerdictCounts {
    std::size_t scenes = 0, failed = 0;
    std::size_t withStep = 0;  ///< a true step anywhere ahead (bins kFirstAhead … 10)
    std::size_t clear = 0, blocked = 0;
    std::size_t falseClear = 0;                 ///< CLEAR with a true step before the horizon
    std::size_t overlooked = 0;                 ///< CLEAR with a true step beyond the horizon
    std::size_t flat = 0, flatClear = 0;        ///< no true step up to the front flippers' reach
    std::size_t felt = 0, feltClear = 0;        ///< of these: every bin up to the reach is felt
    std::size_t feltBins = 0, feltCovered = 0;  ///< bins felt; truth in their 80 % band
    std::size_t unfeltBins = 0, unfeltCovered = 0;  ///< the same of bins ahead that are not felt

    VerdictCounts& operator+=(const VerdictCounts& other);
};

/// One line of the result.
struct HazardLine {
    std::string ground;  ///< "level", "class A", "class C"
    std::string hazard;  ///< "none", or the hazard's name
    double rate = 0.0;
    VerdictCounts counts;
};

/// Drives the simulated robot every 0.1 m over ground that no model is trained on (core/sim/hazard_terrain.h), estimates
/// every scene and judges its verdict. Level ground, and roughness of ISO 8608 classes A and C.
/// Lines by ground, hazard and rate.
std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial);

/// The lines of one rate by ground and hazard, a total per rate, and what other rates give, as a table to read.
std::string hazardTable(std::span<const HazardLine> lines, double rate);

}  // namespace terratact
