#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"
#include "core/terrain/step.h"

namespace terratact {

struct TerrainEstimate;

/// Touch of a bin at this pose, strongest evidence first.
enum class Touch : std::uint8_t {
    Felt,  ///< the robot presses on all of it, or the arm measured it and the ground beside it
    Remembered,  ///< earlier poses felt all of it, or all that this pose does not feel
    FeltInPart,  ///< the robot or the arm felt a part of the bin, but not all of it
    Bounded,     ///< the robot is above it and does not press: the ground may be anywhere below
    NotFelt,     ///< no part of the robot covers all of it
    Unrecorded,  ///< the recording is older than this field
};
inline constexpr std::array kTouches{Touch::Felt,    Touch::Remembered, Touch::FeltInPart,
                                     Touch::Bounded, Touch::NotFelt,    Touch::Unrecorded};

/// Returns true if the whole bin was felt, now or earlier: it counts for the verdict's horizon.
constexpr bool isFeltThrough(Touch touch)
{
    return touch == Touch::Felt || touch == Touch::Remembered;
}

/// Returns "felt", "remembered", "felt in part", "bounded", "not felt" or "not recorded".
std::string_view name(Touch touch);
std::optional<Touch> touchFromName(std::string_view text);

/// One Touch per bin, rear to front.
using TouchMap = std::array<Touch, kBins>;

constexpr TouchMap unrecordedTouch()
{
    TouchMap map{};
    for (Touch& touch : map) touch = Touch::Unrecorded;
    return map;
}

/// A stretch of ground [m].
struct GroundStretch {
    double from = 0.0, to = 0.0;
    bool operator==(const GroundStretch&) const = default;
};

/// Parts of the bins, kFeltCells to a bin: bit k of a bin is the stretch
///   binBegin + k w … binBegin + (k + 1) w,   w = kBinWidth / kFeltCells.
using FeltCells = std::array<std::uint16_t, kBins>;
inline constexpr int kFeltCells = 10;
inline constexpr std::uint16_t kAllCells = (1U << kFeltCells) - 1U;

/// Returns the cells that lie within one of the stretches, DEM frame.
FeltCells cellsOf(const std::vector<GroundStretch>& stretches);

/// An element above this force [N] carries load. It is three standard deviations of an unloaded
/// element's noise (core/sim/sensor_noise.h).
inline constexpr double kLoadThreshold = 0.9;

/// A point load shows in the two nearest elements. An element below this share of its neighbour's
/// force shows no press of its own.
inline constexpr double kLoadShare = 0.2;

/// The tracks press where the lower edge is within this distance of the ground [m] with a
/// probability of 0.9.
inline constexpr double kPressedWithin = 0.015;

/// A bin may begin this far behind the flippers' edge [m], under the pivot, where no element is.
/// On level ground it is 0 m at pitch 0, and 0.01 m at pitch 0.07 rad.
inline constexpr double kUnsensedWithin = 0.01;

/// Touch of every bin according to the force elements of the front flippers.
struct PressedBins {
    /// Felt, FeltInPart, Bounded or NotFelt; behind the front pivot: Bounded or NotFelt.
    TouchMap touch{};
    /// The x of the foremost loaded element [m], DEM frame; binBegin(0): none is loaded.
    double feltTo = binBegin(0);
    int firstOfFlipper = kFirstAhead;  ///< rearmost bin whose centre lies ahead of the front pivot
    FeltCells cells{};                 ///< of pressedStretches()
};

/// Reads the elements at this pose. A bin is Felt if all of these hold
/// (core/infer/estimate/edge_pressure.h):
///   - Its ceiling is finite, and it begins at most kUnsensedWithin behind the flippers' edge.
///   - From the last element behind the bin to the first one ahead, each carries its share of load.
///   - All loads together fit even ground, with a pressure above 0 at both borders of the bin.
/// A bin is FeltInPart if some element within it carries load. An element that is not measured
/// counts as loaded if both neighbours are. Three hollows are not detected. The first is a gap of
/// about 0.02 m under the pivot's end. Element 1 changes there by less than its noise. The second
/// is a gap of up to 0.04 m before a saturated element 1. The third is a slot of less than 0.05 m.
/// docs/hazards.md shows how often they occur. ceiling: of this pose [m], +infinity where the bin
/// is not covered.
PressedBins pressedBins(const RobotModel& robot, const Proprioception& s, const Heights& ceiling);

/// Returns the stretches on which the front flippers press, DEM frame, rear to front. Each reaches
/// from one element to another. These two and all between carry their share of load on even ground,
/// with a pressure above 0 (as Felt). From element 1 on, it begins kUnsensedWithin behind the
/// flippers' edge.
std::vector<GroundStretch> pressedStretches(const RobotModel& robot, const Proprioception& s);

/// Returns the felt cells and those that the arm's points join. The arm touches a point at the centre
/// of its bin. Cells between a point and the next felt cell or point, at most kBinWidth away, count as felt. A narrower
/// fall may be overlooked. A point alone feels no cell, because a fall may begin beside it.
FeltCells joinedByArm(const FeltCells& felt, const TerrainEstimate& estimate);

/// Turns bins ahead into Remembered. Such a bin is not Felt, and a part of it was felt `earlier`.
/// Each of its cells was felt `earlier`, is felt `now`, or is joined by the arm (joinedByArm()).
/// Nothing changes unless an element ahead carries load now: memory alone carries no verdict. The
/// caller answers for `earlier`: the estimate knows the heights that were felt.
void addRemembered(TerrainEstimate& estimate, const FeltCells& earlier, const FeltCells& now);

/// Writes estimate.touch and estimate.feltTo. A bin of the arm is FeltInPart. Bins ahead whose cells
/// the arm's points join (joinedByArm()) are Felt. A bin behind the front pivot is Felt if ceiling − q10 ≤
/// kPressedWithin. By the estimate's posterior, the tracks then carry the robot there.
void writeTouch(TerrainEstimate& estimate, const PressedBins& pressed);

}  // namespace terratact
