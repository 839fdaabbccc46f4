#pragma once

#include "core/base/message.h"
#include "core/infer/verdict/two_track_verdict.h"
#include "core/log/rows/session_rows.h"

namespace terratact {

// Texts that the reports of a scene and of a session have in common.

/// Returns all settings of an estimate in one line.
Message settingsText(const Settings& settings);

/// Returns the readings of the arm, "+0.120 m at +0.3 m left (sd 5 mm)", or "none".
Message readingsText(const EstimateRow& row);

/// Returns the verdict of one profile with the probability of a step. If the verdict is withheld or not CLEAR, the
/// reason follows. limit: [m].
Message stepText(const Verdict& verdict, double limit);

/// Return an event's subject and text, as names of events for translators. What a person typed stays as it is. The
/// subject of an event without one is "marker".
Message subjectMessage(const EventRow& event);
Message textMessage(const EventRow& event);

/// Returns the steepest cross slope and the probability of more than its limit.
Message crossSlopeText(const CrossSlope& slope);

}  // namespace terratact
