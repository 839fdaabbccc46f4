// Tests the page of the gamepad: what arrives, assignment, number boxes and defaults.
#include "app/console/pages/gamepad_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <utility>

#include "tests/support/gui.h"

namespace terratact {
namespace {

using gui::eventually;

struct GamepadSettings : testing::Test {
    GamepadSettings()
    {
        page.resize(1000, 560);
        gui::showActive(page);
        state.connection = 1;
        state.name = "Rescue pad";
    }
    void show()
    {
        page.poll(state);
        page.refresh(0.0);
    }
    /// Shows it idle, then with one more control moved.
    template <class Control>
    void move(Control control, double value = 1.0)
    {
        show();
        const auto before = state[control];
        state[control] = static_cast<decltype(+state[control])>(value);
        show();
        state[control] = before;
        show();
    }
    const PadSettings& saved() const { return store.current().pad; }
    /// Begins the assignment of an action.
    void learn(PadAction action)
    {
        page.actionBox()->setCurrentIndex(static_cast<int>(action));
        page.assignButton()->click();
    }
    const PadLine& line(PadAction action) const
    {
        return page.actions()->lines().at(static_cast<std::size_t>(action));
    }
    const PadLine& line(PadButton button) const
    {
        return page.buttons()->lines().at(static_cast<std::size_t>(button));
    }
    QString answer() const { return page.answerLabel()->text(); }

