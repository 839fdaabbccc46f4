// Tests the page of alarms.
#include "app/console/pages/alarms_page.h"

#include <alsa/asoundlib.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <string>

#include "app/mission/console_alarms.h"
#include "tests/support/benches/pages_bench.h"
#include "tests/support/devices/counting_alarm_sound.h"
#include "tests/support/gui.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/alarm_table.h"
#include "widgets/signals/signal_table.h"

namespace terratact {
namespace {

TEST(AlarmsPageTest, theSoundTestPlaysEvenIfSoundIsOff)
{
    int sounds = 0;
    ConsoleAlarms alarms(std::make_unique<CountingAlarmSound>(sounds));
    alarms.setSoundOn(false);
    AlarmsPage page(alarms);
    page.table()->trySoundButton()->click();
    EXPECT_EQ(sounds, 1);
}

using gui::eventually;

TEST_F(Pages, lostLinkSoundsOnceOpensTheAlarmsAndIsAcknowledged)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    EXPECT_EQ(window->header()->alarmsButton()->text(), "no alarms");
    bus.setState(BusState::Down, "can0");
    ASSERT_TRUE(eventually([&] { return window->alarms().list().alarms().size() >= 2; }));
    EXPECT_TRUE(eventually([&] {
        return window->header()->alarmsButton()->text() == QString::fromUtf8("▲ alarms: 2");
    }));
    QTest::qWait(300);  // waits for an event that must not come
    EXPECT_EQ(sounds, 1) << "bus and link at once";
    QTest::mouseClick(window->header()->alarmsButton(), Qt::LeftButton);
    EXPECT_EQ(window->rail()->chosen(), window->rail()->pageOf(Qt::Key_F4));
    ASSERT_TRUE(
        eventually([&] { return window->alarmsPage()->table()->table()->rowCount() == 2; }));
    QTest::qWait(100);
    picture("alarms");
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    bus.setState(BusState::Up, "can0");
    ASSERT_TRUE(
        eventually([&] { return window->alarms().list().count(AlarmState::Returned) == 2; }));
    QTest::qWait(100);
    picture("alarms-returned");
    QTest::mouseClick(window->alarmsPage()->table()->acknowledgeAllButton(), Qt::LeftButton);
    EXPECT_TRUE(
        eventually([&] { return window->header()->alarmsButton()->text() == "no alarms"; }));
    EXPECT_EQ(sounds, 1) << "none on return";
    QTest::qWait(100);
    picture("alarms-none");
}

}  // namespace
}  // namespace terratact
