#include "core/clouds/scene_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/kinematics.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr double kSquare = 1.0;         // [m]
constexpr double kOwnMargin = 0.03;     // [m] around the robot's box
constexpr double kShortestHalf = 0.75;  // [m] the front end of the bins
constexpr double kLongestHalf = 1.55;

std::int64_t squareOf(double x, double y)
{
    return static_cast<std::int64_t>(std::floor(x / kSquare)) * 2'000'000'011
         + static_cast<std::int64_t>(std::floor(y / kSquare));
}

/// Returns the number of cells of a line: as long as the robot to both sides, in whole bins.
std::size_t cellsUnder(const RobotModel& robot)
{
    double half = kShortestHalf;
    while (half < reachOf(robot) + std::abs(robot.imu.x) && half < kLongestHalf) half += kBinWidth;
    return static_cast<std::size_t>(std::lround(2.0 * half / kTruthCell));
}

/// Returns a number that looks random: splitmix64.
std::uint64_t scrambled(std::uint64_t n)
{
    n += 0x9e3779b97f4a7c15U;
    n = (n ^ (n >> 30U)) * 0xbf58476d1ce4e5b9U;
    n = (n ^ (n >> 27U)) * 0x94d049bb133111ebU;
    return n ^ (n >> 31U);
}

}  // namespace

Result<SceneGrid> SceneGrid::over(const RobotModel& robot, std::vector<ScenePlace> places,
                                  const std::vector<ScenePlace>& passes)
{
    const std::size_t cells = cellsUnder(robot);
    const std::size_t most = kMaxSamples / (cells * kTruthLines * kLeastOfCell);
    if (places.size() > most)
        return Error{
            fmt::format("{} scenes are more than the {} that one map may hold: name a --run, or "
                        "split the scenes",
                        places.size(), most),
            0};
    SceneGrid grid(robot, std::move(places), cells);
    for (const ScenePlace& place : grid.places_) grid.lowerCeilings(place, true);
    for (const ScenePlace& pass : passes) grid.lowerCeilings(pass, false);
    return grid;
}

SceneGrid::SceneGrid(const RobotModel& robot, std::vector<ScenePlace> places, std::size_t cells)
    : robot_(robot), places_(std::move(places)), cells_(cells)
{
    begin_ = -0.5 * kTruthCell * static_cast<double>(cells_);
    const std::size_t all = places_.size() * kTruthLines * cells_;
    most_ = std::clamp(kMaxSamples / std::max<std::size_t>(1, all), kLeastOfCell, kMostOfCell);
    samples_.resize(all * most_);
    counts_.resize(all);
    ceilings_.assign(all, std::numeric_limits<float>::infinity());
    strips_.reserve(places_.size());
    double widest = 0.0;
    for (const ScenePlace& place : places_) {
        auto& strips = strips_.emplace_back();
        for (std::size_t i = 0; i < kTruthLines; ++i) {
            const auto line = static_cast<TruthLine>(i);
            strips.at(i) = {lineY(robot_, line, place.s.roll), lineHalfWidth(robot_, line)};
            widest = std::max(widest, std::abs(strips.at(i).y) + strips.at(i).half);
        }
    }
    reach_ = std::hypot(begin_, widest);
    for (std::size_t p = 0; p < places_.size(); ++p) {
        const Eigen::Vector3d& at = places_[p].imu;
        const auto squares = [&](double from) {
            return static_cast<int>(std::floor((from + reach_) / kSquare)
                                    - std::floor((from - reach_) / kSquare));
        };
        for (int i = 0; i <= squares(at.x()); ++i)
            for (int j = 0; j <= squares(at.y()); ++j)
                near_[squareOf(at.x() - reach_ + i * kSquare, at.y() - reach_ + j * kSquare)]
                    .push_back(static_cast<std::uint32_t>(p));
    }
}

std::size_t SceneGrid::firstCellOf(int bin) const
{
    return static_cast<std::size_t>(std::lround((binBegin(bin) - begin_) / kTruthCell));
}

