#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "core/atem/arming.h"
#include "widgets/control/precondition.h"

class QPushButton;

namespace terratact {

class HoldToConfirmButton;

/// Whether commands from here move the robot, and the two distinct actions that arm it, a click and then a
/// hold.  One button at a time; disarming takes one click and is always possible.
class ArmingControl final : public QWidget {
    Q_OBJECT
public:
    explicit ArmingControl(QWidget* parent = nullptr);

    /// Arming is possible unless one of its preconditions is Missing; all are in the tip.
    void setState(const ArmingState& state, const QList<Precondition>& preconditions);
    /// The source takes no commands at all: only listened to, or a replay, as `why` says.
    void setListening(const QString& why);

    QPushButton* armButton() const { return arm_; }
    HoldToConfirmButton* confirmButton() const { return confirm_; }
    QPushButton* disarmButton() const { return disarm_; }

    /// What the window-wide key means at this moment.  A press right after a release is no second action: some X
    /// servers repeat a held key like that.
    void pressKey();
    void releaseKey();

    QSize
    sizeHint() const override;  ///< that of the widest button there may be: nothing beside it moves
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void armingWanted();
    void armingConfirmed();
    void disarmed();

private:
    QPushButton* arm_ = nullptr;
    HoldToConfirmButton* confirm_ = nullptr;
    QPushButton* disarm_ = nullptr;
    QElapsedTimer released_;
    bool listens_ = false;
};

}  // namespace terratact
