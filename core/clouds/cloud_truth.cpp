#include "core/clouds/cloud_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/normal.h"
#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

constexpr double kLevelGap = 0.35;       // [m]
constexpr double kLevelShare = 0.1;      // of the points
constexpr std::size_t kOwnSpread = 4;    // points from which a cell has a spread of its own
constexpr double kUnknownSpread = 0.03;  // [m] if no cell of a line has one
constexpr int kMinKnownCells = 3;
constexpr double kMarginSd = 3.0, kWidestMargin = 0.06;  // [m]
constexpr double kHoleShare = 0.5;    // of the rise across a hole: a step may lie anywhere in it
constexpr double kOpenHoleSd = 0.05;  // [m] of a cell whose hole does not end within a bin

/// Returns √(p (1 − p)) / φ(Φ⁻¹(p)): sd of a percentile of n normal values, times √n.
double percentileFactor(double percentile)
{
    const double p = std::clamp(0.01 * percentile, 0.01, 0.99);
    const double z = normalQuantile(p);
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    return std::sqrt(p * (1.0 - p)) / density;
}

/// Returns the percentile of sorted values, interpolated.
double percentileOf(std::span<const double> sorted, double percentile)
{
    const double at = 0.01 * percentile * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double spreadOf(std::span<const double> values)
{
    double mean = 0.0, sum = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values) sum += (v - mean) * (v - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// Returns the values of the lower level.
std::span<const double> lowerLevel(std::span<const double> sorted)
{
    const double least = kLevelShare * static_cast<double>(sorted.size());
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i] - sorted[i - 1] >= kLevelGap && static_cast<double>(i) >= least)
            return sorted.first(i);
    return sorted;
}

/// Makes cells unknown that hold the upper level alone: a near cell has ground below another level.
void leaveOutHanging(std::vector<CellGround>& cells, const std::vector<bool>& isBelowOther)
{
    const std::vector<CellGround> all = cells;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::size_t end = std::min(cells.size(), k + kCellsOfBin + 1);
        for (std::size_t i = k - std::min(k, kCellsOfBin); i < end; ++i)
            if (isBelowOther[i] && all[i].height < all[k].height - kLevelGap) cells[k] = {};
    }
}

/// Height of a cell without points, from its nearest known neighbours.
struct FilledCell {
    double height = 0.0, sd = 0.0;
};

/// Returns the nearest known cell at or beside `at`, at most a bin away; null: there is none.
const CellGround* knownBeside(const std::vector<CellGround>& cells, std::size_t at, bool ahead,
                              std::size_t& distance)
{
    for (distance = 0; distance < kCellsOfBin; ++distance) {
        if (ahead ? at + distance >= cells.size() : distance > at) return nullptr;
        const CellGround& cell = cells[ahead ? at + distance : at - distance];
        if (cell.isKnown) return &cell;
    }
    return nullptr;
}

FilledCell filledCell(const std::vector<CellGround>& cells, std::size_t at)
{
    std::size_t back = 0, ahead = 0;
    const CellGround* const behind = knownBeside(cells, at, false, back);
    const CellGround* const before = knownBeside(cells, at, true, ahead);
    if (!behind || !before) return {(behind ? behind : before)->height, kOpenHoleSd};
    const double share = static_cast<double>(back) / static_cast<double>(back + ahead);
    const double rise = before->height - behind->height;
    return {behind->height + share * rise, kHoleShare * std::abs(rise)};
}

BinTruth binTruth(const std::vector<CellGround>& cells, std::size_t first, const TruthRule& rule)
{
    BinTruth bin;
    for (std::size_t k = first; k < first + kCellsOfBin; ++k) bin.cells += cells[k].isKnown ? 1 : 0;
    if (bin.cells < kMinKnownCells) return bin;
    double sum = 0.0, squares = 0.0, holes = 0.0, worst = 0.0;
    for (std::size_t k = first; k < first + kCellsOfBin; ++k) {
        const FilledCell filled =
            cells[k].isKnown ? FilledCell{cells[k].height, 0.0} : filledCell(cells, k);
        sum += filled.height;
        holes += filled.sd;
        squares += cells[k].sd * cells[k].sd;
        worst = std::max(worst, cells[k].sd * cells[k].sd);
    }
    const auto all = static_cast<double>(kCellsOfBin);
    const double missing = all - static_cast<double>(bin.cells);
    bin.sd = std::sqrt(rule.placeSd * rule.placeSd
                       + (squares + missing * worst + holes * holes) / (all * all));
    if (bin.sd <= rule.maxSd) bin.height = sum / all;
    return bin;
}

