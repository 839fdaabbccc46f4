#pragma once

#include <QLineEdit>
#include <vector>

#include "app/recording/review_notes.h"

namespace terratact {

class ReviewPlayer;
class SessionReader;

/// Input field for a note at the reviewed time, with all existing notes. Notes are kept beside the session
/// (review_notes.h); the session itself never changes.
class ReviewNoteField final : public QLineEdit {
    Q_OBJECT
public:
    /// Reads the notes. Session and player must outlive the field.
    ReviewNoteField(const SessionReader& session, const ReviewPlayer& player, QWidget* parent);

    const std::vector<ReviewNote>& notes() const { return notes_; }  ///< sorted by time
    /// Returns the last error of reading or saving notes; empty: none.
    const QString& trouble() const { return trouble_; }

signals:
    /// Emitted after Enter. The note is saved and in notes(), or trouble() has the reason and the text stays in the
    /// field.
    void submitted();

private:
    void submit();

    const SessionReader& session_;
    const ReviewPlayer& player_;
    std::vector<ReviewNote> notes_;
    QString trouble_;
};

}  // namespace terratact
