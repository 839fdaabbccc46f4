#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/modelling/scene_estimates.h"
#include "core/strip/height_band.h"
#include "core/strip/strip_ledger.h"
#include "core/terrain/terrain_profile.h"

namespace terratact {

/// Ground and settings of a trial of the strip of felt ground.
struct StripTrial {
    std::vector<TerrainProfile> grounds;  ///< one drive over each
    double spacing = 0.3;                 ///< [m] between two scenes
    std::uint64_t seed = 1;               ///< seed of styles, slip and noise
    Settings settings;                    ///< of the estimates
};

/// A stretch of the strip as seen from the robot.
struct StripStretch {
    std::string_view name;
    double begin = 0.0, end = 0.0;  ///< [m] range of a bin's centre, forward from the IMU
    bool feltOnly = false;          ///< only bins that the arm, a flipper or a track touched
};
inline constexpr std::array kStripStretches{
    StripStretch{"ahead, 0.3 ... 0.7 m", 0.25, 0.75},
    StripStretch{"under, -0.2 ... 0.2 m", -0.25, 0.25},
    StripStretch{"-0.3 ... 0.5 m", -0.35, 0.55},
    StripStretch{"behind, -0.3 m and further", -100.0, -0.25},
    StripStretch{"  of these felt", -100.0, -0.25, true},
    StripStretch{"  -0.3 ... -0.6 m", -0.65, -0.25},
    StripStretch{"  -0.7 ... -1.5 m", -1.55, -0.65},
    StripStretch{"  further than -1.5 m", -100.0, -1.55},
};

/// Errors of the bins of one stretch, over all scenes of all drives.
struct StripErrors {
    std::size_t bins = 0;
    double median = 0.0, mean = 0.0;  ///< |error| [m]
    double in80 = 0.0;                ///< share of truths within q10 … q90
    double width = 0.0;               ///< mean q90 − q10 [m]
};

/// Result of one way to place estimates.
struct StripResult {
    std::string_view name;  ///< "this scene alone", or the rule for a bin with several estimates
    std::array<StripErrors, kStripStretches.size()> stretch{};
};

struct StripFindings {
    std::size_t drives = 0, scenes = 0;
    double way = 0.0;  ///< mean distance of the drives [m]
    std::vector<StripResult> results;
    StripLedger ledger{};  ///< of the shipped strip (Strip::ledger())
    /// Bins of the ledger whose true height is within the band, by ScoredBy.
    std::array<std::size_t, kScoredBy.size()> inTruth{};
};

/// Drives the simulated robot with telemetry over each ground (core/sim/watched_drive.h). Enters the estimates of
/// its scenes into strips, one for each rule of fusion. After each scene, every bin of the section is compared with
/// the true ground as seen from the true pose. The scenes' own estimates are the first result. The method Trail gets
/// the memory of the way.
StripFindings tryStrips(const EstimatorBundle& bundle, const StripTrial& trial);

/// Returns a table for the terminal [mm].
std::string stripTable(const StripFindings& findings);

}  // namespace terratact
