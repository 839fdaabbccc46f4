// Tests two cursors in a session.
#include "app/review/review_difference.h"

#include <gtest/gtest.h>

#include "app/review/review_window.h"
#include "tests/support/gui.h"
#include "tests/support/review_bench.h"
#include "tests/support/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, twoCursorsLoopAndTellTheDifference)
{
    record();
    open();
    window->goTo(1.0);
    press(Qt::Key_A);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_TRUE(window->differenceLabel()->text().contains("+0.500"));
    press(Qt::Key_P);
    EXPECT_TRUE(window->player().loops());
    press(Qt::Key_L);
    for (int n = 0; n < 10; ++n) {
        window->poll(0.2);
        EXPECT_GE(now(), 1.0);
        EXPECT_LE(now(), 1.5);
    }
    press(Qt::Key_K);
    window->goTo(1.5);
    press(Qt::Key_B);
    EXPECT_FALSE(window->player().b());
}

}  // namespace
}  // namespace terratact
