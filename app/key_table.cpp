#include "app/key_table.h"

#include <QCoreApplication>
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
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.keys.contains(pressed);
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

QString KeyTable::html() const
{
    // One table, not two in the cells of a third: of those QLabel gets the width wrong, and cuts them.
    const QString nothing = QStringLiteral("<td></td><td></td>");
    QStringList columns[2];
    for (qsizetype g = 0; g < groups_.size(); ++g) {
        const qsizetype end = g + 1 < groups_.size() ? groups_[g + 1].begin : entries_.size();
        QStringList& column = columns[g % 2];
        if (!column.isEmpty()) column << nothing;
        column << QStringLiteral("<td colspan=2><big><b>%1</b></big></td>")
                      .arg(groups_[g].name.toHtmlEscaped());
        for (qsizetype i = groups_[g].begin; i < end; ++i)
            column << QStringLiteral("<td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td>")
                          .arg(namesOf(entries_[i]), entries_[i].meaning.toHtmlEscaped());
    }
    QString rows;
    for (qsizetype i = 0; i < std::max(columns[0].size(), columns[1].size()); ++i)
        rows += QStringLiteral("<tr>%1<td width=40></td>%2</tr>")
                    .arg(columns[0].value(i, nothing), columns[1].value(i, nothing));
    return QStringLiteral("<table cellpadding=3>%1</table>").arg(rows);
}

}  // namespace terratact
