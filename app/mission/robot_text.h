#pragma once

#include <QString>

#include "core/robot/measurement.h"
#include "widgets/base/theme.h"

namespace terratact {

/// What a robot does, short enough for the header; the whole sentence is describe()'s.
QString glance(RobotActivity activity);
Tone toneOf(RobotActivity activity);

}  // namespace terratact
