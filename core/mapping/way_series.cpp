#include "core/mapping/way_series.h"

namespace terratact {

void addWay(const std::vector<PoseSample>& poses, RecordedSeries& series)
{
    double way = 0.0;
    const PoseSample* before = nullptr;
    for (const PoseSample& pose : poses) {
        if (!pose.isMeasured()) continue;
        for (std::size_t i = 0; before && i < 3; ++i)
            way += (pose.position[i] - before->position[i]) * before->rotation[i][0];
        before = &pose;
        series.series(Quantity::Travelled).push_back({pose.time, way, true});
        series.series(Quantity::Turned)
            .push_back({pose.time, baseAngles(pose.rotation).heading, true});
    }
}

void integrateSpeed(RecordedSeries& series, double maxGap)
{
    double way = 0.0;
    const SeriesSample* before = nullptr;
    for (const SeriesSample& speed : series.series(Quantity::Speed)) {
        if (!speed.isMeasured) continue;
        const double seconds = before ? static_cast<double>(speed.time - before->time) * 1e-9 : 0.0;
        if (before && seconds <= maxGap) way += 0.5 * (speed.value + before->value) * seconds;
        before = &speed;
        series.series(Quantity::Travelled).push_back({speed.time, way, true});
    }
}

}  // namespace terratact
