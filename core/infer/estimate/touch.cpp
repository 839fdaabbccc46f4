#include "core/infer/estimate/touch.h"

#include <algorithm>
#include <cmath>

#include "core/base/named.h"
#include "core/infer/estimate/edge_pressure.h"
#include "core/infer/estimate/estimate.h"
#include "core/robot/kinematics.h"

namespace terratact {
namespace {

constexpr auto kTouchNames =
    namesOf<Touch>("felt", "remembered", "felt in part", "bounded", "not felt", "not recorded");

constexpr auto kElements = static_cast<std::size_t>(kForceElements);

constexpr double kMinEdge = 0.01;  // [m] along x: a steeper flipper covers no bin

/// Positions and loads of the front flippers' elements, from pivot to tip.
struct ElementLoads {
    std::array<double, kElements> x{};  ///< [m] DEM frame
    std::array<bool, kElements> loaded{};
    std::array<bool, kElements> even{};     ///< carries the load that even ground gives it
    double edgeBegin = 0.0, edgeEnd = 0.0;  ///< x of the edge's ends [m]
};

double neighbourForce(const Proprioception& s, std::size_t e)
{
    double most = 0.0;
    if (e > 0) most = std::max(most, s.force[e - 1].value_or(0.0));
    if (e + 1 < kElements) most = std::max(most, s.force[e + 1].value_or(0.0));
    return most;
}

bool carriesLoad(const Proprioception& s, std::size_t e)
{
    const double force = s.force[e].value_or(0.0);
    return force > kLoadThreshold && force > kLoadShare * neighbourForce(s, e);
}

ElementLoads loadsOf(const RobotModel& robot, const Proprioception& s)
{
    const Pose pose = poseInDem(robot, s.pitch, s.front, s.rear);
    ElementLoads loads;
    loads.edgeBegin = elementPosition(robot, pose, 0.0).x;
    loads.edgeEnd = elementPosition(robot, pose, 1.0).x;
    for (std::size_t e = 0; e < kElements; ++e) {
        loads.x[e] = elementPosition(robot, pose, robot.elementShare[e]).x;
        loads.loaded[e] = carriesLoad(s, e);
    }
    for (std::size_t e = 1; e + 1 < kElements; ++e)
        if (!s.force[e]) loads.loaded[e] = carriesLoad(s, e - 1) && carriesLoad(s, e + 1);
    return loads;
}

ElementLoads elementLoads(const RobotModel& robot, const Proprioception& s)
{
    ElementLoads loads = loadsOf(robot, s);
    const EdgePressure pressure(robot, s.force, loads.loaded);
    for (std::size_t e = 0; e < kElements; ++e)
        loads.even[e] = loads.loaded[e] && pressure.isEven() && pressure.hasItsShare(e);
    return loads;
}

/// Returns the position of x along the edge, within 0 … 1.
double shareAt(const ElementLoads& loads, double x)
{
    return std::clamp((x - loads.edgeBegin) / (loads.edgeEnd - loads.edgeBegin), 0.0, 1.0);
}

bool anyLoadWithin(const ElementLoads& loads, int bin)
{
    for (std::size_t e = 0; e < kElements; ++e)
        if (loads.loaded[e] && loads.x[e] >= binBegin(bin) && loads.x[e] < binEnd(bin)) return true;
    return false;
}

/// Returns true if every element carries its share, from the last one behind the bin to the first
/// one ahead.
bool elementsPress(const ElementLoads& loads, int bin)
{
    std::size_t first = kElements, last = kElements;
    for (std::size_t e = 0; e < kElements; ++e) {
        if (loads.x[e] >= binEnd(bin)) {
            last = e;
            break;
        }
        if (loads.x[e] < binBegin(bin) || first == kElements) first = e;
    }
    if (first == kElements || last == kElements) return false;
    return std::all_of(loads.even.begin() + static_cast<std::ptrdiff_t>(first),
                       loads.even.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                       [](bool even) { return even; });
}

bool isPressedThrough(const ElementLoads& loads, const EdgePressure& pressure, int bin)
{
    if (loads.edgeEnd - loads.edgeBegin < kMinEdge) return false;
    if (binBegin(bin) < loads.edgeBegin - kUnsensedWithin) return false;
    const double least = std::min(pressure.at(shareAt(loads, binBegin(bin))),
                                  pressure.at(shareAt(loads, binEnd(bin))));
    return least > 0.0 && elementsPress(loads, bin);
}

Touch touchOfBin(const ElementLoads& loads, const EdgePressure& pressure, int bin, bool covered)
{
    if (covered && isPressedThrough(loads, pressure, bin)) return Touch::Felt;
    if (anyLoadWithin(loads, bin)) return Touch::FeltInPart;
    return covered ? Touch::Bounded : Touch::NotFelt;
}

/// The cells of all bins in a line. A border has the number of the cell ahead of it.
class CellLine {
public:
    static constexpr int kAll = kBins * kFeltCells;
    CellLine(const FeltCells& cells, const TerrainEstimate& estimate)
        : cells_(cells), origin_(estimate.origin)
    {
    }
    bool isFelt(int cell) const { return (cells_[binAt(cell)] & bit(cell)) != 0U; }
    /// Returns true if the arm touched the ground at this border.
    bool isPoint(int border) const
    {
        return border % kFeltCells == kFeltCells / 2 && origin_[binAt(border)] == Origin::Arm;
    }
    void join(int from, int to)
    {
        for (int cell = from; cell < to; ++cell) cells_[binAt(cell)] |= bit(cell);
    }
    const FeltCells& cells() const { return cells_; }

private:
    static std::size_t binAt(int cell) { return static_cast<std::size_t>(cell / kFeltCells); }
    static std::uint16_t bit(int cell)
    {
        return static_cast<std::uint16_t>(1U << static_cast<unsigned>(cell % kFeltCells));
    }

