#pragma once

#include <QString>

#include "core/log/review_moment.h"

namespace terratact {

/// What changed from A to B, in one line: time, pitch, flippers, forces.  What was not measured at both reads "--".
QString differenceWords(const ReviewMoment& a, const ReviewMoment& b);

/// The numbers of a moment as CSV, with a heading line: time, attitude, flippers, currents, forces.
QString numbersCsv(const ReviewMoment& moment);

}  // namespace terratact
