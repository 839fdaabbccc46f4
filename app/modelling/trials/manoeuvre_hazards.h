#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/modelling/simulation/manoeuvre_drives.h"
#include "app/modelling/trials/track_hazards.h"

namespace terratact {

/// Result of the scripted drives of one manoeuvre by one method.
struct ManoeuvreLineCounts {
    Manoeuvre manoeuvre = Manoeuvre::Curve;
    Method method = Method::Trail;
    std::size_t drives = 0;
    TrackHazardLine counts;
    /// Scenes with bins ahead that earlier poses felt, and false CLEARs among them.
    std::size_t remembered = 0, falseRemembered = 0;
    std::size_t cut = 0;  ///< scenes before which nothing is remembered
};

/// Drives each manoeuvre over all grounds and hazards, trial.drives times (driveManoeuvre()). Judges every
/// scene by Trail with its memory, and by Local, which uses the scene alone. Where the arm probed, the
/// scene is judged again with the readings. Of trial.rates, the last one is used. Throws RefusedInput if
/// the model has no two tracks.
std::vector<ManoeuvreLineCounts> tryManoeuvres(const EstimatorBundle& bundle,
                                               const HazardTrial& trial);

/// Returns a table for the terminal: a row for each manoeuvre by each method.
std::string manoeuvreTable(std::span<const ManoeuvreLineCounts> lines);

}  // namespace terratact
