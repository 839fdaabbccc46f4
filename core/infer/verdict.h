#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/infer/estimate.h"
#include "core/infer/obstacle.h"
#include "core/robot/measurement.h"

namespace terratact {

/// The answer to "can I drive on?".
enum class Outlook : std::uint8_t { Clear, Blocked, CannotTell };

/// "CLEAR", "BLOCKED", "CANNOT TELL".
std::string_view name(Outlook outlook);

/// Why an estimate gives no answer although its draws have one.
enum class Doubt : std::uint8_t {
    Stale,           ///< the robot is not heard: it may have moved
    Unheard,         ///< for a while it was not, since the scene
    NotConverged,    ///< more sweeps might say something else
    UnlikeTraining,  ///< the scene is unlike all that the model has learnt
    Roll,            ///< left and right ground differ, the estimate knows one profile
    Asymmetry        ///< so say the flippers
};

/// "the chains have not converged" and the like.
std::string describe(Doubt doubt);

struct Verdict {
    Outlook outlook = Outlook::CannotTell;
    StepProbability step;  ///< of some step ahead; {0, 1} where there are no draws
    int likeliest = 0;  ///< rear bin of the pair of neighbours ahead that likeliest differs so much
    double likeliestP = 0.0;    ///< and its probability
    std::vector<int> unfelt{};  ///< bins ahead of which the training set alone speaks
    std::vector<Doubt> doubts;  ///< not empty: withheld, and outlook is CannotTell
    bool operator==(const Verdict&) const = default;
};

/// "not felt: +0.6 m, +0.7 m"; empty: all ahead was.
std::string describeUnfelt(const Verdict& verdict);

/// The risks that decide.  An answer takes two Monte-Carlo sd of distance.
inline constexpr double kClearBelow = 0.05;
inline constexpr double kBlockedAbove = 0.95;

/// What came after the scene; by itself: nothing, as of a scene in a file.
struct Aftermath {
    bool heard = true;     ///< its telemetry is live
    bool unbroken = true;  ///< and there was no silence of more than kLongestSilence
};

/// With p = P(a step of more than `limit` within bins kFirstAhead … 10), as hasStep() has it, and its Monte-Carlo sd m,
///   Clear       p + 2 m < kClearBelow
///   Blocked     p − 2 m > kBlockedAbove
///   CannotTell  else, or with any doubt, or without draws.
/// scene: what the estimate rests on; its settings' limits say when roll or asymmetry are doubts.
/// limit: [m].  Throws std::invalid_argument for a limit below 0 or not finite.
Verdict verdictOf(const TerrainEstimate& estimate, const Measurement& scene, const Aftermath& since,
                  double limit);

}  // namespace terratact
