#include "app/pages/force_arrays.h"

#include <QCoreApplication>
#include <algorithm>

#include "display/format.h"

namespace terratact {
namespace {

// Returns the voltage of an element; the sensor line numbers the voltages per side.
std::optional<double> voltageOf(const SensorLine& line, Side side, std::size_t element)
{
    const auto& three = line.voltages[(side == Side::Left ? 0U : 2U) + element / 3];
    return three ? std::optional((*three)[element % 3]) : std::nullopt;
}

bool hasVoltages(const SensorLine& line)
{
    return std::any_of(line.voltages.begin(), line.voltages.end(),
                       [](const auto& three) { return three.has_value(); });
}

QString nameOf(const ForceArrayLayout& layout)
{
    if (!layout.name.empty()) return format::shownName(layout.name);
    return layout.side == Side::Left ? QCoreApplication::translate("terratact::ForceArrays", "L")
                                     : QCoreApplication::translate("terratact::ForceArrays", "R");
}

}  // namespace

static_assert(kMaxForceArrays <= ForceBars::kArrays);

ForceArray ForceArrays::arrayOf(const ForceArrayLayout& layout, const SensorLine& line,
                                const ElementForces& felt, ForceDrift::Forces& beyondBias) const
{
    ForceArray array;
    const Side side = layout.side;
    array.name = nameOf(layout);
    const auto& forces = side == Side::Left ? felt.left : felt.right;
    for (std::size_t e = 0; e < forces.size(); ++e) {
        ForceElement& element = array.elements[e];
        element.exists = layout.has[e];
        if (!element.exists) continue;
        element.volts = voltageOf(line, side, e);
        if (!forces[e] || !element.volts) continue;
        element.saturated = forces[e]->state == ElementState::Saturated;
        if (element.saturated || forces[e]->state == ElementState::Sound)
            element.newtons = forces[e]->force;
        beyondBias[e] = signedForce(*element.volts, side, static_cast<int>(e),
                                    robot_.forceCalibration, robot_.forceSaturation);
    }
    return array;
}

std::vector<ForceArray> ForceArrays::of(const Measurement& measurement,
                                        const std::optional<SensorLine>& line, double threshold)
{
    std::vector<ForceArray> arrays;
    std::vector<ForceDrift::Forces> beyondBias;
    if (line && hasVoltages(*line)) {
        const ElementForces felt = elementForces(*line, robot_);
        for (const ForceArrayLayout& layout : robot_.forceArrays) {
            beyondBias.emplace_back();
            arrays.push_back(arrayOf(layout, *line, felt, beyondBias.back()));
        }
    } else {
        arrays.emplace_back();
        beyondBias.emplace_back();
        for (std::size_t e = 0; e < measurement.force.size(); ++e)
            if (!measurement.missing[kFirstForceFeature + e])
                arrays[0].elements[e].newtons = beyondBias[0][e] = measurement.force[e];
    }
    drifts_.resize(arrays.size());
    const bool unloaded = isUnloaded(measurement, threshold);
    for (std::size_t a = 0; a < arrays.size(); ++a) {
        if (unloaded) drifts_[a].take(measurement.time, beyondBias[a]);
        for (int e = 0; e < kForceElements; ++e)
            arrays[a].elements[static_cast<std::size_t>(e)].drift = drifts_[a].drift(e);
    }
    return arrays;
}

}  // namespace terratact
