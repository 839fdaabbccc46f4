// Tests what the header and the banner show of link, bus and arming.
#include "app/console/connection/link_status.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <string>
#include <vector>

#include "app/console/main_window.h"
#include "app/console/pages/signals_page.h"
#include "app/display/translated.h"
#include "app/recording/session_folder.h"
#include "core/log/session_reader.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/benches/staged_robot.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(BusConsole, lostLinkNamesItsRemedy)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    bus.setState(BusState::Down, "can0");
    EXPECT_TRUE(eventually([&] {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains("ip link set can0 up")) return true;
        return false;
    }));
    picture("bus-down");
}

TEST_F(BusConsole, missingTelemetryWithOtherFramesIsNoLostLink)
{
    StagedRobot numb = stagedRobot();
    const TemporaryDirectory folder;
    openRecordedOn(folder);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    numb.stage({.isNumb = true});
    EXPECT_TRUE(eventually([&] {
        return says("TELEMETRY LOST for") && says("frames still come, heartbeat")
            && says("no measured value is live");
    }));
    EXPECT_FALSE(says("nothing on this screen is live"));
    picture("telemetry-stopped");
    EXPECT_TRUE(window->header()->linkText().startsWith("TELEMETRY LOST"));
    const auto alarm = [&] {
        for (const Alarm& one : window->alarms().list().alarms())
            if (one.id == "link") return translated(one.text);
        return QString();
    };
    EXPECT_TRUE(alarm().startsWith("Telemetry lost")) << alarm().toStdString();
    const auto event = [&](const char* text) {
        return window->events()->findItems(text, Qt::MatchContains).size();
    };
    EXPECT_EQ(event("telemetry lost"), 1);
    EXPECT_EQ(event("link lost"), 0);
    for (const QString& text : gui::readableTexts(*window))
        EXPECT_FALSE(text.contains("link lost", Qt::CaseInsensitive)) << text.toStdString();

    numb.stage({.isMute = true});
    EXPECT_TRUE(eventually([&] { return says("nothing on this screen is live"); }));
    EXPECT_FALSE(says("frames still come"));
    EXPECT_TRUE(window->header()->linkText().startsWith("LINK LOST"));
    EXPECT_TRUE(alarm().startsWith("Link lost")) << alarm().toStdString();
    EXPECT_EQ(event("link lost"), 1) << "now it is";
    window.reset();
    recording.reset();
    auto session = SessionReader::open(sessionsIn(folder.file("sessions")).front());
    ASSERT_TRUE(session) << session.error().text;
    std::vector<std::string> recorded;
    for (const EventRow& row : session->events())
        if (row.kind == EventKind::Link) recorded.push_back(row.subject);
    EXPECT_EQ(recorded, (std::vector<std::string>{"up", "telemetry lost", "lost"}));
}

TEST_F(BusConsole, disarmingWhileDrivingIsShownOnEveryPage)
{
    StagedRobot moody = stagedRobot();
    openOn();
    const auto alarm = [&] {
        for (const Alarm& one : window->alarms().list().alarms())
            if (one.id == "disarmed") return std::optional(one);
        return std::optional<Alarm>();
    };
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);  // selects the drive layout
    ASSERT_TRUE(drives());
    ASSERT_FALSE(window->events()->isVisible()) << "nobody sees the last minutes";
    window->alarms().acknowledgeAll();
    moody.stage({.isDisarmed = true});
    EXPECT_TRUE(eventually([&] { return says("disarmed: the robot has disarmed"); }));
    ASSERT_TRUE(eventually([&] { return alarm().has_value(); }));
    EXPECT_EQ(alarm()->text.english(), "Disarmed: the robot has disarmed");
    EXPECT_EQ(alarm()->severity, Severity::Critical) << "it sounds";
    picture("disarmed-while-driving");
    QTest::keyRelease(window.get(), Qt::Key_W);
    QTest::keyClick(window.get(), Qt::Key_F3);
    EXPECT_TRUE(says("disarmed: the robot has disarmed"));
    window.reset();
}

TEST_F(BusConsole, showsTheBusStateInTheHeader)
{
    startQuickRobot();
    openOn(CanSource::Mode::Listen);
    const QPushButton& chip = *window->header()->busButton();
    ASSERT_TRUE(eventually([&] { return chip.text().startsWith("can0 ACTIVE"); }));
    EXPECT_TRUE(chip.isVisible());
    EXPECT_TRUE(eventually([&] { return chip.accessibleDescription().contains("frames/s"); }));
    EXPECT_TRUE(chip.accessibleDescription().contains("0 error frames"))
        << chip.accessibleDescription().toStdString();
    QTest::keyClick(window.get(), Qt::Key_F2);
    window->header()->busButton()->setFocus(Qt::TabFocusReason);
    QTest::keyClick(window->header()->busButton(), Qt::Key_Space);
    EXPECT_TRUE(eventually([&] { return window->signalsPage()->isVisible(); }));
    // The robot's values are as old as the frames that carried them.
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually(
        [&] { return window->readout()->ageText(RobotReadout::Pitch).endsWith(" ms"); }));
    EXPECT_TRUE(eventually([&] {
        for (const QLabel* label : window->forces()->parentWidget()->findChildren<QLabel*>())
            if (label->toolTip().startsWith("the forces are")) return true;
        return false;
    })) << "and so are the forces";
    picture("bus-chip");
}

}  // namespace
}  // namespace terratact
