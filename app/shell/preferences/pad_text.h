#pragma once

#include <QString>

#include "app/link/gamepad/pad_mapping.h"

namespace terratact {

/// Return the names of an action that the operator reads: "approve the probe (hold)"; short: "approve".
QString actionName(PadAction action);
QString shortName(PadAction action);

/// Return the names of a gamepad's controls: "A (lower)", "left stick, up and down".
QString controlName(const PadControl& control);
QString axisName(PadAxis axis);

}  // namespace terratact
