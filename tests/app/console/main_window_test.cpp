// Tests the console through real mouse and key events, commands and painted pictures.
#include "app/console/main_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QPushButton>
#include <optional>

#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "widgets/base/held_button.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/robot_readout.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, noButtonHasTheFocusAtFirst)
{
    open(fastRobot(robot, 2.1));
    EXPECT_EQ(QApplication::focusWidget(), window.get());
}

TEST_F(Console, theSourcesNameAndStopAreThereFromTheFirstPicture)
{
    open(fastRobot(robot, 2.1));
    EXPECT_EQ(window->header()->sourceName(), "SIMULATED ROBOT");
    EXPECT_TRUE(window->header()->stopButton()->isVisible());
    EXPECT_TRUE(window->header()->stopButton()->text().contains("F12"));
}

TEST_F(Console, theWholeLoopByKeyboard)
{
    open(fastRobot(robot, 2.0));
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));

    proposeByKeyboard();
    EXPECT_EQ(window->probeCard()->approveButton()->text(),
              "hold to approve probe at 0.6 m (Space)");
    EXPECT_TRUE(window->strip()->headline().startsWith("Uncertain at 0.6 m"));
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(robotIs(RobotActivity::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_EQ(window->exploration().estimation().estimate()->side[0].origin[9], Origin::Arm);
    ASSERT_TRUE(eventually([&] { return window->terrain()->binText(9).endsWith("arm"); }));

    QTest::keyPress(window.get(), Qt::Key_Up);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_Up);
    ASSERT_TRUE(eventually(
        [&] { return window->terrain()->accessibleDescription().contains("has moved"); }));
}

TEST_F(Console, theWholeLoopByMouse)
{
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    QTest::mousePress(window->drivePad()->backButton(), Qt::LeftButton);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::mouseRelease(window->drivePad()->backButton(), Qt::LeftButton);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
    QTest::mouseClick(window->atemPanel()->requestButton(), Qt::LeftButton);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
    QTest::mousePress(window->probeCard()->approveButton(), Qt::LeftButton);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
}

TEST_F(Console, aSecondMethodIsEstimatedBesideTheFirst)
{
    open(fastRobot(robot, 2.1));
    window->exploration().setSecondMethod(Method::Pafc);
    proposeByKeyboard();
    ASSERT_TRUE(
        eventually([&] { return window->exploration().estimation().second().has_value(); }));
    EXPECT_EQ(window->exploration().estimation().second()->side[0].settings.method, Method::Pafc);
    EXPECT_EQ(window->exploration().estimation().estimate()->side[0].settings.method,
              Method::Local);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    window->exploration().setSecondMethod(std::nullopt);
    EXPECT_FALSE(window->exploration().estimation().second());
}

TEST_F(Console, theQualityMenuShowsCostsAndSetsThePreset)
{
    openScripted();
    const QString fast =
        QStringLiteral("fast: 0.5 ms, exact quantiles by a formula, mean error 25 mm");
    const auto offered = [&] { return window->header()->qualityButton()->menu()->actions(); };
    ASSERT_TRUE(eventually([&] { return offered()[0]->text() == fast; }))
        << offered()[0]->text().toStdString();
    const auto actions = offered();
    ASSERT_EQ(actions.size(), 3);
    EXPECT_EQ(actions[1]->text(), QStringLiteral("balanced: not measured (terratact tradeoff)"));
    actions[0]->trigger();
    EXPECT_EQ(window->header()->qualityButton()->text(), QStringLiteral("fast"));
    const Settings& settings = window->exploration().options().settings;
    EXPECT_EQ(settings, withPreset(settings, QualityPreset::Fast));
    EXPECT_NE(settings, withPreset(settings, QualityPreset::Balanced));
    window->preferences().change([](Preferences& p) { p.method = Method::Pafac; });
    EXPECT_EQ(offered()[0]->text(),
              QStringLiteral(
                  "fast: 4.0 ms, quantiles ± 11.3 mm from a long run, mean error 34 mm; chains "
                  "converge in 13 % of scenes, and only these have a verdict"));
}

TEST_F(Console, escapeAbortsAnExploration)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(reaches(AtemPhase::Idle));
    EXPECT_TRUE(eventually([&] { return !window->probeCard()->asks(); }));
}

