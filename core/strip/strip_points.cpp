#include "core/strip/strip_points.h"

#include "core/robot/kinematics.h"

namespace terratact {
namespace {

StripPoint pointOf(const StripSection& section, int column, std::size_t side, const StripBin& bin,
                   const StripSource& source, const RobotModel& robot)
{
    const double along = column * kBinWidth;
    const double ahead = along - section.imuAt(source.at).x;
    const double width = bin.onFlipperLine ? robot.lateral.flipperY : robot.lateral.trackY;
    const double left = side == 0 ? width : -width;
    // From above, Vec2::z is y.
    const Vec2 offset = rotated({ahead, left}, source.at.heading);
    const Vec2 place = rotated({source.at.planX - section.start.planX + offset.x,
                                source.at.planY - section.start.planY + offset.z},
                               -section.start.heading);
    StripPoint point{.x = place.x, .y = place.z, .z = bin.band.height, .side = side};
    point.along = along;
    point.driftSd = heightSd(source.at.drift - section.start.drift, bin.slopes);
    point.bin = &bin;
    point.source = &source;
    return point;
}

}  // namespace

std::vector<StripPoint> pointsOf(const Strip& strip, const RobotModel& robot)
{
    std::vector<StripPoint> points;
    for (std::size_t k = 0; k < strip.sections().size(); ++k) {
        const StripSection& section = strip.sections()[k];
        points.reserve(points.size() + 2 * section.columns.size());
        for (const auto& [index, column] : section.columns)
            for (std::size_t side = 0; side < 2; ++side)
                if (const auto& bin = column.at(side)) {
                    points.push_back(
                        pointOf(section, index, side, *bin, strip.source(*bin), robot));
                    points.back().section = k;
                }
    }
    return points;
}

}  // namespace terratact
