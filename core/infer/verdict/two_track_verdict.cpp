#include "core/infer/verdict/two_track_verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/infer/estimate/hazards.h"
#include "core/robot/attitude.h"
#include "core/robot/side_plane.h"

namespace terratact {
namespace {

using BothBins = std::array<int, 2>;

std::size_t drawsOfBoth(const TwoTrackEstimate& estimate)
{
    const std::size_t count = estimate.side[0].draws.size();
    if (count == 0 || count != estimate.side[1].draws.size())
        throw std::invalid_argument("two tracks need the same number of joint draws on both sides");
    return count;
}

double jointEffectiveDraws(const TwoTrackEstimate& estimate)
{
    return std::min(effectiveDraws(estimate.side[0]), effectiveDraws(estimate.side[1]));
}

/// Returns a share of draws with its error; 0 and 1 are never certain, as in stepProbability().
StepProbability shareOf(std::size_t hits, std::size_t draws, double effective)
{
    const double p = static_cast<double>(hits) / static_cast<double>(draws);
    const double shown = hits > 0 && hits < draws ? p : 1.0 / (effective + 2.0);
    return {p, std::sqrt(shown * (1.0 - shown) / effective)};
}

bool isBelow(const StepProbability& p, double limit)
{
    return p.p + 2.0 * p.monteCarloSd < limit;
}

bool isAbove(const StepProbability& p, double limit)
{
    return p.p - 2.0 * p.monteCarloSd > limit;
}

/// Returns the last bin behind the horizon of a side.
int lastBinOf(const Verdict& verdict)
{
    int last = kFirstAhead;
    while (last + 1 < kBins && binEnd(last + 1) <= verdict.horizon + 1e-9) ++last;
    return last;
}

Message answerOf(const Verdict& verdict)
{
    if (verdict.stepVerdict == StepVerdict::Blocked)
        return {TR_NOOP("core", "%1 at %2 m"), describe(verdict.stepVerdict),
                signedFixed(binCentre(verdict.likeliest + 1), 1)};
    return stepVerdictMessage(verdict);
}

/// Returns the robot's answer as far as those of the sides determine it.
StepVerdict answerOfSides(const TwoTrackVerdict& verdict)
{
    const auto is = [](StepVerdict answer) {
        return [answer](const Verdict& side) { return side.stepVerdict == answer; };
    };
    if (std::ranges::any_of(verdict.side, is(StepVerdict::Blocked))) return StepVerdict::Blocked;
    if (std::ranges::all_of(verdict.side, is(StepVerdict::Clear))) return StepVerdict::Clear;
    return StepVerdict::CannotTell;
}

/// Returns the attitude of one side as that of a robot on one plane.
Measurement lineOf(const TwoTrackReadings& s, Side side)
{
    const Proprioception own = sideReadings(s, side);
    Measurement line;
    line.pitch = own.pitch;
    line.frontLeft = line.frontRight = own.front;
    line.rearLeft = line.rearRight = own.rear;
    return line;
}

/// Returns the limit of the side to which a robot on this cross slope tips over. Left up: positive.
double slopeLimit(const TipOver& tips, double angle)
{
    return (angle >= 0.0 ? tips.leftUp : tips.rightUp) - kRedReserve;
}

/// Returns what an angle leaves to the limit of its side [rad].
double slopeReserve(const TipOver& tips, double angle)
{
    return slopeLimit(tips, angle) - std::abs(angle);
}

double degrees(double angle)
{
    return angle * 180.0 / std::numbers::pi;
}

}  // namespace

StepProbability eitherStep(const TwoTrackEstimate& estimate, double limit, int firstBin,
                           std::array<int, 2> lastBins)
{
    if (!(limit >= 0.0) || !std::isfinite(limit))
        throw std::invalid_argument("eitherStep: the limit must be finite and 0 m or more");
    const std::size_t count = drawsOfBoth(estimate);
    std::size_t steps = 0;
    for (std::size_t k = 0; k < count; ++k)
        steps += hasStep(estimate.side[0].draws[k], limit, firstBin, lastBins[0])
                      || hasStep(estimate.side[1].draws[k], limit, firstBin, lastBins[1])
                   ? 1
                   : 0;
    StepProbability either = shareOf(steps, count, jointEffectiveDraws(estimate));
    double neither = 1.0;
    for (std::size_t i = 0; i < 2; ++i)
        if (lastBins[i] > firstBin)
            neither *= 1.0 - unfeltStepRate(estimate.side[i], firstBin, lastBins[i]);
    either.p = std::max(either.p, 1.0 - neither);
    return either;
}

CrossSlope crossSlopeAhead(const TwoTrackEstimate& estimate, const RobotModel& robot,
                           const TwoTrackReadings& s, int lastBin)
{
    const std::size_t count = drawsOfBoth(estimate);
    const Proprioception mean = planeReadings(s);
    const TipOver tips = tipOver(robot, mean.front, mean.rear);
    CrossSlope slope;
    const double width = 2.0 * robot.lateral.flipperY;
    std::array<std::size_t, kBins> hits{};
    std::size_t any = 0;
    std::vector<double> steepest(count);
    for (std::size_t k = 0; k < count; ++k) {
        bool hit = false;
        for (std::size_t i = std::size_t{kFirstAhead}; i <= static_cast<std::size_t>(lastBin);
             ++i) {
            const double angle =
                std::atan((estimate.side[0].draws[k][i] - estimate.side[1].draws[k][i]) / width);
            const double reserve = slopeReserve(tips, angle);
            if (i == std::size_t{kFirstAhead} || reserve < slopeReserve(tips, steepest[k]))
                steepest[k] = angle;
            if (reserve >= 0.0) continue;
            ++hits[i];
            hit = true;
        }
        any += hit ? 1 : 0;
    }
    const auto middle = steepest.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(steepest.begin(), middle, steepest.end());
    slope.steepest = *middle;
    slope.limit = slopeLimit(tips, slope.steepest);
    slope.bin =
        static_cast<int>(std::max_element(hits.begin() + kFirstAhead, hits.end()) - hits.begin());
    slope.beyond = shareOf(any, count, jointEffectiveDraws(estimate));
    return slope;
}

TwoTrackVerdict equalSides(const Verdict& plane)
{
    TwoTrackVerdict verdict;
    verdict.side = {plane, plane};
    verdict.either = plane.step;
    if (plane.stepVerdict == StepVerdict::Clear) verdict.eitherToHorizons = plane.toHorizon;
    verdict.both = plane.stepVerdict;
    verdict.onePlane = true;
    return verdict;
}

const StepProbability& answeredBy(const TwoTrackVerdict& verdict)
{
    return verdict.both == StepVerdict::Clear ? verdict.eitherToHorizons : verdict.either;
}

bool isWithheld(const TwoTrackVerdict& verdict)
{
    return std::ranges::any_of(verdict.side,
                               [](const Verdict& side) { return !side.withheldFor.empty(); });
}

bool hasCannotTell(const TwoTrackVerdict& verdict)
{
    return verdict.both == StepVerdict::CannotTell
        || std::ranges::count(verdict.side, StepVerdict::CannotTell, &Verdict::stepVerdict) > 0;
}

TwoTrackVerdict verdictOf(const TwoTrackEstimate& estimate, const RobotModel& robot,
                          const TwoTrackReadings& s, double limit, const LinkSinceScene& since)
{
    TwoTrackVerdict verdict;
    verdict.side = {verdictOf(estimate.side[0], lineOf(s, Side::Left), since, limit),
                    verdictOf(estimate.side[1], lineOf(s, Side::Right), since, limit)};
    verdict.either = eitherStep(estimate, limit);
    verdict.crossSlope = crossSlopeAhead(estimate, robot, s);
    const BothBins horizons{lastBinOf(verdict.side[0]), lastBinOf(verdict.side[1])};
    const StepVerdict sides = answerOfSides(verdict);
    if (isWithheld(verdict)) return verdict;
    if (sides == StepVerdict::Clear)
        verdict.eitherToHorizons = eitherStep(estimate, limit, kFirstAhead, horizons);
    if (sides == StepVerdict::Clear && isBelow(verdict.eitherToHorizons, kClearBelow)
        && isBelow(crossSlopeAhead(estimate, robot, s, std::min(horizons[0], horizons[1])).beyond,
                   kClearBelow))
        verdict.both = StepVerdict::Clear;
    if (sides == StepVerdict::Blocked || isAbove(verdict.either, kBlockedAbove)
        || isAbove(verdict.crossSlope.beyond, kBlockedAbove))
        verdict.both = StepVerdict::Blocked;
    return verdict;
}

TwoTrackVerdict verdictOf(const TwoTrackEstimate& estimate, const RobotModel& robot,
                          const Measurement& line, const LinkSinceScene& since, double limit)
{
    const TwoTrackReadings s = twoTrackReadings(line);
    const auto& [left, right] = estimate.side;
    const bool isJoint = !left.draws.empty() && left.draws.size() == right.draws.size();
    if (!estimate.onePlane && isJoint) return verdictOf(estimate, robot, s, limit, since);
    TwoTrackVerdict verdict;
    if (estimate.onePlane) {
        verdict = equalSides(verdictOf(left, line, since, limit));
    } else {
        verdict.side = {verdictOf(left, lineOf(s, Side::Left), since, limit),
                        verdictOf(right, lineOf(s, Side::Right), since, limit)};
        verdict.either = {0.0, 1.0};
    }
    const Proprioception mean = proprioception(line);
    verdict.crossSlope.limit = slopeLimit(tipOver(robot, mean.front, mean.rear), 0.0);
    return verdict;
}

Message messageOf(const TwoTrackVerdict& verdict)
{
    if (verdict.onePlane) return stepVerdictMessage(verdict.side[0]);
    const Message left = answerOf(verdict.side[0]), right = answerOf(verdict.side[1]);
    const bool agree = verdict.both == answerOfSides(verdict);
    std::vector<Message> parts;
    if (!agree) parts.emplace_back(TR_NOOP("core", "%1 for the robot"), describe(verdict.both));
    if (left == right)
        parts.emplace_back(agree ? TR_NOOP("core", "both %1") : TR_NOOP("core", "each side %1"),
                           left);
    else
        parts.emplace_back(TR_NOOP("core", "left %1 · right %2"), left, right);
    const CrossSlope& slope = verdict.crossSlope;
    if (std::abs(slope.steepest) > slope.limit + kRedReserve - kAmberReserve)
        parts.emplace_back(TR_NOOP("core", "cross slope %1° of %2°"),
                           fixed(std::abs(degrees(slope.steepest)), 0),
                           fixed(degrees(slope.limit + kRedReserve), 0));
    return Message::listed(std::move(parts), " · ");
}

std::string describe(const TwoTrackVerdict& verdict)
{
    return messageOf(verdict).english();
}

}  // namespace terratact
