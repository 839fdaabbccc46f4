#pragma once

#include "core/base/message.h"
#include "core/robot/probe_side.h"

namespace terratact {

/// Returns where the arm touches the ground: "at 0.6 m" in the middle, "left at 0.6 m" on a side.
Message placeMessage(ProbePlace place);

/// Returns the name of the place: "0.6 m" in the middle, "left at 0.6 m" on a side.
Message placeName(ProbePlace place);

}  // namespace terratact
