#include "widgets/base/held_button.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QVBoxLayout>

#include "tests/support/gui.h"
#include "widgets/control/drive_pad.h"

namespace terratact {
namespace {

constexpr int kHold = 120;  // [ms]

struct Hold : testing::Test {
    Hold()
    {
        auto* column = new QVBoxLayout(&window);
        button = new HoldToConfirmButton("hold to approve", &Theme::decide);
        other = new QPushButton("other");
        column->addWidget(button);
        column->addWidget(other);
        window.resize(300, 160);
        button->setHoldTime(kHold);
        gui::showActive(window);
        QObject::connect(button, &HoldToConfirmButton::confirmed, [this] { ++confirmed; });
    }
    bool waitForLetGo()
    {
        return gui::eventually([this] { return !button->isHeld(); });
    }
    QWidget window;
    HoldToConfirmButton* button = nullptr;
    QPushButton* other = nullptr;
    int confirmed = 0;
};

TEST_F(Hold, meansYesAfterItsTimeAndOnlyOnce)
{
    QElapsedTimer timer;
    timer.start();
    QTest::mousePress(button, Qt::LeftButton);
    EXPECT_TRUE(button->isHeld());
    ASSERT_TRUE(gui::eventually([this] { return confirmed > 0; }));
    EXPECT_GE(timer.elapsed(), kHold - 20);
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_EQ(confirmed, 1);
    EXPECT_FALSE(button->isHeld());
}

TEST_F(Hold, aClickMeansNothing)
{
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(button->isHeld());
    EXPECT_EQ(button->share(), 0.0);
    EXPECT_EQ(confirmed, 0);
}

TEST_F(Hold, showsHowFarItIs)
{
    button->setHoldTime(2000);
    const QImage before = gui::painted(*button);
    QTest::mousePress(button, Qt::LeftButton);
    ASSERT_TRUE(gui::eventually([this] { return button->share() > 0.1; }));
    EXPECT_NE(gui::painted(*button), before);
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_EQ(confirmed, 0);
}

TEST_F(Hold, aRingClosesAroundIt)
{
    button->setHoldTime(3000);
    const auto isLit = [this](bool right) {
        const QImage picture = gui::painted(*button);
        const double ratio = picture.devicePixelRatio();
        const int x = static_cast<int>(ratio * (right ? button->width() - 3 : 2));
        return picture.pixelColor(x, picture.height() / 2) == theme().decide.text;
    };
    EXPECT_FALSE(isLit(true));
    QTest::mousePress(button, Qt::LeftButton);
    ASSERT_TRUE(gui::eventually([this] { return button->share() > 0.55; }));
    EXPECT_TRUE(isLit(true)) << "down on the right";
    EXPECT_FALSE(isLit(false)) << "not yet up on the left";
    ASSERT_TRUE(gui::eventually([this] { return button->share() > 0.9; }));
    EXPECT_TRUE(isLit(false));
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_FALSE(isLit(true));
}

TEST_F(Hold, leavingWithTheMouseReleasesIt)
{
    button->setHoldTime(100000);
    QTest::mousePress(button, Qt::LeftButton);
    QMouseEvent away(QEvent::MouseMove, QPointF(-20, -20), button->mapToGlobal(QPointF(-20, -20)),
                     Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(button, &away);
    EXPECT_FALSE(button->isHeld());
}

TEST_F(Hold, theSpaceKeyHoldsItWhenItHasTheFocus)
{
    button->setFocus();
    QTest::keyPress(button, Qt::Key_Space);
    ASSERT_TRUE(gui::eventually([this] { return confirmed == 1; }));
    QTest::keyRelease(button, Qt::Key_Space);
    QTest::keyPress(button, Qt::Key_Space);
    QTest::keyRelease(button, Qt::Key_Space);
    ASSERT_TRUE(waitForLetGo());
    EXPECT_EQ(confirmed, 1) << "let go early";
}

TEST_F(Hold, aKeyThatRepeatsAsReleaseAndPressIsStillHeld)
{
    int begun = 0;
    QObject::connect(button, &HeldButton::holdBegan, [&begun] { ++begun; });
    button->setFocus();
    QTest::keyPress(button, Qt::Key_Space);
    ASSERT_TRUE(gui::eventually([this] {
        QTest::keyRelease(button, Qt::Key_Space);
        QTest::keyPress(button, Qt::Key_Space);
        return confirmed == 1;
    }));
    EXPECT_LE(begun, 2) << "one for the hold, one for the key that is still down after it";
}

TEST_F(Hold, losingTheFocusReleasesIt)
{
    button->setHoldTime(100000);
    button->setFocus();
    QTest::keyPress(button, Qt::Key_Space);
    ASSERT_TRUE(button->isHeld());
    other->setFocus();
    EXPECT_FALSE(button->isHeld());
}

TEST_F(Hold, hidingOrDisablingReleasesIt)
{
    button->setHoldTime(100000);
    button->hold();
    button->setEnabled(false);
    EXPECT_FALSE(button->isHeld());
    button->setEnabled(true);
    button->hold();
    button->hide();
    EXPECT_FALSE(button->isHeld());
    button->hold();
    EXPECT_FALSE(button->isHeld()) << "what is hidden cannot be held";
}

TEST_F(Hold, anotherActiveWindowReleasesIt)
{
    button->setHoldTime(100000);
    other->setFocus();  // so that not the lost focus releases the button
    button->hold();
    ASSERT_TRUE(button->isHeld());
    QWidget dialog;
    gui::showActive(dialog);
    EXPECT_TRUE(waitForLetGo());
}

TEST_F(Hold, aFrozenWindowHoldsNothing)
{
    button->setHoldTime(400);
    QTest::mousePress(button, Qt::LeftButton);
    QThread::msleep(600);           // the window's thread is frozen while the operator releases
    QApplication::processEvents();  // the timer fires before the queued release
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_EQ(confirmed, 0);
}

TEST(DrivePadTest, drivesWhileHeldAndHaltsOnRelease)
{
    DrivePad pad;
    gui::showActive(pad);
    QList<int> said;
    QObject::connect(&pad, &DrivePad::driveRequested,
                     [&said](int direction) { said << direction; });
    QObject::connect(&pad, &DrivePad::haltRequested, [&said] { said << 0; });
    QTest::mousePress(pad.forwardButton(), Qt::LeftButton);
    EXPECT_EQ(said, (QList<int>{1}));
    QTest::mouseRelease(pad.forwardButton(), Qt::LeftButton);
    QTest::mousePress(pad.backButton(), Qt::LeftButton);
    EXPECT_EQ(said, (QList<int>{1, 0, -1}));
    pad.setPreconditions({{Precondition::Level::Met, Message::verbatim("telemetry is live")},
                          {Precondition::Level::Missing, Message::verbatim("STOP is latched")}});
    EXPECT_EQ(said, (QList<int>{1, 0, -1, 0})) << "blocked while held is let go";
    EXPECT_TRUE(pad.forwardButton()->toolTip().endsWith("✔ telemetry is live\n✘ STOP is latched"));
    QTest::mousePress(pad.forwardButton(), Qt::LeftButton);
    EXPECT_EQ(said.size(), 4);
}

}  // namespace
}  // namespace terratact
