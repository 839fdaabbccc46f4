#pragma once

#include <QString>

#include "core/log/review_moment.h"

namespace terratact {

/// Returns the changes from A to B in one line: time, pitch, flippers, forces. A value that was not measured at both
/// reads "--". Where left and right changed by other amounts, or the roll changed, the line has both sides and the
/// roll.
QString differenceText(const ReviewMoment& a, const ReviewMoment& b);

/// Returns the numbers of a moment as CSV with a heading: time, attitude, flippers, currents, forces; forces of each
/// front flipper at the end.
QString numbersCsv(const ReviewMoment& moment);

}  // namespace terratact
