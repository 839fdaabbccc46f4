// Tests the events of a review.
#include "app/review/review_events_page.h"

#include <gtest/gtest.h>

#include "app/pages/terrain_page.h"
#include "app/review/review_window.h"
#include "app/review/scenes_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST_F(ReviewOf, theEventsBesideTheRobotAreThoseOfTheTimeBefore)
{
    record();
    open();
    const EventList& list = *window->terrainPage()->events();
    const auto newestIsTheAlarm = [&] {
        return list.count() > 0 && list.item(0)->text().contains("frames are lost");
    };
    window->goTo(At::kAlarm + 0.1);
    const int before = list.count();
    EXPECT_TRUE(newestIsTheAlarm());
    window->goTo(At::kForgotten + 0.1);
    EXPECT_GT(list.count(), before);
    EXPECT_FALSE(newestIsTheAlarm());
    window->goTo(At::kAlarm + 0.1);
    EXPECT_EQ(list.count(), before);
    EXPECT_TRUE(newestIsTheAlarm());
}

}  // namespace
}  // namespace terratact
