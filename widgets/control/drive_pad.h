#pragma once

#include <QWidget>

#include "widgets/control/precondition.h"

namespace terratact {

class HeldButton;

/// Drives while a button is held.  Says halt when it is let go, for whatever reason.
class DrivePad final : public QWidget {
    Q_OBJECT
public:
    explicit DrivePad(QWidget* parent = nullptr);

    /// Enabled unless one is Missing; all are in the tip.
    void setPreconditions(const QList<Precondition>& preconditions);

    void setNarrow(bool narrow);        ///< little room: fewer words
    void setProminent(bool prominent);  ///< larger, for who drives most of the time

    HeldButton* forwardButton() const { return forward_; }
    HeldButton* backButton() const { return back_; }

signals:
    void driveRequested(int direction);  ///< +1 forward, −1 back
    void haltRequested();

private:
    HeldButton* forward_ = nullptr;
    HeldButton* back_ = nullptr;
};

}  // namespace terratact