/// Ground under a line, and the usual spread of a cell's points [m].
struct LineGround {
    std::vector<CellGround> cells;
    double spread = kUnknownSpread;
};

/// Cells of a line at a scene.
struct LineOfCells {
    const SceneGrid& grid;
    std::size_t place;
    TruthLine line;
    double y;
    const CloudCorrection& correction;
    const TruthRule& rule;

    /// Returns the sorted heights of a cell up to `margin` above the robot's lower boundary.
    void collect(std::size_t cell, double margin, std::vector<double>& heights) const
    {
        heights.clear();
        const double added =
            correction.offset + correction.tiltX * grid.cellX(cell) + correction.tiltY * y;
        const double highest = grid.ceiling(place, line, cell) + margin;
        for (const float h : grid.heights(place, line, cell))
            if (const double z = static_cast<double>(h) + added; z <= highest) heights.push_back(z);
        std::ranges::sort(heights);
    }

    LineGround measured(double margin) const
    {
        const double factor = percentileFactor(rule.percentile);
        LineGround ground{.cells = std::vector<CellGround>(grid.cells())};
        std::vector<bool> isBelowOther(grid.cells());
        std::vector<double> heights, spreads, alone(grid.cells(), 0.0);
        for (std::size_t k = 0; k < grid.cells(); ++k) {
            collect(k, margin, heights);
            if (heights.empty()) continue;
            const std::span<const double> level = lowerLevel(heights);
            isBelowOther[k] = level.size() < heights.size();
            ground.cells[k] = {true, percentileOf(level, rule.percentile), 0.0};
            const double root = std::sqrt(static_cast<double>(level.size()));
            if (level.size() >= kOwnSpread) {
                spreads.push_back(spreadOf(level));
                ground.cells[k].sd = factor * spreads.back() / root;
            } else {
                alone[k] = factor / root;
            }
        }
        std::ranges::sort(spreads);
        if (!spreads.empty()) ground.spread = percentileOf(spreads, 50.0);
        for (std::size_t k = 0; k < grid.cells(); ++k)
            ground.cells[k].sd += alone[k] * ground.spread;
        leaveOutHanging(ground.cells, isBelowOther);
        return ground;
    }
};

}  // namespace

std::vector<CellGround> groundOf(const SceneGrid& grid, const RobotModel& robot, std::size_t place,
                                 TruthLine line, const CloudCorrection& correction,
                                 const TruthRule& rule)
{
    const LineOfCells at{grid,       place, line, lineY(robot, line, grid.places()[place].s.roll),
                         correction, rule};
    LineGround ground = at.measured(rule.ownMargin);
    const double wanted = std::min(kWidestMargin, kMarginSd * ground.spread);
    if (wanted > rule.ownMargin) ground = at.measured(wanted);
    return ground.cells;
}

SideTruth sideTruth(const SceneGrid& grid, const RobotModel& robot, std::size_t place, Side side,
                    const CloudCorrection& correction, const TruthRule& rule)
{
    SideTruth truth;
    for (const bool flippers : {false, true}) {
        const auto line = static_cast<TruthLine>((side == Side::Left ? 0 : 2) + (flippers ? 1 : 0));
        const auto cells = groundOf(grid, robot, place, line, correction, rule);
        for (int bin = flippers ? kFirstFlipperBin : 0; bin < (flippers ? kBins : kFirstFlipperBin);
             ++bin) {
            const std::size_t first = grid.firstCellOf(bin);
            BinTruth& into = truth.at(static_cast<std::size_t>(bin));
            into = binTruth(cells, first, rule);
            for (std::size_t k = first; k < first + kCellsOfBin; ++k)
                into.points += grid.count(place, line, k);
        }
    }
    return truth;
}

SideTruth planeTruth(const SideTruth& left, const SideTruth& right, const TruthRule& rule)
{
    SideTruth plane;
    for (std::size_t i = 0; i < kBins; ++i) {
        const BinTruth &l = left.at(i), &r = right.at(i);
        BinTruth& bin = plane.at(i);
        if (!l.height || !r.height) {
            bin = l.height ? l : r;
            bin.points = l.points + r.points;
            continue;
        }
        const double apart = 0.5 * (*l.height - *r.height), shared = rule.placeSd * rule.placeSd;
        bin = {.height = 0.5 * (*l.height + *r.height),
               .sd = std::sqrt(0.25 * (l.sd * l.sd + r.sd * r.sd) + 0.5 * shared + apart * apart),
               .points = l.points + r.points,
               .cells = std::min(l.cells, r.cells)};
        if (bin.sd > rule.maxSd) bin.height.reset();
    }
    return plane;
}

}  // namespace terratact
