#pragma once

#include <QKeyEvent>
#include <QList>
#include <QString>
#include <functional>

class QEvent;
class QObject;
class QWidget;

namespace terratact {

/// The keys that mean STOP wherever one is: many keyboards have F12 only together with another key.
inline const QList<QKeyCombination> kStopKeys{Qt::Key_F12, Qt::Key_Pause};

/// What the keys of the window mean: both what is done when one is pressed and the sheet that tells of it come
/// from here.
class KeyTable {
public:
    struct Entry {
        QList<QKeyCombination> keys;
        QString meaning;
        std::function<void()> pressed;
        std::function<void()> released = {};  ///< set: the key acts while it is held
        /// In every window of the program, dialogs included, and whatever else is held down.
        bool everywhere = false;
        bool repeats = false;  ///< acts again and again while it stays down
        /// Set: where it says no, the key is left to the widget that has the focus.
        std::function<bool()> applies = {};
    };
    void addGroup(const QString& name);
    void add(Entry entry);  ///< to the last group; throws std::logic_error for a key that is taken

    /// The entry a key event means; null: none.  Shift and the keypad do not count, nor for what works everywhere
    /// any other modifier.
    const Entry* entryOf(const QKeyEvent& event) const;
    /// Lets go of what the key held, whatever else is pressed.
    void release(int key) const;

    /// To be called by the event filter of the application for events of the window: true where a key did what it
    /// means, which a widget that has a use of its own for it does first.
    bool filter(const QWidget& window, const QObject& object, const QEvent& event) const;

    QString html() const;  ///< the sheet: a table per group, two groups side by side
    const QList<Entry>& entries() const { return entries_; }

private:
    struct Group {
        QString name;
        qsizetype begin;
    };
    QList<Group> groups_;
    QList<Entry> entries_;
};

}  // namespace terratact
