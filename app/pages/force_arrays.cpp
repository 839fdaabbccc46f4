#include "app/pages/force_arrays.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/place_text.h"

namespace terratact {
namespace {

QString nameOf(const ForceArrayLayout& layout)
{
    if (!layout.name.empty()) return format::shownName(layout.name);
    return layout.side == Side::Left ? QCoreApplication::translate("terratact::ForceArrays", "L")
                                     : QCoreApplication::translate("terratact::ForceArrays", "R");
}

}  // namespace

std::vector<ForceArray> rearArraysOf(const Measurement& measurement)
{
    std::vector<ForceArray> arrays(2);
    const SideForces& sides = measurement.rearSides;
    for (const Side side : {Side::Left, Side::Right}) {
        ForceArray& array = arrays[indexOf(side)];
        array.name = sideLetter(side);
        const auto& forces = side == Side::Left ? sides.left : sides.right;
        for (std::size_t e = 0; e < forces.size(); ++e) array.elements[e].newtons = forces[e];
    }
    return arrays;
}

static_assert(kMaxForceArrays <= ForceBars::kArrays);

ForceArray ForceArrays::arrayOf(const ForceArrayLayout& layout, const ElementForces& felt,
                                ForceDrift::Forces& beyondBias) const
{
    ForceArray array;
    array.name = nameOf(layout);
    const auto& forces = layout.side == Side::Left ? felt.left : felt.right;
    for (std::size_t e = 0; e < forces.size(); ++e) {
        ForceElement& element = array.elements[e];
        element.exists = layout.has[e];
        if (!element.exists || !forces[e]) continue;
        const ElementForce& force = *forces[e];
        element.volts = force.voltage;
        element.saturated = force.state == ElementState::Saturated;
        const bool sound = force.state == ElementState::Sound;
        if (element.saturated || sound) element.newtons = force.force;
        if (sound) beyondBias[e] = force.beyondBias;
    }
    return array;
}

std::vector<ForceArray> ForceArrays::of(const Measurement& measurement, const ElementForces& felt,
                                        double threshold)
{
    std::vector<ForceArray> arrays;
    std::vector<ForceDrift::Forces> beyondBias;
    if (felt.carried) {
        for (const ForceArrayLayout& layout : robot_.forceArrays) {
            beyondBias.emplace_back();
            arrays.push_back(arrayOf(layout, felt, beyondBias.back()));
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
        if (unloaded) drifts_[a].add(measurement.time, beyondBias[a]);
        for (int e = 0; e < kForceElements; ++e)
            arrays[a].elements[static_cast<std::size_t>(e)].drift = drifts_[a].drift(e);
    }
    return arrays;
}

}  // namespace terratact
