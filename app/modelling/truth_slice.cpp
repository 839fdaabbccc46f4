#include "app/modelling/truth_slice.h"

namespace terratact {
namespace {

constexpr double kFlippersFrom = 0.25;   // [m] rear edge of the first bin that flippers carry
constexpr double kPointSpread = 0.0015;  // [m] between the points of a cell

void addLine(std::vector<SlicePoint>& slice, const LaserTruth& truth, const SceneTruth& scene,
             TruthLine line)
{
    const SceneGrid& grid = *truth.grid;
    const CloudCorrection& c = scene.correction;
    const double y = lineY(truth.robot, line, grid.places()[scene.place].s.roll);
    for (std::size_t k = 0; k < grid.cells(); ++k) {
        const double x = grid.cellX(k);
        if (isUnderFlippers(line) != (x > kFlippersFrom) || x < kSliceRear || x > kSliceFront)
            continue;
        std::size_t taken = 0;
        for (const float h : grid.heights(scene.place, line, k)) {
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

std::vector<SlicePoint> truthSlice(const LaserTruth& truth, std::size_t row)
{
    std::vector<SlicePoint> slice;
    const SceneTruth& scene = truth.truths.at(row);
    if (!truth.grid || scene.gap == TruthGap::OtherRun || scene.gap == TruthGap::NoPose)
        return slice;
    slice.reserve(kTruthLines * truth.grid->cells());
    for (std::size_t i = 0; i < kTruthLines; ++i)
        addLine(slice, truth, scene, static_cast<TruthLine>(i));
    return slice;
}

}  // namespace terratact
