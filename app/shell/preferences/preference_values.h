#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/shell/preferences/preferences.h"
#include "core/base/message.h"

namespace terratact {

/// One preference as text.
struct PreferenceValue {
    const char* key;   ///< in every file of settings
    QString text;      ///< in SI units; a list has one entry a line
    const char* unit;  ///< "m", "rad", …; empty: none
    bool isList;
};

/// Returns every preference in the order of the file.
std::vector<PreferenceValue> valuesOf(const Preferences& preferences);

/// Sets the preference of this key; returns empty if it was set. If the key or the text is not valid, changes nothing
/// and returns what was expected.
std::optional<Message> setValue(Preferences& preferences, const QString& key, const QString& text);

}  // namespace terratact
