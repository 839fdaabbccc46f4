#pragma once

#include <QString>
#include <vector>

#include "app/shell/preferences/preference_values.h"

namespace terratact {

/// Returns what a preference is called in lists of changes; empty for an unknown key.
QString preferenceLabel(const QString& key);

/// Returns true if the value decides what the robot may do, when the operator is warned, or what is deleted. These are
/// step and tilt limits, hazards, gamepad, robot file (with its torques), model, and deletion of sessions.
bool isSafetyRelevant(const QString& key);

/// One changed preference in the operator's words.
struct PreferenceChange {
    QString key, label, before, now;
    bool isSafety = false;
};

/// Returns every changed preference, the safety-relevant ones first; of the gamepad, a change per action. Long texts
/// are shortened where they agree, so that their first difference is always seen. The window's place is left out.
std::vector<PreferenceChange> changesBetween(const Preferences& before, const Preferences& now);

}  // namespace terratact
