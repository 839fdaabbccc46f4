#include "app/shell/preferences/preference_store.h"

#include <utility>

namespace terratact {

PreferenceStore::PreferenceStore(LoadedPreferences loaded, Preferences inForce, Save save)
    : loaded_(std::move(loaded)), inForce_(std::move(inForce)), save_(std::move(save))
{
    saver_.setMaxThreadCount(1);
}

void PreferenceStore::change(const std::function<void(Preferences&)>& edit)
{
    const Preferences before = inForce_, saved = loaded_.preferences;
    edit(inForce_);
    edit(loaded_.preferences);
    if (loaded_.preferences != saved && isSaved()) saveSoon();
    if (inForce_ != before) emit changed(before);
}

void PreferenceStore::saveSoon()
{
    saver_.clear();  // older values that still wait
    saver_.start([this, preferences = loaded_.preferences] {
        const auto trouble = save_(loaded_.path, preferences);
        if (!trouble) return;
        QMetaObject::invokeMethod(
            this, [this, why = *trouble] { emit notSaved(why); }, Qt::QueuedConnection);
    });
}

}  // namespace terratact
