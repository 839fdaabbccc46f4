#pragma once

#include <optional>

#include "core/atem/contact_watch.h"
#include "core/robot/attitude.h"

namespace terratact {

/// What a driver needs to see; the drive strip shows it. Empty: not known, or too old.
struct DriveViewState {
    struct Angle {
        double angle = 0.0;  ///< [rad]
        AttitudeLevel level = AttitudeLevel::Level;
        AttitudeLimits limits{};  ///< active
        double tips = 0.0;        ///< tips over here [rad]
        bool operator==(const Angle&) const = default;
    };
    std::optional<Angle> pitch{}, roll{};
    std::optional<FlipperContacts> contact{};
    std::optional<double> speed{};   ///< [m/s] forward positive
    std::optional<double> way{};     ///< rolled since the last estimate [m]
    std::optional<double> feltTo{};  ///< the ground is felt to here, forward from the IMU [m]
    bool feltEnds = false;           ///< felt ground ends under the tracks, or nothing is felt
    bool operator==(const DriveViewState&) const = default;
};

}  // namespace terratact
