#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/infer/estimate/estimate.h"
#include "core/infer/verdict/obstacle.h"
#include "core/robot/measurement.h"

namespace terratact {

/// The answer to "can I drive on?".
enum class StepVerdict : std::uint8_t { Clear, Blocked, CannotTell };

/// "CLEAR", "BLOCKED", "CANNOT TELL".
std::string_view name(StepVerdict stepVerdict);

/// Why an estimate gives no answer although its draws have one.
enum class Doubt : std::uint8_t {
    Stale,           ///< the robot is not heard: it may have moved
    Unheard,         ///< for a while it was not, since the scene
    NotConverged,    ///< more sweeps might say something else
    UnlikeTraining,  ///< the scene is unlike all that the model has learnt
    Roll,            ///< left and right ground differ, the estimate knows one profile
    Asymmetry,       ///< so say the flippers
    SensorFault,     ///< SensorWatch suspected a sensor at the scene
    Contradiction    ///< on the estimate's ground the robot would read something else
};

/// "the chains have not converged" and the like.
std::string describe(Doubt doubt);

/// Why the felt ground does not carry a CLEAR, although the draws hold no step there.
enum class Shortfall : std::uint8_t {
    None,          ///< it does, or the touch is not recorded
    NothingFelt,   ///< no force element carries load, and the arm measured nothing ahead
    ShortHorizon,  ///< the front flippers reach further than what they press on
    Spanned        ///< bins before the horizon are bounded or felt in part only
};
inline constexpr int kShortfalls = 4;

/// "the front flippers press on nothing" and the like; empty for None.
std::string describe(Shortfall shortfall);

/// What would help a CANNOT TELL besides a probe.
enum class Help : std::uint8_t {
    Nothing,  ///< only a probe, or the verdict needs no help
    Flatten,  ///< flatter front flippers reach further
    DriveOn   ///< 0.1 m on, the flippers' tips press on other ground
};

/// "lay the front flippers flatter" and the like; empty for Nothing.
std::string describe(Help help);

struct Verdict {
    StepVerdict stepVerdict = StepVerdict::CannotTell;
    StepProbability step;  ///< of some step ahead; {0, 1} where there are no draws
    int likeliest = 0;  ///< rear bin of the pair of neighbours ahead that likeliest differs so much
    double likeliestP = 0.0;    ///< and its probability
    std::vector<int> unfelt{};  ///< bins ahead that are bounded or not felt
    std::vector<Doubt> doubts;  ///< not empty: withheld, and outlook is CannotTell
    /// x to which the ground ahead is felt [m], a bin's front border; binBegin(kFirstAhead): nothing ahead is.
    /// The last bin's border where the touch is not recorded.
    double horizon = binEnd(kBins - 1);
    StepProbability
        toHorizon;  ///< of some step from kFirstAhead to the horizon; {1, 0} where there is none
    Shortfall shortfall = Shortfall::None;
    Help help = Help::Nothing;
    bool touchRecorded = false;
    bool operator==(const Verdict&) const = default;
};

/// "not felt: +0.6 m, +0.7 m"; empty: all ahead was.
std::string describeUnfelt(const Verdict& verdict);

/// "CLEAR to +0.55 m", "BLOCKED", "CANNOT TELL".
std::string describeStepVerdict(const Verdict& verdict);

/// Whether a bin ahead is bounded or not felt; where the touch is not recorded, whether nothing but the training set
/// speaks for it (TerrainEstimate::priorOnly).  bin: 0 … 10.
bool isUnfeltAhead(const TerrainEstimate& estimate, int bin);

/// Verdict::horizon; empty where nothing ahead is felt, or the touch is not recorded.
std::optional<double> feltHorizon(const TerrainEstimate& estimate);

/// The risks that decide.  An answer takes two Monte-Carlo sd of distance.
inline constexpr double kClearBelow = 0.05;
inline constexpr double kBlockedAbove = 0.95;

/// A step takes two bins: a horizon before the second bin ahead gives no CLEAR.
inline constexpr int kMinHorizonBin = kFirstAhead + 1;

/// The foremost loaded element may end this much behind a bin's front border [m].
inline constexpr double kHorizonSlack = 0.01;

/// Front flippers at a steeper angle to the horizontal reach further when they lie flatter [rad].
inline constexpr double kSteepFlipper = 0.35;

/// What came after the scene; by itself: nothing, as of a scene in a file.
struct LinkSinceScene {
    bool heard = true;     ///< its telemetry is live
    bool unbroken = true;  ///< and there was no silence of more than kMaxSilence
    bool sensorsSound =
        true;  ///< no sensor was suspected, in the scene or since, while the robot stood there
};

/// The horizon is the front border of the last bin ahead that is felt, or before which a loaded element lies
/// (kHorizonSlack). The reach is the last bin ahead with a finite ceiling. With p(a, b) = P(a step of more than
/// `limit` within bins a … b) as anyStep() has it, its Monte-Carlo sd m, and h the horizon's bin:
///   Blocked     p(kFirstAhead, 10) − 2 m > kBlockedAbove
///   Clear       p(kFirstAhead, h) + 2 m < kClearBelow, h ≥ the reach, h ≥ kMinHorizonBin
///   CannotTell  else, or with any doubt, or without draws.
/// Where the touch is not recorded, h is the last bin.
/// scene: what the estimate rests on; its settings' limits say when roll or asymmetry are doubts.
/// limit: [m].  Throws std::invalid_argument for a limit below 0 or not finite.
Verdict verdictOf(const TerrainEstimate& estimate, const Measurement& scene,
                  const LinkSinceScene& since, double limit);

/// The same of a scene in a file: left and right are alike, the robot is level sideways.
Verdict verdictOf(const TerrainEstimate& estimate, const Proprioception& scene, double limit);

}  // namespace terratact
