#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/message.h"
#include "core/infer/estimate/estimate.h"
#include "core/infer/estimate/felt_horizon.h"
#include "core/infer/verdict/obstacle.h"
#include "core/robot/measurement.h"

namespace terratact {

/// The answer to "can I drive on?".
enum class StepVerdict : std::uint8_t { Clear, Blocked, CannotTell };

/// Returns "CLEAR", "BLOCKED" or "CANNOT TELL".
std::string_view name(StepVerdict stepVerdict);

/// Returns the same for the operator.
SourceText describe(StepVerdict stepVerdict);

/// Reason to withhold the answer that the draws would give.
enum class WithholdReason : std::uint8_t {
    Stale,           ///< telemetry is stale: the robot may have moved
    TelemetryGap,    ///< telemetry was interrupted since the scene
    NotConverged,    ///< more sweeps might change the answer
    UnlikeTraining,  ///< the scene is unlike every training scene
    Roll,            ///< roll: left and right ground differ, but the estimate has one profile
    Asymmetry,       ///< left and right flippers differ: so may the ground
    Differential,    ///< the track differential has turned: left and right ground differ
    SensorFault,     ///< SensorWatch suspected a sensor at the scene
    Contradiction    ///< on the estimated ground the robot would read other values
};

/// Returns a sentence such as "the chains have not converged".
SourceText describe(WithholdReason reason);

/// Reason why the felt ground does not allow CLEAR, although the draws hold no step there.
enum class Shortfall : std::uint8_t {
    None,          ///< it allows CLEAR, or the touch is not recorded
    NothingFelt,   ///< no force element carries load, and no bin ahead is felt
    ShortHorizon,  ///< the front flippers reach further than the ground they press on
    Spanned        ///< bins before the horizon are only bounded or felt in part
};

/// Returns a sentence such as "the front flippers press on nothing"; empty for None.
SourceText describe(Shortfall shortfall);

/// Remedy for a CANNOT TELL besides a probe.
enum class Help : std::uint8_t {
    Nothing,  ///< only a probe would, or the verdict needs no help
    Flatten,  ///< flatter front flippers reach further
    DriveOn   ///< 0.1 m on, the flippers' tips press on other ground
};

/// Returns a sentence such as "lay the front flippers flatter"; empty for Nothing.
SourceText describe(Help help);

struct Verdict {
    StepVerdict stepVerdict = StepVerdict::CannotTell;
    StepProbability step;  ///< probability of a step ahead; {0, 1} without draws
    /// Rear bin of the pair of neighbours ahead with the largest probability of a step.
    int likeliest = 0;
    double likeliestP = 0.0;     ///< probability of a step in that pair
    std::vector<int> unfelt{};   ///< bins ahead that are bounded or not felt
    std::vector<int> bounded{};  ///< those of `unfelt` that are bounded
    /// Not empty: the answer is withheld, and stepVerdict is CannotTell.
    std::vector<WithholdReason> withheldFor;
    /// x up to which CLEAR reaches [m], the front border of horizonBin(). binBegin(kFirstAhead):
    /// nothing ahead is felt. The last bin's border where the touch is not recorded.
    double horizon = binEnd(kBins - 1);
    /// x up to which every bin ahead is felt [m], at most `horizon`: the front border of
    /// lastFeltBin(). It is less than `horizon` where the flippers span ground.
    double feltTo = binEnd(kBins - 1);
    /// Probability of a step from kFirstAhead to the horizon; {1, 0} for less than two bins, or
    /// without draws.
    StepProbability toHorizon;
    Shortfall shortfall = Shortfall::None;
    Help help = Help::Nothing;
    bool touchRecorded = false;
    bool operator==(const Verdict&) const = default;
};

/// Returns true for Clear up to a horizon, which needs a recorded touch.
bool isClearToHorizon(const Verdict& verdict);

/// Returns the probability of a step that the answer rests on: up to that horizon, else of all bins
/// ahead.
const StepProbability& answeredBy(const Verdict& verdict);

/// Returns the bins of `unfelt` that are not felt, and not bounded either.
std::vector<int> notFelt(const Verdict& verdict);

/// Returns true if no bin ahead is felt, so that `feltTo` is behind the first one.
bool isNothingFeltAhead(const Verdict& verdict);

/// Returns "+0.6 m, +0.7 m".
Message placesOf(const std::vector<int>& bins);

/// Returns "bounded: +0.3 m; not felt: +0.6 m, +0.7 m", or one of the two; empty if all ahead is felt.
Message unfeltMessage(const Verdict& verdict);

/// Returns "CLEAR to +0.55 m", "BLOCKED" or "CANNOT TELL". Over spanned ground: "CLEAR to +0.55 m,
/// felt to +0.35 m", or "CLEAR to +0.55 m, nothing felt ahead".
Message stepVerdictMessage(const Verdict& verdict);

/// Returns true if a bin ahead is bounded or not felt. Where the touch is not recorded: if only the
/// training set supports the bin (TerrainEstimate::priorOnly). bin: 0 … 10.
bool isUnfeltAhead(const TerrainEstimate& estimate, int bin);

/// Limits of the probability of a step for CLEAR and BLOCKED. The answer needs a distance of two
/// Monte-Carlo sd.
inline constexpr double kClearBelow = 0.05;
inline constexpr double kBlockedAbove = 0.95;

/// Rearmost horizon bin that allows CLEAR: a step takes two bins.
inline constexpr int kMinHorizonBin = kFirstAhead + 1;

/// Front flippers steeper than this [rad] to the horizontal reach further when they lie flatter.
inline constexpr double kSteepFlipper = 0.35;

/// State of the link and the sensors since the scene. The defaults hold for a scene from a file.
struct LinkSinceScene {
    bool telemetryFresh = true;  ///< telemetry is live
    bool unbroken = true;        ///< no silence of more than kMaxSilence since the scene
    /// No sensor was suspected at the scene, or later while the robot stood there.
    bool sensorsSound = true;
};

/// Decides CLEAR, BLOCKED or CANNOT TELL. p(a, b) is P(a step of more than `limit` within bins a …
/// b) by anyStep(). m is its Monte-Carlo sd, and h the bin of the horizon:
///   Blocked     p(kFirstAhead, 10) − 2 m > kBlockedAbove
///   Clear       p(kFirstAhead, h) + 2 m < kClearBelow, h ≥ the reach, h ≥ kMinHorizonBin
///   CannotTell  else, or with any WithholdReason, or without draws.
/// The horizon is the front border of the last bin ahead that is felt, now or earlier. A bin behind
/// a loaded element counts too (kHorizonSlack). The reach is the last bin ahead with a finite
/// ceiling. Where the touch is not recorded, h is the last bin.
/// scene: the measurement that the estimate rests on. The limits in estimate.settings decide when
/// roll or asymmetry withholds the verdict. limit: [m].
/// Throws std::invalid_argument for a limit below 0 or not finite.
Verdict verdictOf(const TerrainEstimate& estimate, const Measurement& scene,
                  const LinkSinceScene& since, double limit);

/// Decides for a scene from a file, with equal left and right sides and no roll.
Verdict verdictOf(const TerrainEstimate& estimate, const Proprioception& scene, double limit);

}  // namespace terratact
