#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/robot/measurement.h"
#include "core/robot/robot_model.h"
#include "core/terrain/bins.h"
#include "core/terrain/step.h"

namespace terratact {

struct TerrainEstimate;

/// How a bin was touched at this pose, the strongest evidence first.
enum class Touch : std::uint8_t {
    Felt,        ///< the robot presses on all of it, or the arm measured it
    FeltInPart,  ///< something presses within the bin, another stretch of it is not pressed
    Bounded,     ///< the robot is above it and does not press: it may be anything below
    NotFelt,     ///< no part of the robot is above all of it
    Unrecorded,  ///< an old recording does not say
};
inline constexpr std::array kTouches{Touch::Felt, Touch::FeltInPart, Touch::Bounded, Touch::NotFelt,
                                     Touch::Unrecorded};

/// "felt", "felt in part", "bounded", "not felt", "not recorded".
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

/// An element carries load above this force [N]: three standard deviations of an unloaded element's noise
/// (core/sim/sensor_noise.h).
inline constexpr double kLoadThreshold = 0.9;

/// A point load shows in the two nearest elements. An element with less than this share of its neighbour's
/// force does not show a press of its own.
inline constexpr double kLoadShare = 0.2;

/// The tracks press where the lower edge is this close to the ground [m], with a probability of 0.9.
inline constexpr double kPressedWithin = 0.015;

/// A bin may begin this far behind the flippers' edge [m]: under the pivot, where no element is. At a pitch of 0 it is
/// 0 m; nose up by 0.15 rad on level ground it is 0.02 m.
inline constexpr double kUnsensedWithin = 0.02;

/// What the force elements of the front flippers say about the ground below them.
struct PressedBins {
    TouchMap
        touch{};  ///< Felt, FeltInPart, Bounded or NotFelt; bins behind the front pivot: Bounded or NotFelt
    double feltTo =
        0.0;  ///< x of the foremost loaded element [m], DEM frame; binBegin(0): none is loaded
    int firstOfFlipper =
        kFirstAhead;  ///< the rearmost bin whose centre lies ahead of the front pivot
};

/// Reads the elements at this pose. A bin is Felt if all of this holds (core/infer/estimate/edge_pressure.h):
///   its ceiling is finite, and it begins at most kUnsensedWithin behind the flippers' edge
///   every element carries load, and its share of it, from the last one behind the bin to the first one ahead of it
///   the loads together are those of even ground, and the fitted pressure is above 0 at both borders of the bin
/// It is FeltInPart if some element within it carries load. An element that is not measured counts as loaded if both
/// its neighbours are.
/// What this cannot see: a gap under the pivot's end that takes less of element 1 than its noise, some 0.02 m; one
/// before an element 1 that saturates, up to 0.04 m; and a slot of less than 0.05 m. docs/hazards.md says how often.
///   ceiling: of this pose [m], +infinity where the bin is not covered.
PressedBins pressedBins(const RobotModel& robot, const Proprioception& s, const Heights& ceiling);

/// Writes estimate.touch and estimate.feltTo. The arm's bins are Felt. A bin behind the front pivot is Felt if
/// ceiling − q10 ≤ kPressedWithin: the tracks carry the robot there by the estimate's own posterior.
void writeTouch(TerrainEstimate& estimate, const PressedBins& pressed);

}  // namespace terratact
