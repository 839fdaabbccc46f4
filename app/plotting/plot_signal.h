#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace terratact {

/// Where the values of a signal come from.
enum class SignalOrigin : std::uint8_t {
    Telemetry,  ///< complete lines of telemetry, in SI units
    Bus,        ///< frames of the robot's protocol, one by one
    Estimate,   ///< estimates; a value holds until the next one
    Payload     ///< frames of other devices that a DBC file describes
};

/// Returns "telemetry", "bus", "estimate" or "payload".
std::string_view name(SignalOrigin origin);
/// Returns the same for the operator.
SourceText describe(SignalOrigin origin);

/// A signal that can be plotted.
struct PlotSignal {
    SignalOrigin origin = SignalOrigin::Telemetry;
    std::string id{};     ///< the same in every language and session; unique within the origin
    Message name{};       ///< for the operator
    std::string unit{};   ///< empty: none
    std::string frame{};  ///< "022 Attitude", of bus and payload; empty: no frame

    bool isHeld() const { return origin == SignalOrigin::Estimate; }
    /// Returns "telemetry:pitch": names the signal in saved sets.
    std::string key() const { return std::string(terratact::name(origin)) + ':' + id; }
};

}  // namespace terratact