    FeltCells cells_;
    std::array<Origin, kBins> origin_;
};

}  // namespace

std::string_view name(Touch touch)
{
    return nameIn(kTouchNames, touch);
}

std::optional<Touch> touchFromName(std::string_view text)
{
    return valueIn<Touch>(kTouchNames, text);
}

FeltCells cellsOf(const std::vector<GroundStretch>& stretches)
{
    constexpr double kWidth = kBinWidth / kFeltCells;
    constexpr double kRounding = 1e-9;  // [m]
    FeltCells cells{};
    for (int bin = 0; bin < kBins; ++bin)
        for (int k = 0; k < kFeltCells; ++k) {
            const double from = binBegin(bin) + kWidth * k;
            const bool felt = std::ranges::any_of(stretches, [&](const GroundStretch& stretch) {
                return stretch.from <= from + kRounding && stretch.to >= from + kWidth - kRounding;
            });
            if (felt) cells[static_cast<std::size_t>(bin)] |= static_cast<std::uint16_t>(1U << k);
        }
    return cells;
}

std::vector<GroundStretch> pressedStretches(const RobotModel& robot, const Proprioception& s)
{
    const ElementLoads loads = elementLoads(robot, s);
    const EdgePressure pressure(robot, s.force, loads.loaded);
    std::vector<GroundStretch> stretches;
    if (loads.edgeEnd - loads.edgeBegin < kMinEdge) return stretches;
    const auto presses = [&](std::size_t e) {
        return loads.even[e] && pressure.at(shareAt(loads, loads.x[e])) > 0.0;
    };
    for (std::size_t first = 0; first < kElements; ++first) {
        if (!presses(first)) continue;
        std::size_t last = first;
        while (last + 1 < kElements && presses(last + 1)) ++last;
        const double from = first == 0 ? loads.edgeBegin - kUnsensedWithin : loads.x[first];
        if (first == 0 ? pressure.at(0.0) > 0.0 : last > first)
            stretches.push_back({from, loads.x[last]});
        first = last;
    }
    return stretches;
}

PressedBins pressedBins(const RobotModel& robot, const Proprioception& s, const Heights& ceiling)
{
    const ElementLoads loads = elementLoads(robot, s);
    const EdgePressure pressure(robot, s.force, loads.loaded);
    const double pivot = toWorld(poseInDem(robot, s.pitch, s.front, s.rear), robot.front.pivot).x;
    PressedBins pressed;
    pressed.feltTo = binBegin(0);
    pressed.firstOfFlipper = kBins;
    pressed.cells = cellsOf(pressedStretches(robot, s));
    for (int bin = kBins - 1; bin >= 0; --bin) {
        const auto i = static_cast<std::size_t>(bin);
        const bool covered = std::isfinite(ceiling[i]);
        if (binCentre(bin) < pivot) {
            pressed.touch[i] = covered ? Touch::Bounded : Touch::NotFelt;
            continue;
        }
        pressed.firstOfFlipper = bin;
        pressed.touch[i] = touchOfBin(loads, pressure, bin, covered);
    }
    for (std::size_t e = 0; e < kElements; ++e)
        if (loads.loaded[e]) pressed.feltTo = std::max(pressed.feltTo, loads.x[e]);
    return pressed;
}

FeltCells joinedByArm(const FeltCells& felt, const TerrainEstimate& estimate)
{
    const CellLine before(felt, estimate);
    CellLine joined = before;
    // The arm's points lie at the middle of their bins, at the border before that cell.
    for (int point = kFeltCells / 2; point < CellLine::kAll; point += kFeltCells) {
        if (!before.isPoint(point)) continue;
        int from = point, to = point;
        while (from > 0 && !before.isFelt(from - 1) && (from == point || !before.isPoint(from)))
            --from;
        while (to < CellLine::kAll && !before.isFelt(to) && (to == point || !before.isPoint(to)))
            ++to;
        if (from > 0 && point - from <= kFeltCells) joined.join(from, point);
        if (to < CellLine::kAll && to - point <= kFeltCells) joined.join(point, to);
    }
    return joined.cells();
}

void addRemembered(TerrainEstimate& estimate, const FeltCells& earlier, const FeltCells& now)
{
    if (estimate.feltTo < binBegin(kFirstAhead)) return;
    FeltCells both{};
    for (std::size_t i = 0; i < kBins; ++i) both[i] = earlier[i] | now[i];
    const FeltCells joined = joinedByArm(both, estimate);
    for (auto i = static_cast<std::size_t>(kFirstAhead); i < kBins; ++i)
        if (estimate.touch[i] != Touch::Felt && earlier[i] != 0 && joined[i] == kAllCells)
            estimate.touch[i] = Touch::Remembered;
}

void writeTouch(TerrainEstimate& estimate, const PressedBins& pressed)
{
    estimate.touch = pressed.touch;
    estimate.feltTo = pressed.feltTo;
    const FeltCells joined = joinedByArm(pressed.cells, estimate);
    for (int bin = 0; bin < kBins; ++bin) {
        const auto i = static_cast<std::size_t>(bin);
        const bool touching = estimate.ceiling[i] - estimate.q10[i] <= kPressedWithin;
        if (bin < pressed.firstOfFlipper && touching) estimate.touch[i] = Touch::Felt;
        if (estimate.touch[i] == Touch::Felt) continue;
        const bool isJoined = joined[i] == kAllCells && pressed.cells[i] != kAllCells;
        if (bin >= kFirstAhead && isJoined)
            estimate.touch[i] = Touch::Felt;
        else if (estimate.origin[i] == Origin::Arm)
            estimate.touch[i] = Touch::FeltInPart;
    }
}

}  // namespace terratact
