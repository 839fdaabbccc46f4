#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "app/modelling/simulation/hazard_scenes.h"
#include "app/modelling/trials/verdict_counts.h"

namespace terratact {

/// Ground and settings of a trial of the verdict before hazards.
struct HazardTrial {
    int drives = 40;  ///< number per ground, press style and kind of hazard, and without hazard
    std::uint64_t seed = 1;   ///< seed of ground, drives and noise
    double stepLimit = 0.10;  ///< [m] obstacle height, see hasStep()
    Settings settings;        ///< options of the estimates; `rates` replaces the hazard rate
    /// The drives of two tracks have telemetry on the way (core/sim/way_drive.h), and the scenes a memory of it.
    bool remembers = false;
    std::vector<double> rates{0.002, 0.01, kHazardRate};  ///< hazard rates to try, per unfelt bin
};

/// One row of the result.
struct HazardLine {
    std::string ground;  ///< name of kHazardGrounds
    std::string hazard;  ///< "none", or name of the hazard
    PressStyle style = PressStyle::Random;
    double rate = 0.0;
    VerdictCounts counts;
};

/// Drives the simulated robot over ground outside the training data (core/sim/ground/hazard_terrain.h). Every 0.1 m it
/// estimates a scene, checks the estimate against the readings and judges its verdict. The grounds are kHazardGrounds.
/// Rows are ordered by press style, ground, hazard and rate; the console's press is tried with the last rate alone.
std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial);

/// Returns a table for the terminal: rows of one rate by ground and hazard, totals per rate and press style.
std::string hazardTable(std::span<const HazardLine> lines, double rate);

}  // namespace terratact
