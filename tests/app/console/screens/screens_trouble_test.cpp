// Pictures of STOP, of faults and of a receive-only console; see screens_test.cpp.
#include <QPushButton>
#include <QTimer>
#include <algorithm>

#include "app/console/connection/link_status.h"
#include "app/console/past/recording_display.h"
#include "app/console/shared_stop.h"
#include "app/console/stop_display.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/text/bus_text.h"
#include "app/mission/text/robot_text.h"
#include "app/pages/terrain_page.h"
#include "core/atem/following.h"
#include "core/wire/can_codec.h"
#include "tests/app/console/screens/screens.h"
#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/status_header.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {

using gui::eventually;

namespace {

bool alarmStands(MainWindow& console, std::string_view id)
{
    return std::ranges::any_of(console.alarms().list().alarms(),
                               [id](const Alarm& alarm) { return alarm.id == id; });
}

}  // namespace

TEST_F(Screens, stop)
{
    inEveryLanguage([&] {
        open({.staging = {.activity = RobotActivity::Halted}});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        press(Qt::Key_F12);
        picture("stop_not_confirmed",
                {StatusHeader::tr("STOP SENT …"),
                 StopDisplay::tr("STOP SENT, NOT CONFIRMED for %1: the robot may still move; STOP "
                                 "is sent again")});
        robot->stage({});
        picture("stopped", {StatusHeader::tr("STOPPED (F12)"), glance(RobotActivity::Stopped),
                            translated(describe(AtemPhase::Stopped))});
        holdAtHalf(*console->atemPanel()->releaseButton(), Qt::Key_R,
                   "hold_to_release_stop_at_half", {AtemPanel::tr("hold to release STOP (R)")});
        ASSERT_TRUE(reaches(AtemPhase::Idle));
        QTest::keyRelease(&window(), Qt::Key_R);
        bus.setState(BusState::BusOff, "can0");
        press(Qt::Key_F12);
        picture(
            "stop_not_sent",
            {StatusHeader::tr("STOP NOT SENT"),
             StopDisplay::tr("STOP NOT SENT for %1, trying again: use the robot's own switch — %2"),
             busStateText(BusState::BusOff, "can0")});
    });
}

TEST_F(Screens, trouble)
{
    const Staging mute{.isMute = true};
    inEveryLanguage([&] {
        open({.linkLostAfter = 0.8, .staging = mute});
        picture("no_telemetry_yet", {translated(TR_NOOP("core", "no telemetry yet"))});
        robot->stage({});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        robot->stage(mute);
        const QString lost = LinkStatus::tr("%1 for %2 — nothing on this screen is live%3");
        picture("link_lost", {translated(TR_NOOP("core", "link lost")), lost});
        press(Qt::Key_F4);
        picture("alarms_of_a_lost_link", {lost, translated(TR_NOOP("core", "link lost"))});
        press(Qt::Key_F2);
        bus.setState(BusState::BusOff, "can0");
        picture("bus_off", {lost, busStateText(BusState::BusOff, "can0")});

        open({.hasPanel = true});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        ASSERT_TRUE(eventually([&] { return board->lit(0); }));
        board->unplug();
        picture("panel_lost",
                {PanelControl::tr("the operator's panel does not answer"),
                 MainWindow::tr("PANEL LOST, STOP is asserted: connect the operator's panel, then "
                                "hold R; or start without --panel"),
                 StatusHeader::tr("STOPPED (F12)")});

        open({.sessions = "/proc/terratact"});
        picture("not_recorded",
                {RecordingDisplay::tr("NOT RECORDED: %1"),
                 QCoreApplication::translate("core", "%1: the directory cannot be made: %2"),
                 RecordingDisplay::tr("✕ NOT\nRECORDED")});
    });
}

TEST_F(Screens, lying)
{
    inEveryLanguage([&] {
        open({});
        ASSERT_TRUE(
            eventually([&] { return console->header()->arming()->armButton()->isEnabled(); }));
        ASSERT_TRUE(eventually(
            [&] { return !console->exploration().estimation().model().name.isEmpty(); }, 60000));
        robot->stage({.pitch = 0.65});
        const QString tips = ConsoleAlarms::tr("Danger of tipping over: %1");
        ASSERT_TRUE(eventually([&] { return alarmStands(*console, "attitude"); }));
        picture("attitude_alarm", {StatusHeader::tr("alarms: %1")});
        press(Qt::Key_F4);
        picture("attitude_alarm_in_the_list", {tips});
        press(Qt::Key_F2);

        open({.before = 0.8});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        robot->stage({.pitchStuckAt = 0.02});
        ASSERT_NO_FATAL_FAILURE(arm());
        QTest::keyPress(&window(), Qt::Key_W);
        (void)eventually([&] { return alarmStands(*console, "sensor-fault"); });
        QTest::keyRelease(&window(), Qt::Key_W);
        ASSERT_TRUE(alarmStands(*console, "sensor-fault")) << "it drove, and pitch did not change";
        ASSERT_NO_FATAL_FAILURE(exploreWithoutProbe());
        picture("stuck_imu", {StatusHeader::tr("alarms: %1"), VerdictStrip::tr("? CANNOT TELL")});
        press(Qt::Key_F4);
        picture("stuck_imu_in_the_list", {ConsoleAlarms::tr("Do not trust this sensor: %1")});
    });
}

