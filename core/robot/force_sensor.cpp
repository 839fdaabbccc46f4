#include "core/robot/force_sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/base/message.h"

namespace terratact {
namespace {

double biasOf(const ForceCalibration& calibration, Side side, int element)
{
    const auto& bias = side == Side::Left ? calibration.biasLeft : calibration.biasRight;
    return bias[static_cast<std::size_t>(element)];
}

// Returns true for a finite value above 0, and false for NaN.
bool isPositive(double value)
{
    return value > 0.0 && std::isfinite(value);
}

void requireCurve(const std::vector<ForcePoint>& curve)
{
    bool good = curve.size() >= 2;
    for (std::size_t i = 0; good && i < curve.size(); ++i) {
        good = isPositive(curve[i].force) && isPositive(curve[i].resistance);
        if (i > 0)
            good = good && curve[i].force > curve[i - 1].force
                && curve[i].resistance < curve[i - 1].resistance;
    }
    if (!good)
        throw std::invalid_argument(
            "curveForce: force must rise and resistance fall, both positive");
}

}  // namespace

std::vector<ForceArrayLayout> leftAndRightArrays()
{
    std::vector<ForceArrayLayout> arrays(2);
    arrays[1].side = Side::Right;
    for (ForceArrayLayout& array : arrays) array.has.fill(true);
    return arrays;
}

bool haveElement(const std::vector<ForceArrayLayout>& arrays, Side side, int element)
{
    const auto e = static_cast<std::size_t>(element);
    return std::any_of(arrays.begin(), arrays.end(), [&](const ForceArrayLayout& array) {
        return array.has.at(e) && array.side == side;
    });
}

SourceText describe(ElementState state)
{
    switch (state) {
    case ElementState::Sound: return {"", "sound"};
    case ElementState::Saturated: return TR_NOOP("core", "saturated");
    case ElementState::Open: return TR_NOOP("core", "wire broken");
    case ElementState::Short: return TR_NOOP("core", "short circuit");
    }
    throw std::invalid_argument("describe: no such ElementState");
}

double elementResistance(double voltage, const ForceCalibration& c)
{
    if (!(voltage > 0.0 && voltage < c.supply))
        throw std::invalid_argument(
            "elementResistance: the voltage must lie between 0 and the supply");
    return c.reference * (c.supply / voltage - 1.0);
}

double curveForce(double resistance, const ForceCalibration& calibration)
{
    const std::vector<ForcePoint>& curve = calibration.curve;
    requireCurve(curve);
    if (!isPositive(resistance))
        throw std::invalid_argument("curveForce: the resistance must be positive and finite");
    std::size_t i = 1;  // end of the piece
    while (i + 1 < curve.size() && resistance < curve[i].resistance) ++i;
    const ForcePoint& a = curve[i - 1];
    const ForcePoint& b = curve[i];
    const double share =
        std::log(resistance / a.resistance) / std::log(b.resistance / a.resistance);
    const double force = a.force * std::pow(b.force / a.force, share);
    return std::min(force, std::numeric_limits<double>::max());
}

ElementForce elementForce(double voltage, Side side, int element, const ForceCalibration& c,
                          double saturation)
{
    if (!std::isfinite(voltage))
        throw std::invalid_argument("elementForce: the voltage must be finite");
    if (element < 0 || element >= kForceElements)
        throw std::invalid_argument("elementForce: the elements are 0 to 5");
    ElementForce felt{.voltage = voltage};
    if (voltage <= 0.0 || voltage < c.openBelow)
        felt.state = ElementState::Open;
    else if (voltage >= c.supply || voltage > c.shortAbove)
        felt.state = ElementState::Short;
    if (felt.state != ElementState::Sound) return felt;
    const double bias = biasOf(c, side, element);
    const double total = curveForce(elementResistance(voltage, c), c);
    felt.force = std::max(0.0, std::min(total, saturation) - bias);
    if (total >= saturation)
        felt.state = ElementState::Saturated;
    else
        felt.beyondBias = total - bias;
    return felt;
}

}  // namespace terratact
