#pragma once

#include <QObject>
#include <QStringList>
#include <functional>

#include "app/shell/preferences.h"

namespace terratact {

/// The preferences in force, which may differ from the saved ones where the command line said so.
class PreferenceStore final : public QObject {
    Q_OBJECT
public:
    /// loaded: as the file says.  inForce: the same with what the command line said, which is never saved.
    PreferenceStore(LoadedPreferences loaded, Preferences inForce);
    PreferenceStore() : PreferenceStore({}, {}) {}  ///< the defaults; nothing is read or saved

    const Preferences& current() const { return inForce_; }
    QStringList troubles() const;  ///< of loading, in words

    /// Applies a change to what is in force and to what is saved, and saves it.
    void change(const std::function<void(Preferences&)>& edit);

signals:
    void changed(const terratact::Preferences& before);
    void notSaved(const QString& why);

private:
    LoadedPreferences loaded_;
    Preferences inForce_;
};

}  // namespace terratact
