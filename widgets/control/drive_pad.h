#pragma once

#include <QWidget>

#include "app/display/precondition.h"

namespace terratact {

class HeldButton;

/// Hold-to-run drive buttons (dead-man control). Emits a drive request while a button is held, and halt on release for
/// any reason.
class DrivePad final : public QWidget {
    Q_OBJECT
public:
    explicit DrivePad(QWidget* parent = nullptr);

    /// Buttons are enabled unless a precondition is Missing; the tip lists all preconditions.
    void setPreconditions(const QList<Precondition>& preconditions);

    void setNarrow(bool narrow);        ///< compact layout with shorter texts
    void setProminent(bool prominent);  ///< larger buttons for the driving layout

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
