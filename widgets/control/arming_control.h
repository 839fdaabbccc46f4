#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <optional>

#include "app/display/precondition.h"
#include "core/atem/arming.h"
#include "core/base/message.h"

class QPushButton;

namespace terratact {

class HoldToConfirmButton;

/// Shows whether commands from this console move the robot. It arms in two distinct actions: a click, then a hold. It
/// shows one button at a time. Disarming takes one click and is always possible.
class ArmingControl final : public QWidget {
    Q_OBJECT
public:
    explicit ArmingControl(QWidget* parent = nullptr);

    /// Arming is possible unless a precondition is Missing; the tip lists all preconditions.
    void setState(const ArmingState& state, const QList<Precondition>& preconditions);
    /// The source accepts no commands because it is receive-only or a replay; `why` gives the reason.
    void setListening(const QString& why);

    QPushButton* armButton() const { return arm_; }
    HoldToConfirmButton* confirmButton() const { return confirm_; }

    /// Press and release of the window-wide key. Some X servers repeat a held key as releases and presses. A press
    /// right after a release is therefore not a second action. A press that cannot arm emits impossible().
    void pressKey();
    void releaseKey();

    QSize sizeHint() const override;  ///< size of the widest state, so that neighbours never move
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void armingWanted();
    void armingConfirmed();
    void disarmed();
    /// The key was pressed, and this precondition of arming is Missing.
    void impossible(const terratact::Message& missing);

private:
    QPushButton* arm_ = nullptr;
    HoldToConfirmButton* confirm_ = nullptr;
    QPushButton* disarm_ = nullptr;
    QElapsedTimer released_;
    bool listens_ = false;
    std::optional<Message> missing_;  ///< first Missing precondition of arming
};

}  // namespace terratact
