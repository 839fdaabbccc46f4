#pragma once

#include <array>
#include <string>

#include "core/base/message.h"
#include "core/infer/estimate/two_track_estimate.h"
#include "core/infer/verdict/verdict.h"
#include "core/robot/robot_model.h"
#include "core/robot/two_tracks.h"

namespace terratact {

/// Returns the probability of a step of more than `limit` [m] on either side, within firstBin …
/// lastBins (left, right). It is the share of joint draws with a step on one side or both. It is at
/// least
///   1 − (1 − r_left) (1 − r_right),   r: unfeltStepRate() of a side.
/// A side whose last bin is not above firstBin has no step. The error is that of stepProbability().
/// Throws std::invalid_argument for no draws, different numbers of draws, and a limit below 0 or not
/// finite.
StepProbability eitherStep(const TwoTrackEstimate& estimate, double limit,
                           int firstBin = kFirstAhead,
                           std::array<int, 2> lastBins = {kBins - 1, kBins - 1});

/// Cross slope ahead: the roll of a robot whose tracks both follow the estimated ground,
///   φ_i = atan((h_left,i − h_right,i) / distance of the lines).
/// i runs from kFirstAhead to a last bin. The lines are those of the flippers.
struct CrossSlope {
    /// [rad] median over the draws of the φ_i that leaves the least to its side's limit
    double steepest = 0.0;
    int bin = kFirstAhead;  ///< bin with the largest probability of exceeding the limit
    /// [rad] tip-over angle to the side of `steepest`, less kRedReserve (attitude.h)
    double limit = 0.0;
    /// Probability that |φ_i| exceeds its side's limit in some bin, with its Monte-Carlo error.
    StepProbability beyond;
    bool operator==(const CrossSlope&) const = default;
};
CrossSlope crossSlopeAhead(const TwoTrackEstimate& estimate, const RobotModel& robot,
                           const TwoTrackReadings& s, int lastBin = kBins - 1);

struct TwoTrackVerdict {
    std::array<Verdict, 2> side;  ///< left, right, each from its own draws
    StepProbability either;       ///< probability of a step ahead on either side
    /// The same up to the horizon of each side. Unset unless both sides are Clear.
    StepProbability eitherToHorizons;
    CrossSlope crossSlope;  ///< of all bins ahead
    /// Answer for the robot. Blocked if a side or the cross slope is blocked, or if a step on either
    /// side has Blocked's probability. Clear if both sides are clear, and the joint probability up
    /// to both horizons. The cross slope must be clear up to the nearer one. CannotTell else, and
    /// where the verdict of a side is withheld.
    StepVerdict both = StepVerdict::CannotTell;
    /// True if the estimate is of one plane: the sides are equal, and both is their answer.
    bool onePlane = false;
    bool operator==(const TwoTrackVerdict&) const = default;
};

/// Returns the verdict of one plane for both sides, without a cross slope.
TwoTrackVerdict equalSides(const Verdict& plane);

/// Returns the probability of a step on either side that the robot's answer rests on. Clear counts
/// bins up to the horizons, other answers all bins ahead.
const StepProbability& answeredBy(const TwoTrackVerdict& verdict);

/// Returns true if a side's verdict is withheld.
bool isWithheld(const TwoTrackVerdict& verdict);

/// Returns true if the answer for the robot or that of a side is CannotTell.
bool hasCannotTell(const TwoTrackVerdict& verdict);

/// Decides for a scene of two tracks by the rules of verdictOf(). Roll and different flippers are no
/// reason to withhold: both sides are estimated. limit: [m]. Throws as verdictOf().
TwoTrackVerdict verdictOf(const TwoTrackEstimate& estimate, const RobotModel& robot,
                          const TwoTrackReadings& s, double limit,
                          const LinkSinceScene& since = {});

/// Decides for the line of telemetry that the estimate rests on. An estimate of one plane has that
/// plane's verdict on both sides, with its limits of roll and asymmetry. Its cross slope is 0. An
/// estimate of both sides has the verdict above. Without joint draws nothing is known of the robot:
/// CannotTell, {0, 1}.
TwoTrackVerdict verdictOf(const TwoTrackEstimate& estimate, const RobotModel& robot,
                          const Measurement& line, const LinkSinceScene& since, double limit);

/// Returns "left BLOCKED at +0.4 m · right CLEAR to +0.55 m", or "both CLEAR to +0.55 m" for equal
/// verdicts. If the robot's verdict does not follow from those of the sides, it precedes them. An
/// example is "CANNOT TELL for the robot · each side CLEAR to +0.55 m". One plane:
/// stepVerdictMessage(). A cross slope within kAmberReserve of the tip-over angle follows: "cross
/// slope 41° of 54°".
Message messageOf(const TwoTrackVerdict& verdict);
/// Returns messageOf() in English.
std::string describe(const TwoTrackVerdict& verdict);

}  // namespace terratact
