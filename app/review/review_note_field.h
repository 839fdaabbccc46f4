#pragma once

#include <QLineEdit>
#include <vector>

#include "app/review/review_notes.h"

namespace terratact {

class ReviewPlayer;
class SessionReader;

/// Where a note at the time under review is entered, with the notes that there are: they are kept beside the session
/// (review_notes.h), which is never changed.
class ReviewNoteField final : public QLineEdit {
    Q_OBJECT
public:
    /// Reads the notes.  Both must outlive it.
    ReviewNoteField(const SessionReader& session, const ReviewPlayer& player, QWidget* parent);

    const std::vector<ReviewNote>& notes() const { return notes_; }  ///< by their times
    /// With reading or saving them, in words; empty: none.
    const QString& trouble() const { return trouble_; }

signals:
    /// A note is among notes() and saved; or trouble() says why not, and it still stands in the field.
    void taken();

private:
    void take();

    const SessionReader& session_;
    const ReviewPlayer& player_;
    std::vector<ReviewNote> notes_;
    QString trouble_;
};

}  // namespace terratact
