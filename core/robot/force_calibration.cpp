#include "core/robot/force_calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "core/base/text.h"

namespace terratact {
namespace {

std::string nameOf(Side side, int element)
{
    std::string name = side == Side::Left ? "left" : "right";
    name += " element ";
    name += std::to_string(element + 1);
    return name;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

void requireReading(const ForceReading& r)
{
    if (r.element < 0 || r.element >= kForceElements)
        throw std::invalid_argument("calibrate: the elements are 0 to 5");
    if (!(r.applied >= 0.0) || !std::isfinite(r.applied) || !std::isfinite(r.voltage))
        throw std::invalid_argument("calibrate: force and voltage must be numbers");
}

// Returns the force without a saturation limit, which a calibration must not apply.
ElementForce feltBy(const ForceReading& r, const ForceCalibration& c)
{
    return elementForce(r.voltage, r.side, r.element, c, std::numeric_limits<double>::max());
}

using Arrays = std::vector<ForceArrayLayout>;

Status fitBias(const std::vector<ForceReading>& readings, Side side, const Arrays& arrays,
               ForceCalibration& c)
{
    auto& bias = side == Side::Left ? c.biasLeft : c.biasRight;
    for (int e = 0; e < kForceElements; ++e) {
        if (!haveElement(arrays, side, e)) continue;
        std::vector<double> forces;
        for (const ForceReading& r : readings)
            if (r.side == side && r.element == e && r.applied == 0.0)
                forces.push_back(curveForce(elementResistance(r.voltage, c), c));
        if (forces.empty()) return Error{nameOf(side, e) + " has no unloaded reading", 0};
        bias[static_cast<std::size_t>(e)] = median(forces);
    }
    return Done{};
}

double meanBias(const ForceCalibration& c, const Arrays& arrays)
{
    double sum = 0.0;
    int count = 0;
    for (const ForceArrayLayout& array : arrays)
        for (std::size_t e = 0; e < kForceElements; ++e) {
            if (!array.has[e]) continue;
            sum += (array.side == Side::Left ? c.biasLeft : c.biasRight)[e];
            ++count;
        }
    return sum / count;
}

Status fitCurve(const std::vector<ForceReading>& readings, const Arrays& arrays,
                ForceCalibration& c)
{
    std::map<double, std::vector<double>> resistances;  // by applied force
    for (const ForceReading& r : readings)
        resistances[r.applied].push_back(elementResistance(r.voltage, c));
    if (resistances.size() < 2) return Done{};  // no force was applied
    const double bias = meanBias(c, arrays);
    std::vector<ForcePoint> curve;
    for (const auto& [applied, values] : resistances) {
        const double resistance = median(values);
        if (!curve.empty() && resistance >= curve.back().resistance)
            return Error{"the resistance does not fall up to " + numberText(applied) + " N", 0};
        curve.push_back({applied + bias, resistance});
    }
    c.curve = std::move(curve);
    return Done{};
}

}  // namespace

Result<FittedCalibration> calibrate(const std::vector<ForceReading>& readings,
                                    const ForceCalibration& present, const Arrays& arrays)
{
    for (const ForceReading& r : readings) {
        requireReading(r);
        if (!haveElement(arrays, r.side, r.element))
            return Error{nameOf(r.side, r.element) + " belongs to no force array of the robot", 0};
        const ElementState state = feltBy(r, present).state;
        if (state == ElementState::Open || state == ElementState::Short)
            return Error{nameOf(r.side, r.element) + " at " + numberText(r.voltage)
                             + " V: " + describe(state).english,
                         0};
    }
    FittedCalibration fitted{.calibration = present};
    ForceCalibration& c = fitted.calibration;
    for (const Side side : {Side::Left, Side::Right})
        if (const Status done = fitBias(readings, side, arrays, c); !done) return done.error();
    if (const Status done = fitCurve(readings, arrays, c); !done) return done.error();
    // Fits the bias again on the new curve: the bias must be in the new curve's forces.
    for (const Side side : {Side::Left, Side::Right})
        if (const Status done = fitBias(readings, side, arrays, c); !done) return done.error();
    std::vector<double> errors;
    errors.reserve(readings.size());
    for (const ForceReading& r : readings)
        errors.push_back(std::abs(feltBy(r, c).force - r.applied));
    fitted.medianError = median(errors);
    fitted.worstError = *std::max_element(errors.begin(), errors.end());
    return fitted;
}

}  // namespace terratact
