#include "core/terrain/ground_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/robot/two_tracks.h"

namespace terratact {

GroundLines::GroundLines(TerrainProfile everywhere) : lines_{{0.0, std::move(everywhere)}} {}

GroundLines::GroundLines(std::vector<GroundLine> lines) : lines_(std::move(lines))
{
    if (lines_.empty()) throw std::invalid_argument("a ground needs at least one line");
    for (const GroundLine& line : lines_)
        if (!std::isfinite(line.y)) throw std::invalid_argument("a ground line's y must be finite");
    std::ranges::sort(lines_, std::ranges::greater{}, &GroundLine::y);
    if (std::ranges::adjacent_find(lines_, {}, &GroundLine::y) != lines_.end())
        throw std::invalid_argument("two ground lines have the same y");
    if (begin() > end()) throw std::invalid_argument("ground lines have no x in common");
}

const TerrainProfile& GroundLines::under(double y) const
{
    const auto nearer = [y](const GroundLine& a, const GroundLine& b) {
        const double toA = std::abs(a.y - y), toB = std::abs(b.y - y);
        return toA == toB ? std::abs(a.y) < std::abs(b.y) : toA < toB;
    };
    return std::ranges::min_element(lines_, nearer)->profile;
}

bool GroundLines::isOnePlane() const
{
    return std::ranges::all_of(lines_, [&](const GroundLine& line) {
        return line.profile.points() == lines_.front().profile.points();
    });
}

double GroundLines::begin() const
{
    double begin = lines_.front().profile.begin();
    for (const GroundLine& line : lines_) begin = std::max(begin, line.profile.begin());
    return begin;
}

double GroundLines::end() const
{
    double end = lines_.front().profile.end();
    for (const GroundLine& line : lines_) end = std::min(end, line.profile.end());
    return end;
}

GroundLines GroundLines::mirrored() const
{
    std::vector<GroundLine> lines = lines_;
    for (GroundLine& line : lines) line.y = -line.y;
    return GroundLines(std::move(lines));
}

Heights sideHeights(const GroundLines& terrain, const RobotModel& robot, Side side, Vec2 imu)
{
    const double sign = signOf(side);
    Heights heights = binHeights(terrain.under(sign * robot.lateral.trackY), imu);
    const Heights ahead = binHeights(terrain.under(sign * robot.lateral.flipperY), imu);
    std::copy(ahead.begin() + kFirstFlipperBin, ahead.end(), heights.begin() + kFirstFlipperBin);
    return heights;
}

}  // namespace terratact
