#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "core/clouds/cloud_reader.h"
#include "core/clouds/scene_place.h"

namespace terratact {

inline constexpr double kTruthCell = 0.02;  ///< [m] along a line; five cells make a bin
inline constexpr std::size_t kCellsOfBin = 5;
/// Heights of the DEM frame in which points are kept [m]: the ground, not what hangs above the robot.
inline constexpr double kLowestTruth = -1.5, kHighestTruth = 0.8;
inline constexpr int kMaxCellsMoved = 10;  ///< cells by which moveAlong() may move a scene's cloud

/// Cells of one place as plain values, by lines and their cells.
struct PlaceCells {
    std::uint32_t most = 0;               ///< heights that a cell keeps
    std::vector<std::uint32_t> counts{};  ///< of points
    std::vector<float> ceilings{};        ///< as SceneGrid::ceiling()
    std::vector<float> heights{};         ///< kept heights of the cells, one cell after the other
};

/// Cells under the lines of every scene, which collect the heights of a cloud's points. Each cell
/// keeps a sample of its heights, every point with the same probability. Memory therefore does not
/// grow with the cloud. Equal points in equal order give equal samples.
class SceneGrid {
public:
    static constexpr std::size_t kMaxSamples = 60'800'000;  ///< of all cells: 243 MB
    static constexpr std::size_t kMaxPerPlace = 500;
    static constexpr std::size_t kMaxPerCell = 48, kMinPerCell = 8;

    /// passes: further poses of the drive. Only their pitch, roll and tracks count, and only the first few in each
    /// square of 10 cm. No pose of `places` or `passes` has ground above the robot's lower boundary.
    /// Errors: more scenes than kMaxSamples allow, or more than kMaxPerPlace over one place. Each point of that place
    /// falls under all of them.
    static Result<SceneGrid> over(const RobotModel& robot, std::vector<ScenePlace> places,
                                  const std::vector<ScenePlace>& passes = {});

    /// Returns the grid of a single place from its cells. It equals the grid that they come from, before moveAlong().
    /// Errors: cells that this robot cannot have, or heights that a grid does not keep.
    static Result<SceneGrid> restored(const RobotModel& robot, ScenePlace place,
                                      const PlaceCells& cells);
    PlaceCells cellsOf(std::size_t place) const;

    /// Moves the cloud under a place ahead by whole cells, or back if negative, from where it was read. The ceilings
    /// stay with the robot. Cells beyond the end are empty then. cells: at most ±kMaxCellsMoved.
    void moveAlong(std::size_t place, int cells) { moved_.at(place) = cells; }

    const std::vector<ScenePlace>& places() const { return places_; }
    std::size_t cells() const { return cells_; }  ///< of a line
    /// Returns x of the middle of a cell in the DEM frame [m].
    double cellX(std::size_t cell) const
    {
        return begin_ + (static_cast<double>(cell) + 0.5) * kTruthCell;
    }
    /// Returns the first of the five cells of a bin.
    std::size_t firstCellOf(int bin) const;

    /// Adds points in the cloud's frame.
    void add(std::span<const CloudPoint> points);

    /// Adds points of a scan in the sensor's frame, whose pose in the base is `mount`. Points within the box that
    /// the robot can fill with any flipper angles are its own, and left out.
    void addScan(std::span<const CloudPoint> points, const CloudPose& base, const CloudPose& mount);

    /// Returns the lowest boundary of the robot above the middle of a cell, DEM frame. All poses of the drive count.
    /// +infinity: the robot was never there.
    double ceiling(std::size_t place, TruthLine line, std::size_t cell) const
    {
        return static_cast<double>(ceilings_[indexOfCell(place, line, cell)]);
    }

    std::uint64_t ownPoints() const { return own_; }  ///< left out by addScan()

    /// Returns the kept heights of a cell, DEM frame [m].
    std::span<const float> heights(std::size_t place, TruthLine line, std::size_t cell) const;
    /// Returns true if a point fell into a cell.
    bool hasPoints() const
    {
        return std::ranges::any_of(counts_, [](auto n) { return n > 0; });
    }
    /// Returns the number of points that fell into a cell.
    std::uint32_t count(std::size_t place, TruthLine line, std::size_t cell) const
    {
        const auto index = indexOfPoints(place, line, cell);
        return index ? counts_[*index] : 0;
    }

private:
    struct Strip {
        double y = 0.0, half = 0.0;
    };
    SceneGrid(const RobotModel& robot, std::vector<ScenePlace> places, std::size_t cells);

    std::size_t indexOfCell(std::size_t place, TruthLine line, std::size_t cell) const
    {
        return (place * kTruthLines + static_cast<std::size_t>(line)) * cells_ + cell;
    }
    /// Returns the cell whose points lie in a cell now; empty: beyond the end.
    std::optional<std::size_t> indexOfPoints(std::size_t place, TruthLine line,
                                             std::size_t cell) const;
    void addPoint(const Eigen::Vector3d& point);
    void index(std::size_t place, double widest);
    void addTo(std::size_t place, double x, double y, float height);
    void keep(std::size_t index, float height);
    /// Cosine and sine of a place's heading.
    struct Turn {
        double cosine = 1.0, sine = 0.0;
    };
    /// Lower boundary of a part in the cells of its line.
    struct PartTable {
        double y = 0.0, half = 0.0;
        std::vector<double> lower;
        double at(double x, double begin) const;
    };
    std::vector<PartTable> partTables(const ScenePlace& robotAt, bool withFlippers) const;
    void lowerCeilings(const ScenePlace& robotAt, bool withFlippers);
    void lowerCeilingsOf(std::size_t place, const ScenePlace& robotAt,
                         const std::vector<PartTable>& parts);

    RobotModel robot_;
    std::vector<ScenePlace> places_;
    std::vector<std::array<Strip, kTruthLines>> strips_;
    std::size_t cells_ = 0, most_ = 0;
    double begin_ = 0.0;
    double reach_ = 0.0;  ///< [m] from an IMU to the farthest corner of its strips
    using PlacesBySquare = std::unordered_map<std::int64_t, std::vector<std::uint32_t>>;
    PlacesBySquare over_;    ///< places whose strips a small square may touch
    PlacesBySquare around_;  ///< places by the square metre of their IMU
    std::vector<Turn> turns_;
    std::vector<int> moved_;  ///< cells by which the cloud of a place was moved ahead
    std::vector<float> samples_, ceilings_;
    std::vector<std::uint32_t> counts_;
    std::uint64_t own_ = 0;
};

}  // namespace terratact
