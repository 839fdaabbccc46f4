#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/display/tone.h"
#include "app/link/can_source.h"
#include "app/link/frame_history.h"
#include "core/base/message.h"
#include "drivers/can_bus.h"

namespace terratact {

/// Returns the fault of a bus and the command that fixes it.
QString busStateText(BusState state, const std::string& bus);

/// Returns the bus state in one word: "ACTIVE", "BUS-OFF".
QString glance(BusState state);

/// Returns Bad for a bus that does not work.
Tone toneOf(BusState state);

/// Returns the load with the maximum stuff bits: "≤ 14 %"; "--- %" for an unknown bit rate.
QString loadGlance(const BusLoad& load, const BitRate& bitrate);

/// Returns why nothing is received or sent: the fault of the robot's bus, else the source's own text.
Message troubleOf(const CanSource* link, const Message& said);
Message troubleOf(const CanView* bus, const Message& said);

/// Returns what is still received after telemetry has stopped for `silence` seconds: "frames still come, heartbeat 0.1
/// s old". Only usable frames younger than kLinkLostAfter and half the silence count, because others may have come with
/// the last telemetry. Empty: none.
QString stillComes(const std::vector<TappedFrame>& frames, double silence);

/// Returns why this console only follows; empty: it commands.
std::optional<Message> whyFollowing(const CanSource* link);

}  // namespace terratact
