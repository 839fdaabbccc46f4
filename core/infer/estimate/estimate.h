#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/infer/estimate/settings.h"
#include "core/infer/estimate/touch.h"
#include "core/robot/measurement.h"
#include "core/terrain/bins.h"

namespace terratact {

/// How a bin got its height.
enum class Origin : std::uint8_t { Sampled, Contact, Arm };

/// "sampled", "contact", "arm".
std::string_view name(Origin origin);

/// Why sampling ended.
enum class Ending : std::uint8_t {
    Converged,  ///< R-hat ≤ 1.01 and ESS ≥ 400 for every sampled bin
    Sweeps,     ///< Settings::draws were reached
    Time,       ///< Watch::outOfTime
    NotSampled  ///< no bin was unknown, or the method has no chains
};

/// "converged", "sweeps", "time", "not sampled".
std::string_view name(Ending ending);

/// What the operator sees of one exploration: 11 bins, rear to front.  Heights [m], DEM frame.
/// Plain values: copy it across threads.  Every number is finite but ceiling, which is +infinity where
/// nothing of the robot is above part of the bin.
struct TerrainEstimate {
    Heights mean{}, sd{}, q10{}, q90{};
    Heights
        height{};  ///< the one number to show: the mean, as in the paper, for its four methods; the
                   ///< median for the others, whose distributions are skew
    Heights ceiling{};
    std::array<Origin, kBins> origin{};
    TouchMap touch = unrecordedTouch();  ///< see core/infer/estimate/touch.h
    double feltTo =
        binBegin(0);  ///< x of the foremost loaded force element [m], DEM frame; binBegin(0): none
    Heights rhat{};   ///< rank-normalised split R-hat; 1 for a bin that was not sampled
    Heights
        ess{};  ///< bulk effective sample size; the number of draws for a bin that was not sampled
    std::vector<Heights> draws;  ///< of all bins together: what a joint question is asked of;
                                 ///< at most settings.draws, rounded up to full chains
    double novelty = 0.0;        ///< how unlike the training scenes this one is, see
                                 ///< core/learn/model/clearance_model.h; above 1 for 1 % of those;
                                 ///< 0: not judged (all but the closed forms)
    MissingFeatures missing{};   ///< what the method would have used and was not measured
    Ending ending = Ending::NotSampled;
    bool converged = true;  ///< R-hat ≤ 1.01 and ESS ≥ 400 for every sampled bin
    /// A posterior check failed: on the estimate's ground the robot would read something else, see
    /// core/sim/posterior_check.h. false where none was made.
    bool contradicts = false;
    std::vector<std::string> warnings;  ///< what makes the result doubtful, in words
    Settings settings;
    bool operator==(const TerrainEstimate&) const = default;

    /// Sampled, and no part of the robot is above it: nothing but the training set speaks for this bin.
    bool priorOnly(int bin) const
    {
        const auto i = static_cast<std::size_t>(bin);
        return origin[i] == Origin::Sampled && std::isinf(ceiling[i]);
    }
};

/// The limits of "converged" (Vehtari et al. 2021).
inline constexpr double kRhatLimit = 1.01;
inline constexpr double kEssLimit = 400.0;

}  // namespace terratact
