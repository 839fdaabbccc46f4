#pragma once

#include <QTimer>
#include <optional>

#include "app/link/gamepad/pad_intents.h"
#include "app/link/gamepad/pad_learner.h"
#include "app/shell/page.h"
#include "app/shell/preferences/preference_store.h"
#include "widgets/control/pad_view.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace terratact {

/// The settings of the gamepad: what arrives from it, the control of each action, dead zone and speed limit. While the
/// page is visible, the gamepad moves nothing; STOP acts.
class GamepadPage final : public Page {
    Q_OBJECT
public:
    explicit GamepadPage(PreferenceStore& store, QWidget* parent = nullptr);

    /// Takes the newest state; called at every tick while the page is visible, so that no short press is missed.
    void poll(const GamepadState& state);
    void refresh(double now) override;

    QLabel* statusLabel() const { return status_; }
    QLabel* answerLabel() const { return answer_; }
    QComboBox* actionBox() const { return action_; }
    QPushButton* assignButton() const { return assign_; }
    PadView* actions() const { return actions_; }
    PadView* axes() const { return axes_; }
    PadView* buttons() const { return buttons_; }
    QDoubleSpinBox* deadZoneBox() const { return deadZone_; }
    QDoubleSpinBox* speedBox() const { return speed_; }
    QPushButton* defaultsButton() const { return defaults_; }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* buildActions();
    QWidget* buildArrivals();
    QWidget* buildDrive();
    PadAction chosen() const;
    void learn();
    void endLearning(const QString& answer);
    void assign(PadAction action, const PadControl& control);
    void arrange();
    void showMapping();
    void showState();
    PadLine lineOf(PadAction action) const;
    void showArrivals();

    PreferenceStore& store_;
    GamepadState state_;
    PadFollower follower_;  ///< shows which action works, and moves nothing
    PadIntents intents_;
    std::optional<PadLearner> learner_;
    QTimer learning_;  ///< ends an assignment without an answer
    QComboBox* action_ = nullptr;
    QPushButton* assign_ = nullptr;
    PadView* actions_ = nullptr;
    PadView* axes_ = nullptr;
    PadView* buttons_ = nullptr;
    QBoxLayout* columns_ = nullptr;
    QLabel* status_ = nullptr;
    QLabel* answer_ = nullptr;
    QDoubleSpinBox* deadZone_ = nullptr;
    QDoubleSpinBox* speed_ = nullptr;
    QPushButton* defaults_ = nullptr;
};

}  // namespace terratact
