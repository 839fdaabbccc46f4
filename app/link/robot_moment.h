#pragma once

#include <optional>

#include "app/link/acquisition.h"
#include "app/link/can_source.h"

namespace terratact {

/// What a console knows of its robot at one time. One place takes it per tick; everything that is decided or drawn in
/// that tick uses it, so that no newer value is paired with an older one.
struct RobotMoment {
    double now = 0.0;                  ///< [s] steady clock
    std::optional<Received> latest{};  ///< newest telemetry; empty: none came yet
    std::optional<CanView> bus{};      ///< empty: the source is no bus
};

/// Takes the moment now. link: null if the source is no bus.
inline RobotMoment momentOf(double now, const Acquisition& acquisition, const CanSource* link)
{
    return {now, acquisition.latest(), link ? std::optional(link->view()) : std::nullopt};
}

}  // namespace terratact
