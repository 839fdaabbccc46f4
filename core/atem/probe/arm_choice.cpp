#include "core/atem/probe/arm_choice.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

constexpr std::array kOfOnePlane{ProbeSide::Middle};
constexpr std::array kOfBothSides{ProbeSide::Left, ProbeSide::Right};

/// Returns true if the arm can measure the bin's height and nothing has measured it yet. estimate: of
/// the place's side.
bool isOpen(const TerrainEstimate& estimate, const RobotModel& robot, ProbePlace place)
{
    return robot.armSd > 0.0 && robot.armReaches(place.bin, place.side)
        && estimate.origin[static_cast<std::size_t>(place.bin)] == Origin::Sampled;
}

bool hasOpenBin(const TerrainEstimate& estimate, const RobotModel& robot, ProbeSide side)
{
    for (int bin = 0; bin < kBins; ++bin)
        if (isOpen(estimate, robot, {bin, side})) return true;
    return false;
}

/// Widest open bin of a side whose sd exceeds a limit.
struct WidestBin {
    std::optional<ProbePlace> place;
    double sd = 0.0;
};

void widen(WidestBin& widest, const TerrainEstimate& estimate, const RobotModel& robot,
           ProbeSide side)
{
    for (int bin = 0; bin < kBins; ++bin) {
        const double sd = estimate.sd[static_cast<std::size_t>(bin)];
        if (isOpen(estimate, robot, {bin, side}) && sd > widest.sd)
            widest = {ProbePlace{bin, side}, sd};
    }
}

std::optional<int> binOf(const std::optional<ProbePlace>& place)
{
    return place ? std::optional(place->bin) : std::nullopt;
}

/// Returns the advice of an estimate with draws. isOpenAt: whether the arm can measure a place.
template <class Estimate, class IsOpenAt>
void addGains(ProbeAdvice& advice, const Estimate& estimate, const RobotModel& robot,
              const Settings& settings, const Poll& poll, IsOpenAt&& isOpenAt)
{
    advice.gains = probeGains(estimate, robot, robot.armSd, advice.stepLimit, kFirstAhead, poll);
    std::erase_if(advice.gains, [&](const ProbeGain& gain) { return !isOpenAt(gain.place()); });
    if (advice.place && !isOfPaper(settings.method)) advice.place = advice.gains.front().place();
}

std::optional<ProbePlace> widestOf(const TerrainEstimate& estimate, const RobotModel& robot)
{
    WidestBin widest{.place = {}, .sd = estimate.settings.probeAbove};
    widen(widest, estimate, robot, ProbeSide::Middle);
    return widest.place;
}

}  // namespace

std::span<const ProbeSide> sidesToProbe(const TwoTrackEstimate& estimate)
{
    if (estimate.onePlane) return kOfOnePlane;
    return kOfBothSides;
}

std::optional<int> proposeProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    return binOf(widestOf(estimate, robot));
}

std::optional<ProbePlace> proposeProbe(const TwoTrackEstimate& estimate, const RobotModel& robot)
{
    WidestBin widest{.place = {}, .sd = estimate.side[0].settings.probeAbove};
    for (const ProbeSide side : sidesToProbe(estimate))
        widen(widest, sideOf(estimate, side), robot, side);
    return widest.place;
}

std::optional<int> chooseProbe(const TerrainEstimate& estimate, const RobotModel& robot)
{
    constexpr double kAnyStep = 0.1;  // [m]; the rule by variance does not use it
    const std::optional<int> widest = proposeProbe(estimate, robot);
    if (!widest || isOfPaper(estimate.settings.method) || estimate.draws.empty()) return widest;
    const auto best = bestProbe(estimate, robot, robot.armSd, kAnyStep);
    return best ? best->bin : widest;
}

std::optional<ProbePlace> chooseProbe(const TwoTrackEstimate& estimate, const RobotModel& robot)
{
    constexpr double kAnyStep = 0.1;  // [m]; the rule by variance does not use it
    return adviseProbe(estimate, robot, kAnyStep).place;
}

ProbeAdvice adviseProbe(const TerrainEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll)
{
    ProbeAdvice advice;
    advice.stepLimit = stepLimit;
    advice.place = widestOf(estimate, robot);
    if (estimate.draws.empty()) return advice;
    advice.before = uncertainty(estimate, stepLimit, kFirstAhead, poll);
    if (!hasOpenBin(estimate, robot, ProbeSide::Middle)) return advice;
    addGains(advice, estimate, robot, estimate.settings, poll,
             [&](ProbePlace place) { return isOpen(estimate, robot, place); });
    return advice;
}

ProbeAdvice adviseProbe(const TwoTrackEstimate& estimate, const RobotModel& robot, double stepLimit,
                        const Poll& poll)
{
    if (estimate.onePlane) return adviseProbe(estimate.side[0], robot, stepLimit, poll);
    ProbeAdvice advice;
    advice.stepLimit = stepLimit;
    advice.place = proposeProbe(estimate, robot);
    if (estimate.side[0].draws.empty()) return advice;
    advice.before = uncertainty(estimate, stepLimit, kFirstAhead, poll);
    const auto isOpenAt = [&](ProbePlace place) {
        return isOpen(sideOf(estimate, place.side), robot, place);
    };
    const bool isAnyOpen = std::ranges::any_of(kOfBothSides, [&](ProbeSide side) {
        return hasOpenBin(sideOf(estimate, side), robot, side);
    });
    if (isAnyOpen) addGains(advice, estimate, robot, estimate.side[0].settings, poll, isOpenAt);
    return advice;
}

}  // namespace terratact