std::span<const float> SceneGrid::heights(std::size_t place, TruthLine line, std::size_t cell) const
{
    const std::size_t index = indexOfCell(place, line, cell);
    return std::span(samples_).subspan(index * most_, std::min<std::size_t>(counts_[index], most_));
}

void SceneGrid::lowerCeilings(const ScenePlace& robotAt, bool withFlippers)
{
    const auto near = near_.find(squareOf(robotAt.imu.x(), robotAt.imu.y()));
    if (near == near_.end()) return;
    for (const std::uint32_t p : near->second) {
        const ScenePlace& place = places_[p];
        for (std::size_t i = 0; i < kTruthLines * cells_; ++i) {
            const auto line = static_cast<TruthLine>(i / cells_);
            const Eigen::Vector3d there =
                robotAt.toDem(place.toCloud({cellX(i % cells_), strips_[p].at(i / cells_).y, 0.0}));
            for (std::size_t k = 0; k < kTruthLines; ++k) {
                const auto part = static_cast<TruthLine>(k);
                if (isUnderFlippers(part) && !withFlippers) continue;
                if (std::abs(there.y() - lineY(robot_, part, robotAt.s.roll))
                    > lineHalfWidth(robot_, part))
                    continue;
                const double above = partAbove(robot_, robotAt.s, part, there.x()) - there.z();
                float& ceiling = ceilings_[indexOfCell(p, line, i % cells_)];
                ceiling = std::min(ceiling, static_cast<float>(above));
            }
        }
    }
}

void SceneGrid::add(std::span<const CloudPoint> points)
{
    for (const CloudPoint& p : points) addPoint({p.x, p.y, p.z});
}

void SceneGrid::addScan(std::span<const CloudPoint> points, const CloudPose& base,
                        const CloudPose& mount)
{
    const double length = reachOf(robot_) + kOwnMargin;
    const LateralGeometry& l = robot_.lateral;
    const double width =
        std::max(l.trackY + 0.5 * l.trackWidth, l.flipperY + 0.5 * l.flipperWidth) + kOwnMargin;
    for (const CloudPoint& p : points) {
        const Eigen::Vector3d inBase = mount.toCloud({p.x, p.y, p.z});
        if (std::abs(inBase.x()) < length && std::abs(inBase.y()) < width
            && std::abs(inBase.z()) < length) {
            ++own_;
            continue;
        }
        addPoint(base.toCloud(inBase));
    }
}

void SceneGrid::addPoint(const Eigen::Vector3d& point)
{
    const auto near = near_.find(squareOf(point.x(), point.y()));
    if (near == near_.end()) return;
    for (const std::uint32_t place : near->second) {
        const Eigen::Vector3d dem = places_[place].toDem(point);
        if (dem.z() >= kLowestTruth && dem.z() <= kHighestTruth) addTo(place, dem);
    }
}

void SceneGrid::addTo(std::size_t place, const Eigen::Vector3d& dem)
{
    const double cell = std::floor((dem.x() - begin_) / kTruthCell);
    if (!(cell >= 0.0 && cell < static_cast<double>(cells_))) return;
    for (std::size_t i = 0; i < kTruthLines; ++i) {
        const Strip& strip = strips_[place].at(i);
        if (std::abs(dem.y() - strip.y) < strip.half)
            keep(indexOfCell(place, static_cast<TruthLine>(i), static_cast<std::size_t>(cell)),
                 static_cast<float>(dem.z()));
    }
}

void SceneGrid::keep(std::size_t index, float height)
{
    std::uint32_t& count = counts_[index];
    if (count == std::numeric_limits<std::uint32_t>::max()) return;
    const std::size_t slot =
        count < most_ ? count
                      : scrambled(index * 0x100000001b3U + count) % (std::uint64_t{count} + 1);
    ++count;
    if (slot < most_) samples_[index * most_ + slot] = height;
}

}  // namespace terratact