TEST_F(Screens, doubtful_link)
{
    inEveryLanguage([&] {
        open({.linkLostAfter = 0.8});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        robot->stage({.isNumb = true});
        picture("telemetry_lost", {translated(TR_NOOP("core", "telemetry lost")),
                                   LinkStatus::tr("%1 for %2 — %3; no measured value is live%4")});
        robot->stage({});

        open({.linkLostAfter = 0.3});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        bool isNumb = false;
        QTimer comesAndGoes;
        QObject::connect(&comesAndGoes, &QTimer::timeout, [&] {
            isNumb = !isNumb;
            robot->stage({.isNumb = isNumb});
        });
        comesAndGoes.start(500);
        picture("telemetry_unsteady",
                {translated(TR_NOOP("core", "telemetry unsteady")),
                 LinkStatus::tr("%1 — gaps: %2, the longest %3; values read -- during a gap")});
        comesAndGoes.stop();

        open({});
        press(Qt::Key_1, Qt::ControlModifier);
        ASSERT_NO_FATAL_FAILURE(arm());
        QTest::keyPress(&window(), Qt::Key_W);
        robot->stage({.isDisarmed = true});
        ASSERT_TRUE(eventually([&] { return !console->exploration().armed(); }));
        QTest::keyRelease(&window(), Qt::Key_W);
        const QString disarmed = LinkStatus::tr("disarmed: %1");
        picture("disarmed_while_driving", {disarmed});
        press(Qt::Key_F3);
        picture("disarmed_while_driving_numbers", {disarmed});

        open({});
        ASSERT_TRUE(eventually([&] { return console->exploration().linkAlive(); }));
        press(Qt::Key_F4);
        bus.put(pack({.kind = FrameKind::ConsoleHeartbeat}));
        picture("another_console",
                {ConsoleAlarms::tr(
                    "Another console sends commands on this bus: find it and turn it off")});
        press(Qt::Key_F2);
        bus.setState(BusState::ErrorWarning, "can0");
        picture("bus_warning", {glance(BusState::ErrorWarning)});
        bus.setState(BusState::ErrorPassive, "can0");
        picture("bus_passive", {glance(BusState::ErrorPassive)});
        bus.setState(BusState::Up, "can0");
        bus.dropNext(40);
        picture("frames_dropped", {LinkStatus::tr("! %1 dropped")});
        robot->stage({.isUnfeeling = true});
        const QString alarm = ConsoleAlarms::tr("Force sensors not usable: %1");
        ASSERT_TRUE(eventually([&] { return alarmStands(*console, "sensors"); }));
        picture("force_sensors_unusable", {StatusHeader::tr("alarms: %1")});
        press(Qt::Key_F4);
        picture("alarms_of_force_sensors", {alarm});
    });
}

TEST_F(Screens, following)
{
    inEveryLanguage([&] {
        const auto follows = [](AtemPhase phase) { return translated(describeFollowed(phase)); };
        open({.before = 0.5,
              .isPressed = true,
              .mode = CanSource::Mode::Listen,
              .staging = {.activity = RobotActivity::Halted}});
        picture(
            "no_commands",
            {ArmingControl::tr("NO COMMANDS"), StatusHeader::tr("STOP: no commands"),
             Exploration::tr("No estimate yet: one is made when the robot presses its flippers")});
        robot->stage({.activity = RobotActivity::Pressing});
        picture("following_live_preview",
                {follows(AtemPhase::Pressing), TerrainPage::tr("LIVE preview")});
        robot->stage({});
        picture("following_estimate",
                {follows(AtemPhase::Presenting),
                 TerrainPage::tr("Following: probes are approved on the commanding console.")});
        press(Qt::Key_F12);
        picture("stop_has_no_effect", {SharedStop::tr("STOP HAS NO EFFECT HERE: %1")});

        open({.before = 0.5,
              .isPressed = true,
              .mode = CanSource::Mode::Replay,
              .busName = "REPLAY mission.log"});
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
        bus.setState(BusState::Ended, "REPLAY mission.log");
        robot->stage({.isMute = true});
        picture("end_of_the_log", {translated(TR_NOOP("core", "end of the log")),
                                   TerrainPage::tr("the log has ended")});
    });
}

}  // namespace terratact
