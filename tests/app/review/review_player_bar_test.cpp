// Tests keys and fields that play a session.
#include "app/review/review_player_bar.h"

#include <gtest/gtest.h>

#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, aSessionPlaysAndPausesByKeys)
{
    record();
    open();
    press(Qt::Key_Space);
    EXPECT_TRUE(window->player().playing());
    const double began = now();
    window->poll(0.2);
    EXPECT_NEAR(now() - began, 0.2, 0.15);  // its own timer may have ticked
    press(Qt::Key_Space);
    EXPECT_FALSE(window->player().playing());
    const double stood = now();
    window->poll(0.2);
    EXPECT_EQ(now(), stood);
    press(Qt::Key_F);
    press(Qt::Key_F);
    press(Qt::Key_H);
    EXPECT_EQ(window->player().speed(), 2.0);
    window->goTo(2.0);
    press(Qt::Key_J);
    EXPECT_TRUE(window->player().backwards());
    window->poll(0.1);
    EXPECT_LT(now(), 2.0);
    press(Qt::Key_K);
    EXPECT_FALSE(window->player().playing());
}

TEST_F(ReviewOf, aSessionIsSteppedThroughByKeys)
{
    record();
    open();
    window->goTo(1.02);
    press(Qt::Key_Period);
    EXPECT_NEAR(now(), 1.05, 0.011);
    const double frame = now();
    press(Qt::Key_Period);
    press(Qt::Key_Comma);
    EXPECT_EQ(now(), frame);
    press(Qt::Key_PageDown);
    EXPECT_NEAR(now(), At::kEstimate, 1e-6) << "what stands then is the estimate of the scene";
    press(Qt::Key_Down);
    EXPECT_NEAR(now(), At::kProposing, 1e-6);
    press(Qt::Key_Down);
    EXPECT_NEAR(now(), At::kMarker, 1e-6);
    press(Qt::Key_Up);
    EXPECT_NEAR(now(), At::kProposing, 1e-6);
    press(Qt::Key_6);
    EXPECT_NEAR(now(), At::kApproved, 1e-6);
    press(Qt::Key_7, Qt::AltModifier);
    EXPECT_NEAR(now(), At::kAlarm, 1e-6);
    press(Qt::Key_End);
    EXPECT_EQ(now(), window->player().end());
    press(Qt::Key_Home);
    EXPECT_EQ(now(), window->player().begin());
}

TEST_F(ReviewOf, aSessionGoesToATypedTime)
{
    record();
    open();
    press(Qt::Key_G);
    QTest::keyClicks(window->positionEdit(), "0:02.5");
    QTest::keyClick(window->positionEdit(), Qt::Key_Return);
    EXPECT_NEAR(now(), 2.5, 1e-6);
    press(Qt::Key_G);
    QTest::keyClicks(window->positionEdit(), "now");
    QTest::keyClick(window->positionEdit(), Qt::Key_Return);
    EXPECT_NEAR(now(), 2.5, 1e-6);
}

}  // namespace
}  // namespace terratact
