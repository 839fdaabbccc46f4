#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/modelling/hazard_scenes.h"
#include "app/modelling/scene_estimates.h"

namespace terratact {

/// Ground and settings of a trial of the verdict before hazards.
struct HazardTrial {
    int drives = 40;  ///< number per ground, press style and kind of hazard, and without hazard
    std::uint64_t seed = 1;   ///< seed of ground, drives and noise
    double stepLimit = 0.10;  ///< [m] obstacle height, see hasStep()
    Settings settings;        ///< options of the estimates; `rates` replaces the hazard rate
    std::vector<double> rates{0.002, 0.01, kHazardRate};  ///< hazard rates to try, per unfelt bin
};

/// Verdict counts over a set of scenes.
struct VerdictCounts {
    std::size_t scenes = 0, failed = 0;
    /// Estimates that contradict their readings (core/sim/posterior_check.h): verdict withheld.
    std::size_t contradicting = 0;
    std::size_t withStep = 0;  ///< scenes with a true step ahead (bins kFirstAhead … 10)
    std::size_t clear = 0, blocked = 0;
    std::size_t falseClear = 0;                 ///< CLEAR with a true step before the felt horizon
    std::size_t overlooked = 0;                 ///< CLEAR with a true step beyond the felt horizon
    std::size_t flat = 0, flatClear = 0;        ///< isFlatTo() the front flippers' reach
    std::size_t pressed = 0, pressedClear = 0;  ///< of these: isPressedTo() that reach
    std::size_t feltBins = 0, feltCovered = 0;  ///< felt bins; those with truth in the 80 % band
    std::size_t unfeltBins = 0,
                unfeltCovered = 0;  ///< bins ahead not felt; those with truth in the 80 % band

    VerdictCounts& operator+=(const VerdictCounts& other);
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
/// estimates a scene, checks the estimate against the readings and judges its verdict. The grounds are kHazardGrounds. Rows are ordered by press style, ground,
/// hazard and rate; the console's press is tried with the last rate alone.
std::vector<HazardLine> tryHazards(const EstimatorBundle& bundle, const HazardTrial& trial);

/// Returns a table for the terminal: rows of one rate by ground and hazard, totals per rate and press style.
std::string hazardTable(std::span<const HazardLine> lines, double rate);

}  // namespace terratact
