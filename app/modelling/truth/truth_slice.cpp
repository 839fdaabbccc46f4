#include "app/modelling/truth/truth_slice.h"

namespace terratact {
namespace {

constexpr double kFlippersFrom = 0.25;   // [m] rear edge of the first bin that flippers carry
constexpr double kPointSpread = 0.0015;  // [m] between the points of a cell

void addLine(std::vector<SlicePoint>& slice, const SceneGrid& grid, const RobotModel& robot,
             std::size_t place, TruthLine line, const CloudCorrection& c)
{
    const double y = lineY(robot, line, grid.places()[place].s.roll);
    for (std::size_t k = 0; k < grid.cells(); ++k) {
        const double x = grid.cellX(k);
        if (isUnderFlippers(line) != (x > kFlippersFrom) || x < kSliceRear || x > kSliceFront)
            continue;
        std::size_t taken = 0;
        for (const float h : grid.heights(place, line, k)) {
            const double z = static_cast<double>(h) + c.offset + c.tiltX * x + c.tiltY * y;
            if (z >= kSliceTop || z <= kSliceBottom) continue;
            if (++taken > kMaxCellPoints) break;
            const double aside =
                kPointSpread * (static_cast<double>(taken) - 0.5 * double{kMaxCellPoints});
            slice.push_back({.line = line, .x = x + aside, .z = z});
        }
    }
}

}  // namespace

std::vector<SlicePoint> truthSlice(const SceneGrid& grid, const RobotModel& robot,
                                   std::size_t place, const CloudCorrection& correction)
{
    std::vector<SlicePoint> slice;
    slice.reserve(kTruthLines * grid.cells());
    for (std::size_t i = 0; i < kTruthLines; ++i)
        addLine(slice, grid, robot, place, static_cast<TruthLine>(i), correction);
    return slice;
}

std::vector<SlicePoint> truthSlice(const LaserTruth& truth, std::size_t row)
{
    const SceneTruth& scene = truth.truths.at(row);
    if (!truth.grid || !scene.hasPlace()) return {};
    return truthSlice(*truth.grid, truth.robot, scene.place, scene.correction);
}

}  // namespace terratact
