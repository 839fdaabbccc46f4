#pragma once

#include <string>

#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/session_rows.h"

namespace terratact {

// Texts that the reports of a scene and of a session have in common.

/// Returns all settings of an estimate in one line.
std::string settingsText(const Settings& settings);

/// Returns the readings of the arm, "+0.120 m at +0.3 m left (sd 5 mm)", or "none".
std::string readingsText(const EstimateRow& row);

/// Returns the verdict of one profile, the probability of a step, and why it is not CLEAR or withheld. limit: [m].
std::string stepText(const Verdict& verdict, double limit);

/// Returns the steepest cross slope and the probability of more than its limit.
std::string crossSlopeText(const CrossSlope& slope);

}  // namespace terratact