    PreferenceStore store;
    GamepadPage page{store};
    GamepadState state;
};

TEST_F(GamepadSettings, saysWhichGamepadIsConnected)
{
    EXPECT_TRUE(page.statusLabel()->text().startsWith("No gamepad is connected"));
    EXPECT_FALSE(page.assignButton()->isEnabled());
    show();
    EXPECT_EQ(page.statusLabel()->text(), "Connected: Rescue pad");
    EXPECT_TRUE(page.assignButton()->isEnabled());
    state.radio = true;
    show();
    EXPECT_TRUE(page.statusLabel()->text().contains("By radio"));
    state = {};
    state.trouble = Message::verbatim("“Odd stick” is not used");
    show();
    EXPECT_EQ(page.statusLabel()->text(), "“Odd stick” is not used");
}

TEST_F(GamepadSettings, aNameOfADeviceIsShownPlain)
{
    state.name = "<b>pad</b>\n\x1b[31m" + std::string(500, 'x');
    show();
    const QString text = page.statusLabel()->text();
    EXPECT_TRUE(text.startsWith("Connected: <b>pad</b>"));
    EXPECT_FALSE(text.contains(QChar(0x1b)) || text.contains('\n'));
    EXPECT_LT(text.size(), 130);
}

TEST_F(GamepadSettings, showsWhatArrivesAndWhatItDoes)
{
    using enum PadLine::State;
    show();
    EXPECT_EQ(line(PadButton::X).text, "X (left) · explore");
    EXPECT_EQ(line(PadButton::X).state, Off);
    EXPECT_EQ(line(PadAction::Explore).state, Off);
    EXPECT_FALSE(page.buttons()->accessibleDescription().contains("explore"));
    const QImage idle = gui::painted(page);
    state[PadButton::X] = true;
    state[PadButton::Y] = true;
    state[PadAxis::LeftX] = 0.5;
    state[PadAxis::RightTrigger] = 1.0;
    show();
    EXPECT_NE(gui::painted(page), idle);
    EXPECT_EQ(line(PadButton::X).state, On);
    EXPECT_EQ(line(PadButton::Y).text, "Y (upper)");
    EXPECT_EQ(line(PadButton::Y).state, On);
    EXPECT_EQ(page.buttons()->accessibleDescription(), "X (left) · explore; Y (upper)");
    const auto& axes = page.axes()->lines();
    EXPECT_EQ(axes.at(0).bar->value, 0.5);
    EXPECT_EQ(axes.at(1).bar->deadZone, PadSettings().deadZone);
    EXPECT_EQ(axes.at(5).text, "right trigger · dead-man");
    EXPECT_FALSE(axes.at(5).bar->fromMiddle);
    EXPECT_EQ(line(PadAction::Explore).text, "explore: X (left)");
    EXPECT_EQ(line(PadAction::Explore).state, On);
    EXPECT_EQ(line(PadAction::DeadMan).state, On);
    EXPECT_EQ(line(PadAction::Drive).state, Off);
    state[PadAxis::LeftY] = -1.0;
    show();
    EXPECT_EQ(line(PadAction::Drive).text, "drive: left stick, up and down · 0.20 m/s");
    EXPECT_EQ(line(PadAction::Drive).state, On);
}

TEST_F(GamepadSettings, hostileValuesAreDrawn)
{
    for (const double bad : gui::kHostile) {
        state.axes.fill(bad);
        show();
        EXPECT_FALSE(gui::painted(page).isNull()) << bad;
    }
}

TEST_F(GamepadSettings, saysThatAHeldControlMustBeReleased)
{
    state[PadButton::A] = true;
    show();
    EXPECT_EQ(line(PadAction::Approve).text,
              "approve the probe (hold): A (lower) · release it first");
    EXPECT_EQ(line(PadAction::Approve).state, PadLine::State::Waits);
}

TEST_F(GamepadSettings, learnsTheControlOfAnAction)
{
    show();
    learn(PadAction::Stop);
    EXPECT_TRUE(answer().contains("STOP")) << answer().toStdString();
    EXPECT_EQ(page.assignButton()->text(), "Cancel");
    move(PadButton::Guide);
    EXPECT_EQ(saved().mapping[PadAction::Stop], PadControl(PadButton::Guide));
    EXPECT_EQ(page.assignButton()->text(), "Assign");
    EXPECT_EQ(page.actionBox()->currentText(), "STOP: Guide");
    move(PadButton::Start);
    EXPECT_EQ(saved().mapping[PadAction::Stop], PadControl(PadButton::Guide)) << "it has ended";

    learn(PadAction::Drive);
    move(PadButton::Start);
    move(PadAxis::RightY, -0.9);
    EXPECT_EQ(saved().mapping[PadAction::Drive], PadControl(PadStick{PadAxis::RightY, -1}));

    learn(PadAction::FeelForward);
    move(PadAxis::RightTrigger);
    EXPECT_EQ(saved().mapping[PadAction::FeelForward], PadControl(PadAxis::RightTrigger));
    EXPECT_TRUE(answer().contains("Without a control now: dead-man control"))
        << answer().toStdString();
    EXPECT_TRUE(line(PadAction::DeadMan).text.endsWith(": no control"));
}

TEST_F(GamepadSettings, noOtherActionTakesAControlOfStop)
{
    show();
    learn(PadAction::Explore);
    move(PadButton::RightShoulder);
    EXPECT_EQ(saved(), PadSettings());
    EXPECT_TRUE(answer().contains("control of STOP")) << answer().toStdString();
}

TEST_F(GamepadSettings, anAssignmentEndsByCancelLossAndLeavingThePage)
{
    show();
    const auto nothingIsAssigned = [this] {
        move(PadButton::Y);
        return saved() == PadSettings();
    };
    learn(PadAction::Explore);
    page.assignButton()->click();
    EXPECT_TRUE(nothingIsAssigned());
    learn(PadAction::Explore);
    page.actionBox()->setCurrentIndex(static_cast<int>(PadAction::Refuse));
    EXPECT_TRUE(nothingIsAssigned());
    learn(PadAction::Explore);
    page.poll({});
    EXPECT_TRUE(answer().contains("not connected any more"));
    EXPECT_TRUE(nothingIsAssigned());
    learn(PadAction::Explore);
    page.hide();
    page.show();
    EXPECT_TRUE(nothingIsAssigned());
}

TEST_F(GamepadSettings, theBoxesChangeDeadZoneAndSpeed)
{
    page.deadZoneBox()->setValue(25);
    page.speedBox()->setValue(0.35);
    EXPECT_DOUBLE_EQ(saved().deadZone, 0.25);
    EXPECT_DOUBLE_EQ(saved().speedLimit, 0.35);
    EXPECT_EQ(page.speedBox()->maximum(), 0.6) << "the gate's limit";
    store.change([](Preferences& p) { p.pad.speedLimit = 0.1; });
    EXPECT_DOUBLE_EQ(page.speedBox()->value(), 0.1);
    EXPECT_DOUBLE_EQ(saved().deadZone, 0.25);
}

TEST_F(GamepadSettings, theDefaultsAreAskedForTwice)
{
    store.change([](Preferences& p) {
        p.pad.deadZone = 0.4;
        p.pad.mapping.assign(PadAction::Explore, PadButton::Y);
        p.fontScale = 120;
    });
    page.defaultsButton()->click();
    page.defaultsButton()->click();  // a double click
    EXPECT_NE(saved(), PadSettings());
    EXPECT_TRUE(page.defaultsButton()->text().contains("again"));
    EXPECT_TRUE(eventually([&] {
        page.defaultsButton()->click();
        return saved() == PadSettings();
    }));
    EXPECT_EQ(store.current().fontScale, 120);
}

TEST_F(GamepadSettings, everyControlHasANameAndTheKeyboard)
{
    show();
    for (const QWidget* widget : page.findChildren<QWidget*>()) {
        const bool isControl = qobject_cast<const QPushButton*>(widget)
                            || qobject_cast<const QDoubleSpinBox*>(widget)
                            || qobject_cast<const QComboBox*>(widget);
        if (!isControl) continue;
        const auto* button = qobject_cast<const QPushButton*>(widget);
        EXPECT_FALSE(widget->accessibleName().isEmpty() && (!button || button->text().isEmpty()));
        EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus);
        EXPECT_FALSE(widget->toolTip().isEmpty());
    }
}

}  // namespace
}  // namespace terratact
