#pragma once

#include <QString>

#include "core/robot/force_sensor.h"
#include "core/robot/probe_side.h"

namespace terratact {

/// Returns "L" or "R": the letter of a side on the screen.
QString sideLetter(Side side);

/// Returns "left" or "right".
QString sideWord(Side side);

/// Returns where the arm touches: "at 0.5 m", "left at 0.5 m" or "right at 0.5 m".
QString placeText(ProbePlace place);

/// Returns the name of a bin and its side: "bin 0.5 m", "left bin 0.5 m", "right bin 0.5 m".
QString binText(ProbePlace place);

/// Returns the short name of a place: "0.5 m", "L 0.5 m" or "R 0.5 m".
QString sidePlace(ProbePlace place);

/// Returns the shortest name of a place: "0.5 m", "L 0.5" or "R 0.5". A name with a side has no unit.
QString shortPlace(ProbePlace place);

}  // namespace terratact
