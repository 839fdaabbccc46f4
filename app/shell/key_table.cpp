#include "app/shell/key_table.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QKeySequence>
#include <algorithm>
#include <stdexcept>
#include <utility>

namespace terratact {
namespace {

struct Says {
    Q_DECLARE_TR_FUNCTIONS(KeyTable)
};

QString namesOf(const KeyTable::Entry& entry)
{
    QStringList names;
    for (const QKeyCombination key : entry.keys)
        names << QKeySequence(key).toString(QKeySequence::NativeText).toHtmlEscaped();
    const QString all = names.join(Says::tr(" or "));
    return entry.released ? Says::tr("%1, held").arg(all) : all;
}

/// Returns true for keys that the widget itself uses: text typed into a field must not move the robot.
bool belongsTo(const QWidget& widget, int key)
{
    const bool isFunctionKey = key >= Qt::Key_F1 && key <= Qt::Key_F12;
    const bool takesText = widget.inherits("QLineEdit") || widget.inherits("QAbstractSpinBox")
                        || widget.inherits("QComboBox");
    if (takesText) return !isFunctionKey;
    const bool moves = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Space;
    return moves && qobject_cast<const QAbstractItemView*>(&widget);
}

}  // namespace

void KeyTable::addGroup(const QString& name)
{
    groups_ << Group{name, entries_.size()};
}

void KeyTable::add(Entry entry)
{
    for (const QKeyCombination key : entry.keys)
        for (const Entry& other : entries_)
            if (other.keys.contains(key)) throw std::logic_error("a key with two meanings");
    entries_ << std::move(entry);
}

const KeyTable::Entry* KeyTable::entryOf(const QKeyEvent& event) const
{
    const auto modifiers = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    const QKeyCombination pressed(modifiers, static_cast<Qt::Key>(event.key()));
    const QKeyCombination shifted(event.modifiers() & ~Qt::KeypadModifier,
                                  static_cast<Qt::Key>(event.key()));
    for (const Entry& entry : entries_)
        if (entry.keys.contains(shifted)) return &entry;
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        if (!entry.everywhere) return entry.keys.contains(pressed);
        return std::any_of(entry.keys.begin(), entry.keys.end(),
                           [&](QKeyCombination own) { return own.key() == pressed.key(); });
    });
    return found == entries_.end() ? nullptr : &*found;
}

void KeyTable::release(int key) const
{
    for (const Entry& entry : entries_) {
        if (!entry.released) continue;
        for (const QKeyCombination own : entry.keys)
            if (own.key() == key) entry.released();
    }
}

bool KeyTable::isRepetition(int key) const
{
    return key == releasedKey_ && sinceRelease_.isValid() && sinceRelease_.elapsed() <= kRepetition;
}

bool KeyTable::filter(const QWidget& window, const QObject& object, const QEvent& event) const
{
    const bool press = event.type() == QEvent::KeyPress;
    if (!(press || event.type() == QEvent::KeyRelease) || !object.isWidgetType()) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const Entry* const entry = entryOf(key);
    if (entry && entry->everywhere) {
        if (press && !key.isAutoRepeat()) entry->pressed();
        return press;
    }
    // The release of a held key counts everywhere: over a menu, in a dialog, with Ctrl held.
    if (!press && !key.isAutoRepeat()) {
        release(key.key());
        releasedKey_ = key.key();
        sinceRelease_.start();
    }
    const auto& widget = static_cast<const QWidget&>(object);
    if (!entry || !entry->pressed || widget.window() != &window || QApplication::activeModalWidget()
        || QApplication::activePopupWidget())
        return false;
    if (belongsTo(widget, key.key())) return false;
    if (entry->applies && !entry->applies()) return false;
    // Space presses the focused button; it has the table's meaning only without one.
    if (key.key() == Qt::Key_Space && qobject_cast<const QAbstractButton*>(&widget)) return false;
    if (press && (!key.isAutoRepeat() || entry->repeats)) {
        const bool repeats = entry->repeated && isRepetition(key.key());
        (repeats ? entry->repeated : entry->pressed)();
    }
    return true;
}

QString KeyTable::html() const
{
    QString columns[2];
    for (qsizetype g = 0; g < groups_.size(); ++g) {
        const qsizetype end = g + 1 < groups_.size() ? groups_[g + 1].begin : entries_.size();
        QString& column = columns[g % 2];
        column +=
            QStringLiteral("<h3>%1</h3><table cellpadding=3>").arg(groups_[g].name.toHtmlEscaped());
        for (qsizetype i = groups_[g].begin; i < end; ++i)
            if (!entries_[i].meaning.isEmpty())
                column += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                              .arg(namesOf(entries_[i]), entries_[i].meaning.toHtmlEscaped());
        column += QStringLiteral("</table>");
    }
    return QStringLiteral("<table width=100%><tr><td valign=top>%1</td><td width=40></td><td "
                          "valign=top>%2</td></tr></table>")
        .arg(columns[0], columns[1]);
}

}  // namespace terratact
