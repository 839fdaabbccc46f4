#pragma once

#include <optional>

#include "app/link/acquisition.h"
#include "app/link/can_source.h"

namespace terratact {

/// Consistent snapshot of the robot for one tick of the console. One place takes it per tick, and all decisions and
/// drawings of that tick use it. No newer value is therefore paired with an older one.
struct RobotMoment {
    double now = 0.0;                  ///< [s] steady clock
    std::optional<Received> latest{};  ///< newest telemetry; empty: none came yet
    std::optional<CanView> bus{};      ///< empty: the source is no bus
};

/// Takes the snapshot now. link: null if the source is no bus.
inline RobotMoment momentOf(double now, const Acquisition& acquisition, const CanSource* link)
{
    return {now, acquisition.latest(), link ? std::optional(link->view()) : std::nullopt};
}

}  // namespace terratact
