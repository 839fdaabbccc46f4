#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Measured point of the curve of a force-sensing resistor (FSR).
struct ForcePoint {
    double force = 0.0;       ///< [N]
    double resistance = 0.0;  ///< [Ω]
    bool operator==(const ForcePoint&) const = default;
};

/// Calibration from voltage to force for the six elements of both front flippers. A force-sensing
/// resistor and a reference resistor are in series. The voltage is measured on the reference
/// resistor, so that it rises with force. Rear elements use the same curve without a bias.
struct ForceCalibration {
    double supply = 0.0;            ///< [V] across both resistors
    double reference = 0.0;         ///< [Ω]
    std::vector<ForcePoint> curve;  ///< at least two; force rises, resistance falls
    std::array<double, kForceElements> biasLeft{}, biasRight{};  ///< [N] of the unloaded sandwich
    double openBelow = 0.0;                                      ///< [V] below: a wire is broken
    double shortAbove = 0.0;                                     ///< [V] above: two wires touch
    bool operator==(const ForceCalibration&) const = default;
};

enum class Side : std::uint8_t { Left, Right };

/// Returns the place of a side in an array of both.
constexpr std::size_t indexOf(Side side)
{
    return static_cast<std::size_t>(side);
}

/// Row of force elements under the front flippers: a subset of one side's six elements.
struct ForceArrayLayout {
    std::string name;  ///< empty: named after its side
    Side side = Side::Left;
    std::array<bool, kForceElements> has{};  ///< element 1 (pivot) … 6 (tip)
    bool operator==(const ForceArrayLayout&) const = default;
};

/// Returns two arrays, all six elements left and all six right: everything that the link carries.
std::vector<ForceArrayLayout> leftAndRightArrays();

/// Returns true if one of the arrays has the element 0 … 5. Throws std::out_of_range for another
/// element.
bool haveElement(const std::vector<ForceArrayLayout>& arrays, Side side, int element);

enum class ElementState : std::uint8_t { Sound, Saturated, Open, Short };
SourceText describe(ElementState state);

struct ElementForce {
    double force = 0.0;  ///< [N] on the flipper, never negative; 0 where Open or Short
    ElementState state = ElementState::Sound;
    double beyondBias = 0.0;  ///< [N] signed: negative below the bias; 0 unless Sound
    double voltage = 0.0;     ///< [V] measured voltage
    bool operator==(const ElementForce&) const = default;
};

/// Returns the resistance of the element: reference · (supply / voltage − 1) [Ω]. Throws
/// std::invalid_argument unless 0 < voltage < supply.
double elementResistance(double voltage, const ForceCalibration& calibration);

/// Returns the force [N] at which the curve has this resistance. log R is interpolated over log F,
/// and the end pieces are extrapolated. A line through the conductance, often used elsewhere, is
/// wrong between points and jumps where two lines meet. Throws std::invalid_argument unless 0 <
/// resistance < infinity, and for an invalid curve.
double curveForce(double resistance, const ForceCalibration& calibration);

/// Returns the force of an element beyond its bias; `element` 0 … 5. From `saturation` [N] on (bias
/// included) it is Saturated and reads that value. Throws std::invalid_argument unless the voltage
/// is finite and the element exists.
ElementForce elementForce(double voltage, Side side, int element,
                          const ForceCalibration& calibration, double saturation);

}  // namespace terratact
