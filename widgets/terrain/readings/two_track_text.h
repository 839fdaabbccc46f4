#pragma once

#include <QString>

#include "core/infer/verdict/two_track_verdict.h"

namespace terratact {

// Texts of the verdict of two tracks. A verdict of one plane has the texts of VerdictStrip.

/// Returns "left ✘ BLOCKED at +0.4 m · right ✔ CLEAR to +0.55 m". Equal answers follow "each side"; if they are the
/// robot's answer, too, the text is empty. isShort: "L ✘ BLOCKED 0.4 · R ✔ CLEAR 0.55 m".
QString sidesText(const TwoTrackVerdict& verdict, bool isShort = false);

/// Returns the probability of a step on either side; for CLEAR, those of each side up to its horizon. limit: [m].
QString eitherText(const TwoTrackVerdict& verdict, double limit);

/// Returns "cross slope 41° of 54°, L up" where it is within the amber reserve of tipping over; else empty.
QString crossSlopeText(const TwoTrackVerdict& verdict);

/// Returns what the verdict means, or why there is none. isBrief: in few words.
QString whyText(const TwoTrackVerdict& verdict, bool isBrief);

}  // namespace terratact
