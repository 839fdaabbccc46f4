#pragma once

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QList>
#include <QString>
#include <functional>

class QEvent;
class QObject;
class QWidget;

namespace terratact {

/// The keys of STOP. Many keyboards have F12 only in combination, so Pause works, too.
inline const QList<QKeyCombination> kStopKeys{Qt::Key_F12, Qt::Key_Pause};

/// The key bindings of a window; both the actions and the key sheet are generated from this table.
class KeyTable {
public:
    struct Entry {
        QList<QKeyCombination> keys;
        QString meaning;
        std::function<void()> pressed;
        std::function<void()> released = {};  ///< set: the key acts while it is held
        /// Replaces `pressed` when the key follows its own release within kRepetition. Some X servers repeat a held key
        /// as release and press.
        std::function<void()> repeated = {};
        /// Active in every window of the program including dialogs, with any modifier.
        bool everywhere = false;
        bool repeats = false;  ///< acts repeatedly while held
        /// If it returns false, the focused widget receives the key.
        std::function<bool()> applies = {};
    };
    static constexpr int kRepetition = 40;  ///< [ms]

    void addGroup(const QString& name);
    void add(Entry entry);  ///< adds to the last group; throws std::logic_error for a used key

    /// Returns the entry of a key event; null: none. Shift is ignored
    /// unless an entry names it, and the keypad is; entries with `everywhere` ignore
    /// all modifiers.
    const Entry* entryOf(const QKeyEvent& event) const;
    /// Releases the held key's action, whatever else is pressed.
    void release(int key) const;

    /// Handles an event of the window in the application's event filter. Returns true if a key was handled. A widget
    /// that uses the key itself has precedence.
    bool filter(const QWidget& window, const QObject& object, const QEvent& event) const;

    QString html() const;  ///< the key sheet: one table per group, two groups side by side
    const QList<Entry>& entries() const { return entries_; }

private:
    struct Group {
        QString name;
        qsizetype begin;
    };
    bool isRepetition(int key) const;

    QList<Group> groups_;
    QList<Entry> entries_;
    mutable int releasedKey_ = 0;  ///< the last one
    mutable QElapsedTimer sinceRelease_;
};

}  // namespace terratact
