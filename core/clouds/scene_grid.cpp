#include "core/clouds/scene_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/kinematics.h"
#include "core/terrain/bins.h"

namespace terratact {
namespace {

constexpr double kSmallSquare = 0.25, kLargeSquare = 1.0, kPassSquare = 0.1;  // [m]
constexpr std::size_t kMaxPassesPerSquare = 20;
constexpr double kOwnMargin = 0.03;  // [m] around the robot's box
constexpr double kMinHalf =
    0.75 + kMaxCellsMoved * kTruthCell;  // [m] the front end of the bins, with a moved cloud
constexpr double kMaxHalf = 1.55;

std::int64_t squareOf(double x, double y, double size)
{
    return static_cast<std::int64_t>(std::floor(x / size)) * 2'000'000'011
         + static_cast<std::int64_t>(std::floor(y / size));
}

/// Returns the number of cells of a line: as long as the robot to both sides, in whole bins.
std::size_t cellsUnder(const RobotModel& robot)
{
    double half = kMinHalf;
    while (half < reachOf(robot) + std::abs(robot.imu.x) && half < kMaxHalf) half += kBinWidth;
    return static_cast<std::size_t>(std::lround(2.0 * half / kTruthCell));
}

/// Cells of a line from `begin` to before `end`.
struct CellRange {
    std::size_t begin = 0, end = 0;
};

/// Returns the cells k whose first + k · step may lie within low … high. Rounding adds one at both
/// ends.
CellRange cellsWithin(double first, double step, double low, double high, std::size_t cells)
{
    constexpr double kLevel = 1e-9;  // [m] of a step: the line is parallel to the part
    const auto all = static_cast<double>(cells);
    if (std::abs(step) < kLevel) {
        const double slack = kLevel * all;
        const bool isBeside = first < low - slack || first > high + slack;
        return {0, isBeside ? 0 : cells};
    }
    const auto [from, to] = std::minmax({(low - first) / step, (high - first) / step});
    return {static_cast<std::size_t>(std::clamp(std::floor(from) - 1.0, 0.0, all)),
            static_cast<std::size_t>(std::clamp(std::ceil(to) + 2.0, 0.0, all))};
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
    const std::size_t most = kMaxSamples / (cells * kTruthLines * kMinPerCell);
    if (places.size() > most)
        return Error{
            fmt::format("{} scenes are more than the {} that one map may hold: name a --run, or "
                        "split the scenes",
                        places.size(), most),
            0};
    SceneGrid grid(robot, std::move(places), cells);
    for (const auto& [square, over] : grid.over_)
        if (over.size() > kMaxPerPlace) {
            const Eigen::Vector3d& at = grid.places_[over.front()].imu;
            return Error{fmt::format("{} scenes lie over the same ground, near x {:.1f} m, y "
                                     "{:.1f} m; at most {} may: "
                                     "name a --run, or split the scenes",
                                     over.size(), at.x(), at.y(), kMaxPerPlace),
                         0};
        }
    for (const ScenePlace& place : grid.places_) grid.lowerCeilings(place, true);
    std::unordered_map<std::int64_t, std::size_t> passed;
    for (const ScenePlace& pass : passes)
        if (++passed[squareOf(pass.imu.x(), pass.imu.y(), kPassSquare)] <= kMaxPassesPerSquare)
            grid.lowerCeilings(pass, false);
    return grid;
}

SceneGrid::SceneGrid(const RobotModel& robot, std::vector<ScenePlace> places, std::size_t cells)
    : robot_(robot), places_(std::move(places)), cells_(cells)
{
    begin_ = -0.5 * kTruthCell * static_cast<double>(cells_);
    const std::size_t all = places_.size() * kTruthLines * cells_;
    most_ = std::clamp(kMaxSamples / std::max<std::size_t>(1, all), kMinPerCell, kMaxPerCell);
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
    moved_.assign(places_.size(), 0);
    turns_.reserve(places_.size());
    for (std::size_t p = 0; p < places_.size(); ++p) {
        turns_.push_back({std::cos(places_[p].heading), std::sin(places_[p].heading)});
        index(p, widest);
    }
}

void SceneGrid::index(std::size_t place, double widest)
{
    const Eigen::Vector3d& at = places_[place].imu;
    const auto number = static_cast<std::uint32_t>(place);
    around_[squareOf(at.x(), at.y(), kLargeSquare)].push_back(number);
    const auto steps = static_cast<int>(std::ceil(reach_ / kSmallSquare)) + 1;
    const double corner = 0.75 * kSmallSquare;  // from a square's middle
    for (int i = -steps; i <= steps; ++i)
        for (int j = -steps; j <= steps; ++j) {
            const auto middle = [&](double from, int step) {
                return (std::floor(from / kSmallSquare) + step + 0.5) * kSmallSquare;
            };
            const double x = middle(at.x(), i), y = middle(at.y(), j);
            const Eigen::Vector3d dem = places_[place].toDem({x, y, at.z()});
            if (std::abs(dem.x()) < -begin_ + corner && std::abs(dem.y()) < widest + corner)
                over_[squareOf(x, y, kSmallSquare)].push_back(number);
        }
}

std::size_t SceneGrid::firstCellOf(int bin) const
{
    return static_cast<std::size_t>(std::lround((binBegin(bin) - begin_) / kTruthCell));
}

std::span<const float> SceneGrid::heights(std::size_t place, TruthLine line, std::size_t cell) const
{
    const auto index = indexOfPoints(place, line, cell);
    if (!index) return {};
    return std::span(samples_).subspan(*index * most_,
                                       std::min<std::size_t>(counts_[*index], most_));
}

std::optional<std::size_t> SceneGrid::indexOfPoints(std::size_t place, TruthLine line,
                                                    std::size_t cell) const
{
    const auto from = static_cast<std::ptrdiff_t>(cell) - moved_[place];
    if (from < 0 || from >= static_cast<std::ptrdiff_t>(cells_)) return std::nullopt;
    return indexOfCell(place, line, static_cast<std::size_t>(from));
}

PlaceCells SceneGrid::cellsOf(std::size_t place) const
{
    const std::size_t n = kTruthLines * cells_, first = place * n;
    PlaceCells cells{.most = static_cast<std::uint32_t>(most_)};
    cells.counts.assign(&counts_[first], &counts_[first] + n);
    cells.ceilings.assign(&ceilings_[first], &ceilings_[first] + n);
    for (std::size_t i = first; i < first + n; ++i) {
        const float* const kept = &samples_[i * most_];
        cells.heights.insert(cells.heights.end(), kept,
                             kept + std::min<std::size_t>(counts_[i], most_));
    }
    return cells;
}

Result<SceneGrid> SceneGrid::restored(const RobotModel& robot, ScenePlace place,
                                      const PlaceCells& cells)
{
    const std::size_t n = kTruthLines * cellsUnder(robot);
    std::size_t kept = 0;
    for (const std::uint32_t count : cells.counts) kept += std::min(count, cells.most);
    const auto isHeight = [](float z) {
        return static_cast<double>(z) >= kLowestTruth && static_cast<double>(z) <= kHighestTruth;
    };
    if (cells.most < kMinPerCell || cells.most > kMaxPerCell || cells.counts.size() != n
        || cells.ceilings.size() != n || cells.heights.size() != kept
        || !std::ranges::all_of(cells.heights, isHeight)
        || std::ranges::any_of(cells.ceilings, [](float z) { return std::isnan(z); }))
        return Error{"the cells are not those of this robot, or damaged", 0};
    SceneGrid grid(robot, {std::move(place)}, n / kTruthLines);
    grid.most_ = cells.most;
    grid.counts_ = cells.counts;
    grid.ceilings_ = cells.ceilings;
    auto from = cells.heights.begin();
    for (std::size_t i = 0; i < n; ++i) {
        const auto here = static_cast<std::ptrdiff_t>(std::min(cells.counts[i], cells.most));
        std::copy(from, from + here,
                  grid.samples_.begin() + static_cast<std::ptrdiff_t>(i * grid.most_));
        from += here;
    }
    return grid;
}

void SceneGrid::lowerCeilings(const ScenePlace& robotAt, bool withFlippers)
{
    const std::vector<PartTable> parts = partTables(robotAt, withFlippers);
    const auto squares = static_cast<int>(std::ceil(2.0 * reach_ / kLargeSquare));
    for (int i = -squares; i <= squares; ++i)
        for (int j = -squares; j <= squares; ++j) {
            const auto near =
                around_.find(squareOf(robotAt.imu.x() + i * kLargeSquare,
                                      robotAt.imu.y() + j * kLargeSquare, kLargeSquare));
            if (near == around_.end()) continue;
            for (const std::uint32_t p : near->second) lowerCeilingsOf(p, robotAt, parts);
        }
}

void SceneGrid::lowerCeilingsOf(std::size_t p, const ScenePlace& robotAt,
                                const std::vector<PartTable>& parts)
{
    const ScenePlace& place = places_[p];
    if ((place.imu - robotAt.imu).head<2>().norm() > 2.0 * reach_) return;
    for (std::size_t i = 0; i < kTruthLines; ++i) {
        const auto line = static_cast<TruthLine>(i);
        // The line of cells is a straight line in the robot's frame.
        const Eigen::Vector3d first =
            robotAt.toDem(place.toCloud({cellX(0), strips_[p].at(i).y, 0.0}));
        const Eigen::Vector3d step =
            robotAt.toDem(place.toCloud({cellX(1), strips_[p].at(i).y, 0.0})) - first;
        for (const PartTable& part : parts) {
            const CellRange range =
                cellsWithin(first.y(), step.y(), part.y - part.half, part.y + part.half, cells_);
            for (std::size_t k = range.begin; k < range.end; ++k) {
                const Eigen::Vector3d there = first + static_cast<double>(k) * step;
                if (std::abs(there.y() - part.y) > part.half) continue;
                float& ceiling = ceilings_[indexOfCell(p, line, k)];
                ceiling =
                    std::min(ceiling, static_cast<float>(part.at(there.x(), begin_) - there.z()));
            }
        }
    }
}

std::vector<SceneGrid::PartTable> SceneGrid::partTables(const ScenePlace& robotAt,
                                                        bool withFlippers) const
{
    std::vector<PartTable> parts;
    parts.reserve(kTruthLines);
    for (std::size_t i = 0; i < kTruthLines; ++i) {
        const auto part = static_cast<TruthLine>(i);
        if (isUnderFlippers(part) && !withFlippers) continue;
        PartTable& table = parts.emplace_back(
            PartTable{lineY(robot_, part, robotAt.s.roll), lineHalfWidth(robot_, part), {}});
        table.lower.reserve(cells_);
        for (std::size_t k = 0; k < cells_; ++k)
            table.lower.push_back(partAbove(robot_, robotAt.s, part, cellX(k)));
    }
    return parts;
}

double SceneGrid::PartTable::at(double x, double begin) const
{
    const double cell = std::floor((x - begin) / kTruthCell);
    return cell >= 0.0 && cell < static_cast<double>(lower.size())
             ? lower[static_cast<std::size_t>(cell)]
             : std::numeric_limits<double>::infinity();
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
        const Eigen::Vector3d inBase = mount.toOther({p.x, p.y, p.z});
        if (std::abs(inBase.x()) < length && std::abs(inBase.y()) < width
            && std::abs(inBase.z()) < length) {
            ++own_;
            continue;
        }
        addPoint(base.toOther(inBase));
    }
}

void SceneGrid::addPoint(const Eigen::Vector3d& point)
{
    const auto over = over_.find(squareOf(point.x(), point.y(), kSmallSquare));
    if (over == over_.end()) return;
    for (const std::uint32_t place : over->second) {
        const Eigen::Vector3d d = point - places_[place].imu;
        if (d.z() < kLowestTruth || d.z() > kHighestTruth) continue;
        const Turn& turn = turns_[place];
        addTo(place, turn.cosine * d.x() + turn.sine * d.y(),
              turn.cosine * d.y() - turn.sine * d.x(), static_cast<float>(d.z()));
    }
}

void SceneGrid::addTo(std::size_t place, double x, double y, float height)
{
    const double cell = std::floor((x - begin_) / kTruthCell);
    if (!(cell >= 0.0 && cell < static_cast<double>(cells_))) return;
    for (std::size_t i = 0; i < kTruthLines; ++i) {
        const Strip& strip = strips_[place].at(i);
        if (std::abs(y - strip.y) < strip.half)
            keep(indexOfCell(place, static_cast<TruthLine>(i), static_cast<std::size_t>(cell)),
                 height);
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
