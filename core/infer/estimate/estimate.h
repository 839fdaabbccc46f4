#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/settings.h"
#include "core/infer/estimate/touch.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// Source of a bin's height.
enum class Origin : std::uint8_t { Sampled, Contact, Arm };

/// Returns "sampled", "contact" or "arm".
std::string_view name(Origin origin);

/// Reason why sampling ended.
enum class Ending : std::uint8_t {
    Converged,  ///< R-hat ≤ 1.01 and ESS ≥ 400 for every sampled bin
    Sweeps,     ///< Settings::draws were reached
    Time,       ///< Watch::outOfTime returned true
    NotSampled  ///< no bin was unknown, or the method has no chains
};

/// Returns "converged", "sweeps", "time" or "not sampled".
std::string_view name(Ending ending);

/// Terrain estimate of one exploration: 11 bins, rear to front. Heights [m], DEM frame. Plain
/// values that may be copied across threads. Every number is finite except ceiling: it is +infinity
/// where the robot does not cover part of the bin.
struct TerrainEstimate {
    /// Closed forms write them in closed_form_parts.cpp, Gibbs in draw_summary.cpp. addHazards() and
    /// addMeasuredHazards() then write those of bins that may hold a hazard.
    Heights mean{}, sd{}, q10{}, q90{};
    /// The one height to show [m]: the mean for the paper's four methods, else the median.
    /// Distributions of the other methods are skewed.
    Heights height{};
    Heights ceiling{};
    std::array<Origin, kBins> origin{};
    /// Touch of each bin, see core/infer/estimate/touch.h.
    TouchMap touch = unrecordedTouch();
    /// The x of the foremost loaded force element [m], DEM frame; binBegin(0): none.
    double feltTo = binBegin(0);
    Heights rhat{};  ///< rank-normalised split R-hat; 1 for a bin that was not sampled
    /// Bulk effective sample size; the number of draws for a bin that was not sampled.
    Heights ess{};
    /// Joint draws of all bins, for questions about several bins; at most settings.draws, rounded
    /// up to full chains.
    std::vector<Heights> draws;
    /// Distance from the training scenes (core/learn/model/clearance_model.h). 1 % of them
    /// are above 1. Only the closed forms compute it; 0 otherwise.
    double novelty = 0.0;
    MissingFeatures missing{};  ///< features that the method uses and that were not measured
    Ending ending = Ending::NotSampled;
    bool converged = true;  ///< R-hat ≤ 1.01 and ESS ≥ 400 for every sampled bin
    /// True if a posterior check failed: on the estimated ground the robot would read other values
    /// (core/sim/posterior_check.h). False if no check was made.
    bool contradicts = false;
    std::vector<Message> warnings;  ///< one sentence for each reason to doubt the result
    Settings settings;
    bool operator==(const TerrainEstimate&) const = default;

    /// Returns true if the bin was sampled and no part of the robot covers it: only the training
    /// set supports it.
    bool priorOnly(int bin) const
    {
        const auto i = static_cast<std::size_t>(bin);
        return origin[i] == Origin::Sampled && std::isinf(ceiling[i]);
    }
};

/// Convergence limits. Source: Vehtari et al. (2021).
inline constexpr double kRhatLimit = 1.01;
inline constexpr double kEssLimit = 400.0;

}  // namespace terratact
