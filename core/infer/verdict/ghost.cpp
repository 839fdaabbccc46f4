#include "core/infer/verdict/ghost.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/base/message.h"

namespace terratact {
namespace {

constexpr double kOnABin = 1e-9;  // share of a bin's width

/// Position of a bin among the bins of the scene: `share` of the way from bin `rear` to the next.
struct Place {
    int rear = 0;
    double share = 0.0;
};

std::optional<Place> placeOf(double x)
{
    const double position = (x - binCentre(0)) / kBinWidth;
    const double nearest = std::round(position);
    const double snapped = std::abs(position - nearest) < kOnABin ? nearest : position;
    if (!(snapped >= 0.0 && snapped <= kBins - 1)) return std::nullopt;
    const int rear = static_cast<int>(std::floor(snapped));
    return Place{rear, snapped - rear};
}

bool known(const TerrainEstimate& estimate, const Place& place)
{
    return !estimate.priorOnly(place.rear)
        && (place.share == 0.0 || !estimate.priorOnly(place.rear + 1));
}

double between(const Heights& values, const Place& place)
{
    const auto i = static_cast<std::size_t>(place.rear);
    return place.share == 0.0 ? values[i]
                              : (1.0 - place.share) * values[i] + place.share * values[i + 1];
}

/// Returns the sd that the motion adds, for the steepest slope to a neighbour.
double movedSd(const Heights& heights, const Place& place, const ImuMotion& motion)
{
    std::vector<double> slopes;
    slopes.reserve(3);
    const int last = place.share == 0.0 ? place.rear : place.rear + 1;
    for (int bin = std::max(1, place.rear); bin <= std::min(kBins - 1, last + 1); ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        slopes.push_back((heights[i] - heights[i - 1]) / kBinWidth);
    }
    return carriedSd(motion, slopes);
}

GhostBin moved(const TerrainEstimate& estimate, const Place& place, const ImuMotion& motion)
{
    const GhostBin bin{between(estimate.height, place), between(estimate.sd, place),
                       between(estimate.q10, place), between(estimate.q90, place)};
    return raised(widened(bin, movedSd(estimate.height, place, motion)), -motion.up);
}

}  // namespace

Ghost ghostOf(const TerrainEstimate& estimate, const ImuMotion& motion)
{
    Ghost ghost;
    ghost.motion = motion;
    for (int bin = 0; bin < kBins; ++bin) {
        const std::optional<Place> place = placeOf(binCentre(bin) + motion.forward);
        if (place && known(estimate, *place))
            ghost.bin[static_cast<std::size_t>(bin)] = moved(estimate, *place, motion);
    }
    return ghost;
}

SourceText describe(NoGhost why)
{
    switch (why) {
    case NoGhost::NoOdometry: return TR_NOOP("core", "the robot reports no odometry");
    case NoGhost::TooFar:
        return TR_NOOP("core", "the robot has driven too far since the last estimate");
    case NoGhost::TooUncertain:
        return TR_NOOP("core", "the last estimate has become too uncertain");
    case NoGhost::Tilted:
        return TR_NOOP("core", "the robot has tilted too much since the last estimate");
    case NoGhost::Turned: return TR_NOOP("core", "the robot has turned since the last estimate");
    case NoGhost::TelemetryGap:
        return TR_NOOP("core",
                       "telemetry was missing for a while, in which the robot may have moved");
    case NoGhost::NothingLeft:
        return TR_NOOP("core", "nothing of the last estimate is left in view");
    }
    throw std::invalid_argument("describe: no such NoGhost");
}

}  // namespace terratact
