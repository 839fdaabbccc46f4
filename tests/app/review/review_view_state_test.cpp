// Tests what a review shows at a time.
#include "app/review/review_view_state.h"

#include <gtest/gtest.h>

#include "app/display/format.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, anotherLimitIsThatOfEveryTimeFromThenOn)
{
    record();
    open();
    window->goTo(At::kMarker);
    const VerdictStrip& verdict = *window->terrainPage()->verdict();
    const double other = verdict.limit() + VerdictStrip::kLimitStep;
    QTest::mouseClick(verdict.raiseButton(), Qt::LeftButton);
    EXPECT_NEAR(verdict.limit(), other, 1e-9);
    window->goTo(At::kAgain + 0.1);
    EXPECT_NEAR(verdict.limit(), other, 1e-9);
    EXPECT_TRUE(verdict.question().contains(format::number(other, 2)))
        << verdict.question().toStdString();
}

}  // namespace
}  // namespace terratact
