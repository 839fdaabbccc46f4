#pragma once

#include <QString>

#include "app/display/tone.h"
#include "core/robot/measurement.h"

namespace terratact {

/// Returns the robot's activity in few words for the header; describe() has the whole sentence.
QString glance(RobotActivity activity);
Tone toneOf(RobotActivity activity);

}  // namespace terratact
