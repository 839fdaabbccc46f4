#include "core/learn/data/side_features.h"

#include <array>
#include <optional>

namespace terratact {

namespace {

using SideValues = std::array<std::optional<double>, kSideFeatures>;

constexpr std::size_t kElementsOfSide = std::size_t{kForceElements};

SideValues valuesOf(const TwoTrackReadings& s, Side own)
{
    SideValues values{s.pitch, signOf(own) * s.roll};
    std::size_t angle = 2, current = kFirstSideCurrent, force = kFirstSideForce;
    for (const Side side : {own, opposite(own)}) {
        for (const Flipper flipper : {frontFlipper(side), rearFlipper(side)}) {
            values[angle++] = s.flippers[indexOf(flipper)];
            values[current++] = s.currents[indexOf(flipper)];
        }
        for (const auto& element : s.forces[indexOf(frontFlipper(side))]) values[force++] = element;
    }
    return values;
}

}  // namespace

Eigen::VectorXd sideFeatures(const TwoTrackReadings& s, Side own)
{
    const SideValues values = valuesOf(s, own);
    Eigen::VectorXd x(Eigen::Index{kSideFeatures});
    for (std::size_t d = 0; d < kSideFeatures; ++d)
        x[static_cast<Eigen::Index>(d)] = values[d].value_or(0.0);
    return x;
}

AbsentFeatures absentFeatures(const TwoTrackReadings& s, Side own)
{
    const SideValues values = valuesOf(s, own);
    AbsentFeatures absent;
    for (std::size_t d = 0; d < kSideFeatures; ++d) absent[d] = !values[d];
    return absent;
}

TwoTrackReadings readingsOf(const Eigen::VectorXd& sideFeatures)
{
    const auto value = [&](std::size_t d) { return sideFeatures[static_cast<Eigen::Index>(d)]; };
    TwoTrackReadings s;
    s.pitch = value(0);
    s.roll = value(1);
    std::size_t angle = 2, current = kFirstSideCurrent, force = kFirstSideForce;
    for (const Side side : {Side::Left, Side::Right}) {
        for (const Flipper flipper : {frontFlipper(side), rearFlipper(side)}) {
            s.flippers[indexOf(flipper)] = value(angle++);
            s.currents[indexOf(flipper)] = value(current++);
        }
        for (auto& element : s.forces[indexOf(frontFlipper(side))]) element = value(force++);
    }
    return s;
}

std::size_t otherSideFeature(std::size_t d)
{
    if (d < 2) return d;
    if (d < kFirstSideForce) return (d - 2) % 4 < 2 ? d + 2 : d - 2;  // two angles, two currents
    return d < kFirstSideForce + kElementsOfSide ? d + kElementsOfSide : d - kElementsOfSide;
}

}  // namespace terratact
