#include "core/strip/carried_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/limits.h"

namespace terratact {
namespace {

constexpr double kOnBin = 1e-9;  // share of a bin's width

/// Position among the bins of an estimate: `share` of the way from bin `rear` to the next.
struct EstimatePlace {
    int rear = 0;
    double share = 0.0;
};

std::optional<EstimatePlace> estimatePlaceAt(double x)
{
    const double position = (x - binCentre(0)) / kBinWidth;
    const double nearest = std::round(position);
    const double snapped = std::abs(position - nearest) < kOnBin ? nearest : position;
    if (!(snapped >= 0.0 && snapped <= kBins - 1)) return std::nullopt;
    const int rear = static_cast<int>(std::floor(snapped));
    return EstimatePlace{rear, snapped - rear};
}

double blendedAt(const Heights& values, const EstimatePlace& place)
{
    const auto i = static_cast<std::size_t>(place.rear);
    return place.share == 0.0 ? values[i]
                              : (1.0 - place.share) * values[i] + place.share * values[i + 1];
}

/// Returns the sd that the motion adds, for the steepest slope to a neighbour.
double carriedSdAt(const Heights& heights, const EstimatePlace& place, const ImuMotion& motion)
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

HeightBand carriedBin(const TerrainEstimate& estimate, const EstimatePlace& place,
                      const ImuMotion& motion)
{
    const HeightBand band{blendedAt(estimate.height, place), blendedAt(estimate.sd, place),
                          blendedAt(estimate.q10, place), blendedAt(estimate.q90, place)};
    return raised(widened(band, carriedSdAt(estimate.height, place, motion)), -motion.up);
}

double leastSdOf(const CarriedEstimate& carried)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& bin : carried.bin)
        if (bin) least = std::min(least, bin->sd);
    return least;
}

}  // namespace

CarriedEstimate carriedEstimate(const TerrainEstimate& estimate, const ImuMotion& motion)
{
    CarriedEstimate carried;
    carried.motion = motion;
    for (int bin = 0; bin < kBins; ++bin)
        if (const auto place = estimatePlaceAt(binCentre(bin) + motion.forward))
            carried.bin[static_cast<std::size_t>(bin)] = carriedBin(estimate, *place, motion);
    return carried;
}

EstimateCarrier::EstimateCarrier(const RobotModel& robot, const TerrainEstimate& estimate,
                                 const Measurement& scene)
    : estimate_(estimate), scene_(scene)
{
    if (!scene.travelled) return;
    reckoning_.emplace(robot, *scene.travelled, scene.pitch);
    carried_ = carriedEstimate(estimate_, reckoning_->motion());
}

void EstimateCarrier::add(const Measurement& line)
{
    if (!carried_) return;
    const double silence = std::abs(line.time - newest_.value_or(line.time));
    newest_ = line.time;
    if (!line.travelled || silence > kMaxSilence) {
        carried_.reset();
        return;
    }
    reckoning_->add(*line.travelled, line.pitch);
    carried_ = carriedEstimate(estimate_, reckoning_->motion());
    if (!isWithinLimits(line)) carried_.reset();
}

bool EstimateCarrier::isWithinLimits(const Measurement& line) const
{
    const double turned = turnBetween(scene_.turned.value_or(0.0), line.turned.value_or(0.0));
    return std::abs(turned) <= kTurn && std::abs(reckoning_->pitchChange()) <= kTilt
        && std::abs(line.roll - scene_.roll) <= kTilt && carried_->motion.way <= kWay
        && leastSdOf(*carried_) <= kSd;
}

}  // namespace terratact
