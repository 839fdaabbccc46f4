#include "app/shell/preferences/preference_store.h"

#include <utility>

namespace terratact {

PreferenceStore::PreferenceStore(LoadedPreferences loaded, Preferences inForce)
    : loaded_(std::move(loaded)), inForce_(std::move(inForce))
{
}

void PreferenceStore::change(const std::function<void(Preferences&)>& edit)
{
    const Preferences before = inForce_, saved = loaded_.preferences;
    edit(inForce_);
    edit(loaded_.preferences);
    if (loaded_.preferences != saved) {
        const auto trouble = savePreferences(loaded_.path, loaded_.preferences);
        if (trouble) emit notSaved(*trouble);
    }
    if (inForce_ != before) emit changed(before);
}

}  // namespace terratact
