#pragma once

#include <QString>
#include <vector>

#include "app/link/can_source.h"
#include "app/link/frame_history.h"
#include "drivers/can_bus.h"
#include "widgets/base/theme.h"

namespace terratact {

/// What is the matter with a bus, and the command that mends it.
QString busWords(BusState state, const std::string& bus);

/// One word for it: "ACTIVE", "BUS-OFF".
QString glance(BusState state);

/// Bad where it does not work as it has to.
Tone toneOf(BusState state);

/// "≤ 14 %": the load with all the stuff bits that there can be; "--- %" where the bit rate is not known.
QString loadGlance(const BusLoad& load, const BitRate& bitrate);

/// Why nothing arrives from a robot, or leaves for it: of its bus where there is one that does not work, else what its
/// source said.
QString troubleWords(const CanSource* link, const std::string& said);

/// What still comes of a robot whose telemetry has stopped for so many seconds: "frames still come, heartbeat 0.1 s old";
/// empty: no frame of it that could be used is younger than kLinkLostAfter and half the silence, as none is that came with
/// the last telemetry.
QString stillComes(const std::vector<TappedFrame>& frames, double silence);

/// Why this console only follows; empty where it commands.
QString whyFollowing(const CanSource* link);

}  // namespace terratact
