#include "app/review/review_note_field.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/review/review_player.h"
#include "core/log/session_reader.h"
#include "widgets/base/tips.h"

namespace terratact {

ReviewNoteField::ReviewNoteField(const SessionReader& session, const ReviewPlayer& player,
                                 QWidget* parent)
    : QLineEdit(parent), session_(session), player_(player)
{
    setPlaceholderText(tr("note (M)"));
    setAccessibleName(tr("Note at this time"));
    setTip(*this, tr("Kept beside the session, in %1; Enter saves it")
                      .arg(format::fileName(QString::fromStdString(notesPath(session.path())))));
    if (auto notes = readNotes(session.path()))
        notes_ = std::move(*notes);
    else
        trouble_ = translated(notes.error().message);
    connect(this, &QLineEdit::returnPressed, this, &ReviewNoteField::submit);
}

void ReviewNoteField::submit()
{
    const QString entered = text().trimmed();
    if (entered.isEmpty()) return;
    std::vector<ReviewNote> notes = notes_;
    notes.push_back({player_.position(), entered.toStdString()});
    std::stable_sort(notes.begin(), notes.end(),
                     [](const ReviewNote& a, const ReviewNote& b) { return a.time < b.time; });
    const Status saved = writeNotes(session_.path(), notes);
    trouble_ = saved ? QString() : tr("NOTE NOT SAVED: %1").arg(translated(saved.error().message));
    if (saved) {
        notes_ = std::move(notes);
        clear();
    }
    emit submitted();
}

}  // namespace terratact