TEST_F(Console, errorsAreShownWhenTheEventListIsHidden)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(readyToExplore());
    source->setDeaf(true);
    window->exploration().drive(+1);
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_FALSE(says("command not sent")) << "it stands in the list";
    QTest::keyClick(window.get(), Qt::Key_F3);
    window->exploration().drive(+1);
    EXPECT_TRUE(eventually([&] { return says("command not sent: the bus is off"); }));
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_TRUE(eventually([&] { return says("STOP NOT SENT for"); }));
    EXPECT_FALSE(says("command not sent")) << "it gives way";
    source->setDeaf(false);
    ASSERT_TRUE(eventually([&] { return !says("STOP NOT SENT"); }));
    window->events()->add("a doubt of anybody's", EventSeverity::Warning, {});
    window->events()->add("what anybody says is bad", EventSeverity::Bad, {});
    EXPECT_TRUE(eventually([&] { return says("what anybody says is bad"); }));
    EXPECT_FALSE(says("a doubt of anybody's"));
}

TEST_F(Console, deleteClearsTheEstimateAfterStop)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(robotIs(RobotActivity::Stopped));
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    QTest::keyPress(window.get(), Qt::Key_R);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
    ASSERT_TRUE(window->exploration().estimation().estimate());
    QTest::keyClick(window.get(), Qt::Key_Escape);
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_TRUE(window->exploration().estimation().estimate()) << "nothing runs that Esc could end";
    QTest::keyClick(window.get(), Qt::Key_Delete);
    EXPECT_TRUE(eventually([&] { return !window->exploration().estimation().estimate(); }));
}

TEST_F(Console, deleteActsWhileTheExploreButtonIsHidden)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    ASSERT_TRUE(eventually([&] { return !window->atemPanel()->requestButton()->isVisible(); }));
    const Estimation& estimation = window->exploration().estimation();
    ASSERT_TRUE(estimation.estimate());
    QTest::keyClick(window.get(), Qt::Key_Delete);
    EXPECT_TRUE(eventually([&] { return !estimation.estimate(); }));
    QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(eventually([&] { return estimation.estimate().has_value(); }));
}

TEST_F(Console, staleValuesDisappearAndTheLostLinkIsShown)
{
    ScriptedSource* source = openScripted();
    ASSERT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
    source->setSilent(true);
    ASSERT_TRUE(eventually(
        [&] { return window->readout()->text(RobotReadout::Pitch).startsWith("--   "); }));
    EXPECT_EQ(window->forces()->numberText(0), "--");
    EXPECT_TRUE(window->terrain()->accessibleDescription().contains("not live"));
    ASSERT_TRUE(eventually([&] { return window->header()->linkText().startsWith("LINK LOST"); }));
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    source->setSilent(false);
    EXPECT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
    EXPECT_TRUE(eventually([&] { return window->header()->linkText().startsWith("link"); }));
    EXPECT_FALSE(window->terrain()->accessibleDescription().contains("not live"));
}

TEST_F(Console, aMissingModelIsReportedAndTheRestWorks)
{
    open(fastRobot(robot, 2.1), modelFileLoader("/nowhere/none.ttm", robot));
    ASSERT_TRUE(eventually([&] { return !window->modelTrouble().isEmpty(); }));
    ASSERT_TRUE(eventually(
        [&] { return window->atemPanel()->requestButton()->toolTip().contains("none.ttm"); }));
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    EXPECT_TRUE(window->drivePad()->forwardButton()->isEnabled());
}

TEST_F(Console, hostileTelemetryLeavesItDrawnAndAlive)
{
    ScriptedSource* source = openScripted();
    for (const double bad : gui::kHostile) {
        Measurement m;
        m.pitch = m.roll = m.frontLeft = m.frontLeftCurrent = bad;
        m.force.fill(bad);
        source->setMeasurement(m);
        const auto before = window->acquisition().latest();
        ASSERT_TRUE(eventually([&] {
            const auto latest = window->acquisition().latest();
            return latest && (!before || latest->count > before->count + 30);
        }));
        QTest::qWait(100);
        ASSERT_FALSE(gui::painted(*window).isNull()) << bad;
    }
    source->setMeasurement({});
    EXPECT_TRUE(
        eventually([&] { return window->readout()->text(RobotReadout::Pitch).endsWith("°"); }));
}

}  // namespace
}  // namespace terratact
