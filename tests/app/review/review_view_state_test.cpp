// Tests what a review shows at a time.
#include "app/review/review_view_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/display/format.h"
#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

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

/// Ground before a break, in a session that is longer than what a review reads at once.
TEST_F(ReviewOf, groundOfALongSessionIsReadMeanwhile)
{
    constexpr double kLong = ReviewStrip::kMinLength + ReviewStrip::kStep + 10.0;
    auto writer = robotSession(path.toStdString(), 4.0);
    ASSERT_TRUE(writer) << writer.error().text;
    const auto event = [](double time, EventKind kind) {
        return EventRow{.id = 100 + std::lround(time), .time = sessionTimeOf(time), .kind = kind};
    };
    ASSERT_TRUE(writer->add(event(At::kForgotten, EventKind::TelemetryGap)));
    ASSERT_TRUE(writer->add(event(kLong, EventKind::Marker)));
    ASSERT_TRUE(writer->seal());
    open();
    window->goTo(kLong);
    const auto& picture = *window->terrainPage()->terrain();
    EXPECT_TRUE(eventually([&] {
        return picture.accessibleDescription().contains("earlier sections of ground behind it: 1");
    })) << picture.accessibleDescription().toStdString();
}

}  // namespace
}  // namespace terratact
