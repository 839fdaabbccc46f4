#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <optional>
#include <vector>

#include "app/shell/preferences/preferences.h"
#include "core/base/message.h"

namespace terratact {

/// The active preferences. They differ from the saved ones if the command line overrides them. Another thread saves
/// them, because a disk may take longer than a window may freeze. The destructor waits for it.
class PreferenceStore final : public QObject {
    Q_OBJECT
public:
    using Save = std::function<std::optional<Message>(const QString& path, const Preferences&)>;

    /// loaded: from the file. inForce: with the command line's overrides, which are never saved. save: called in the
    /// other thread.
    PreferenceStore(LoadedPreferences loaded, Preferences inForce, Save save = savePreferences);
    PreferenceStore() : PreferenceStore({}, {}) {}  ///< defaults; reads and saves nothing

    const Preferences& current() const { return inForce_; }
    bool isSaved() const { return !loaded_.path.isEmpty(); }  ///< false in safe mode and in tests
    /// Returns the errors of loading.
    const std::vector<Message>& troubles() const { return loaded_.troubles; }

    /// Applies a change to the active values and to the saved values. Where saving takes long, the newest values
    /// are saved next.
    void change(const std::function<void(Preferences&)>& edit);

signals:
    void changed(const terratact::Preferences& before);
    void notSaved(const terratact::Message& why);

private:
    void saveSoon();

    LoadedPreferences loaded_;
    Preferences inForce_;
    Save save_;
    QThreadPool saver_;  ///< of one thread; its destructor waits for the last save
};

}  // namespace terratact
