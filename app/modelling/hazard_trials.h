#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/sim/hazard_terrain.h"

namespace terratact {

/// Ground and settings of a trial of the verdict before hazards.
struct HazardTrial {
    int drives = 40;          ///< number per kind of hazard and roughness, and without hazard
    std::uint64_t seed = 1;   ///< seed of ground, drives and noise
    double stepLimit = 0.10;  ///< [m] obstacle height, see hasStep()
    Settings settings;        ///< options of the estimates; `rates` replaces the hazard rate
    std::vector<double> rates{0.002, 0.01, kHazardRate};  ///< hazard rates to try, per unfelt bin
};

/// Verdict counts over a set of scenes.
struct VerdictCounts {
    std::size_t scenes = 0, failed = 0;
    std::size_t withStep = 0;  ///< scenes with a true step ahead (bins kFirstAhead … 10)
    std::size_t clear = 0, blocked = 0;
    std::size_t falseClear = 0;           ///< CLEAR with a true step before the felt horizon
    std::size_t overlooked = 0;           ///< CLEAR with a true step beyond the felt horizon
    std::size_t flat = 0, flatClear = 0;  ///< no true step within the front flippers' reach
    std::size_t felt = 0,
                feltClear = 0;  ///< subset of flat scenes with every bin within reach felt
    std::size_t feltBins = 0, feltCovered = 0;  ///< felt bins; those with truth in the 80 % band
    std::size_t unfeltBins = 0,
                unfeltCovered = 0;  ///< bins ahead not felt; those with truth in the 80 % band

    VerdictCounts& operator+=(const VerdictCounts& other);
};

/// One row of the result.
struct HazardLine {
    std::string ground;  ///< "level", "class A", "class C"
    std::string hazard;  ///< "none", or name of the hazard
    double rate = 0.0;
    VerdictCounts counts;
};

/// Drives the simulated robot over ground outside the training data (core/sim/hazard_terrain.h). Every 0.1 m it
/// estimates a scene and judges its verdict. Ground is level or has roughness of ISO 8608 classes A and C. Rows are
/// ordered by ground, hazard and rate.
std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial);

/// Returns a table for the terminal: rows of one rate by ground and hazard, totals per rate.
std::string hazardTable(std::span<const HazardLine> lines, double rate);

}  // namespace terratact
