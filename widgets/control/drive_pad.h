#pragma once

#include <QStringList>
#include <QWidget>

#include "app/display/precondition.h"

namespace terratact {

class HeldButton;

/// Hold-to-run buttons (dead-man control) to drive and to feel forward. Emits a request when the hold begins, and halt
/// or letGo on release for any reason.
class DrivePad final : public QWidget {
    Q_OBJECT
public:
    explicit DrivePad(QWidget* parent = nullptr);

    /// Buttons are enabled unless a precondition is Missing; the tip lists all preconditions.
    void setPreconditions(const QList<Precondition>& preconditions);
    /// The same for feel forward, which a doubtful precondition disables, too. feels: it goes on, so that its button
    /// stays enabled.
    void setFeelPreconditions(const QList<Precondition>& preconditions, bool feels);

    /// Compact layout with shorter texts. Where even these do not fit, the buttons show their keys.
    void setNarrow(bool narrow);
    void setProminent(bool prominent);  ///< larger buttons for the driving layout

    HeldButton* forwardButton() const { return forward_; }
    HeldButton* backButton() const { return back_; }
    HeldButton* feelButton() const { return feel_; }

    QSize minimumSizeHint() const override;

signals:
    void driveRequested(int direction);  ///< +1 forward, −1 back
    void haltRequested();
    void feelForwardRequested();
    void letGo();  ///< the button of feel forward is not held any more

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class Length { Full, Short, Keys };
    QStringList texts(Length length) const;  ///< back, feel, forward
    int widthOf(Length length) const;        ///< [px]
    void chooseTexts();

    bool narrow_ = false;
    HeldButton* forward_ = nullptr;
    HeldButton* back_ = nullptr;
    HeldButton* feel_ = nullptr;
};

}  // namespace terratact
