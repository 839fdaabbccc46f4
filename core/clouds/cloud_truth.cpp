#include "core/clouds/cloud_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/terrain/ground_lines.h"

namespace terratact {
namespace {

constexpr double kLevelGap = 0.35;       // [m]
constexpr double kLevelShare = 0.1;      // of the points
constexpr std::size_t kOwnSpread = 4;    // points from which a cell has a spread of its own
constexpr double kUnknownSpread = 0.03;  // [m] if no cell of a line has one
constexpr int kMinKnownCells = 3;

/// Returns √(p (1 − p)) / φ(Φ⁻¹(p)): sd of a percentile of n normal values, times √n.
double percentileFactor(double percentile)
{
    const double p = std::clamp(0.01 * percentile, 0.01, 0.99);
    double low = -4.0, high = 4.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < p ? low : high) = middle;
    }
    const double density = std::exp(-0.5 * low * low) / std::sqrt(2.0 * std::numbers::pi);
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

/// Fills cells without points from their neighbours. Returns the heights of the bin's cells.
std::array<double, kCellsOfBin> filledCells(const std::vector<CellGround>& cells, std::size_t first)
{
    std::array<double, kCellsOfBin> heights{};
    for (std::size_t k = 0; k < kCellsOfBin; ++k) {
        const auto at = static_cast<std::ptrdiff_t>(first + k);
        const auto known = [&](std::ptrdiff_t step) {
            for (std::ptrdiff_t d = 0; d < static_cast<std::ptrdiff_t>(kCellsOfBin); ++d) {
                const std::ptrdiff_t i = at + step * d;
                if (i < 0 || i >= static_cast<std::ptrdiff_t>(cells.size())) break;
                if (cells[static_cast<std::size_t>(i)].isKnown) return std::pair(d, i);
            }
            return std::pair(std::ptrdiff_t{-1}, std::ptrdiff_t{0});
        };
        const auto [back, from] = known(-1);
        const auto [ahead, to] = known(1);
        const auto height = [&](std::ptrdiff_t i) {
            return cells[static_cast<std::size_t>(i)].height;
        };
        if (back >= 0 && ahead >= 0)
            heights.at(k) = back + ahead == 0
                              ? height(from)
                              : height(from)
                                    + (height(to) - height(from)) * static_cast<double>(back)
                                          / static_cast<double>(back + ahead);
        else
            heights.at(k) = back >= 0 ? height(from) : height(to);
    }
    return heights;
}

BinTruth binTruth(const std::vector<CellGround>& cells, std::size_t first, const TruthRule& rule)
{
    BinTruth bin;
    std::vector<double> known;
    known.reserve(kCellsOfBin);
    double squares = 0.0, worst = 0.0;
    for (std::size_t k = first; k < first + kCellsOfBin; ++k) {
        if (!cells[k].isKnown) continue;
        known.push_back(cells[k].height);
        squares += cells[k].sd * cells[k].sd;
        worst = std::max(worst, cells[k].sd * cells[k].sd);
    }
    bin.cells = static_cast<int>(known.size());
    if (bin.cells < kMinKnownCells) return bin;
    const double all = static_cast<double>(kCellsOfBin);
    const double missing = all - static_cast<double>(bin.cells);
    const double hole = missing / all * spreadOf(known);
    bin.sd = std::sqrt(rule.placeSd * rule.placeSd + (squares + missing * worst) / (all * all)
                       + hole * hole);
    if (bin.sd > rule.maxSd) return bin;
    double sum = 0.0;
    for (const double h : filledCells(cells, first)) sum += h;
    bin.height = sum / all;
    return bin;
}

}  // namespace

std::vector<CellGround> groundOf(const SceneGrid& grid, const RobotModel& robot, std::size_t place,
                                 TruthLine line, const CloudCorrection& correction,
                                 const TruthRule& rule)
{
    const double factor = percentileFactor(rule.percentile);
    const TwoTrackReadings& s = grid.places()[place].s;
    const double y = lineY(robot, line, s.roll);
    std::vector<CellGround> cells(grid.cells());
    std::vector<bool> isBelowOther(grid.cells());
    std::vector<double> heights, spreads, alone(grid.cells(), 0.0);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const double x = grid.cellX(k);
        const double added = correction.offset + correction.tiltX * x + correction.tiltY * y;
        const double highest = grid.ceiling(place, line, k) + rule.ownMargin;
        heights.clear();
        for (const float h : grid.heights(place, line, k))
            if (const double z = static_cast<double>(h) + added; z <= highest) heights.push_back(z);
        if (heights.empty()) continue;
        std::ranges::sort(heights);
        const std::span<const double> level = lowerLevel(heights);
        isBelowOther[k] = level.size() < heights.size();
        cells[k] = {true, percentileOf(level, rule.percentile), 0.0};
        const double root = std::sqrt(static_cast<double>(level.size()));
        if (level.size() >= kOwnSpread) {
            spreads.push_back(spreadOf(level));
            cells[k].sd = factor * spreads.back() / root;
        } else {
            alone[k] = factor / root;
        }
    }
    double usual = kUnknownSpread;
    if (!spreads.empty()) {
        std::ranges::sort(spreads);
        usual = percentileOf(spreads, 50.0);
    }
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k].sd += alone[k] * usual;
    leaveOutHanging(cells, isBelowOther);
    return cells;
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
