#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/measurement.h"

namespace terratact {

/// One measured point of a force-sensing resistor's curve.
struct ForcePoint {
    double force = 0.0;       ///< [N]
    double resistance = 0.0;  ///< [Ω]
    bool operator==(const ForcePoint&) const = default;
};

/// From voltage to force, for the six elements of both front flippers: force-sensing resistor and reference
/// resistor in series, the voltage taken on the reference resistor, so that it rises with force.
struct ForceCalibration {
    double supply = 0.0;            ///< [V] across both resistors
    double reference = 0.0;         ///< [Ω]
    std::vector<ForcePoint> curve;  ///< at least two; force rises, resistance falls
    std::array<double, kForceElements> biasLeft{}, biasRight{};  ///< [N] of the unloaded sandwich
    double openBelow = 0.0;                                      ///< [V] a wire is broken
    double shortAbove = 0.0;                                     ///< [V] two wires touch
    bool operator==(const ForceCalibration&) const = default;
};

enum class Side : std::uint8_t { Left, Right };

/// A row of force elements under the front flippers: those of a side's six that it is made of.
struct ForceArrayLayout {
    std::string name;  ///< empty: that of its side
    Side side = Side::Left;
    std::array<bool, kForceElements> has{};  ///< element 1 (pivot) … 6 (tip)
    bool operator==(const ForceArrayLayout&) const = default;
};

/// Six elements left and six right: all that the link carries.
std::vector<ForceArrayLayout> leftAndRightArrays();

/// Whether one of the arrays has the element; `element` 0 … 5, else it throws std::out_of_range.
bool haveElement(const std::vector<ForceArrayLayout>& arrays, Side side, int element);

enum class ElementState : std::uint8_t { Sound, Saturated, Open, Short };
std::string describe(ElementState state);

struct ElementForce {
    double force = 0.0;  ///< [N] on the flipper, never negative; 0 where Open or Short
    ElementState state = ElementState::Sound;
    bool operator==(const ElementForce&) const = default;
};

/// The resistance of the element: reference · (supply / voltage − 1) [Ω].
/// Throws std::invalid_argument unless 0 < voltage < supply.
double elementResistance(double voltage, const ForceCalibration& calibration);

/// The force at which the curve has this resistance [N]: log R is interpolated over log F, and its end
/// pieces go on beyond the ends.  (A line through the conductance, as often seen, is off between points
/// and jumps where two lines meet.)  Throws std::invalid_argument unless 0 < resistance < infinity, and
/// for a curve that is none.
double curveForce(double resistance, const ForceCalibration& calibration);

/// What an element feels beyond its bias; `element` 0 … 5.  At `saturation` [N] (bias included) and above
/// it is Saturated and reads that much.  Throws std::invalid_argument unless the voltage is finite and the
/// element exists.
ElementForce elementForce(double voltage, Side side, int element,
                          const ForceCalibration& calibration, double saturation);

/// The same for a Sound element, but negative where it feels less than its bias [N]; empty for any other.
std::optional<double> signedForce(double voltage, Side side, int element,
                                  const ForceCalibration& calibration, double saturation);

}  // namespace terratact
