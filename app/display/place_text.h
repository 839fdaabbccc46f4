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
QString placeText(int bin, ProbeSide side);

/// Returns a bin's name with its side, short: "0.5 m", "L 0.5 m" or "R 0.5 m".
QString placeName(int bin, ProbeSide side);

}  // namespace terratact
