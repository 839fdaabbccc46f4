#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/shell/preferences/preferences.h"
#include "core/base/message.h"

namespace terratact {

/// The preferences in force. They differ from the saved ones if the command line overrides them.
class PreferenceStore final : public QObject {
    Q_OBJECT
public:
    /// loaded: from the file. inForce: with the command line's overrides, which are never saved.
    PreferenceStore(LoadedPreferences loaded, Preferences inForce);
    PreferenceStore() : PreferenceStore({}, {}) {}  ///< defaults; reads and saves nothing

    const Preferences& current() const { return inForce_; }
    bool isSaved() const { return !loaded_.path.isEmpty(); }  ///< false in safe mode and in tests
    /// Returns the errors of loading.
    const std::vector<Message>& troubles() const { return loaded_.troubles; }

    /// Applies a change to the values in force and the saved values, and saves.
    void change(const std::function<void(Preferences&)>& edit);

signals:
    void changed(const terratact::Preferences& before);
    void notSaved(const terratact::Message& why);

private:
    LoadedPreferences loaded_;
    Preferences inForce_;
};

}  // namespace terratact
