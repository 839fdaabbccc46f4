// Tests the console with a robot on a CAN bus, through real mouse and key events.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/console/main_window.h"
#include "app/shell/short_notice.h"
#include "core/wire/frame_layout.h"
#include "tests/support/absolem.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using gui::eventually;

TEST_F(BusConsole, showsForcesVoltagesAndADriftedBiasOfBothArrays)
{
    startQuickRobot();
    model.forceCalibration.biasLeft[1] += 0.5;  // the robot's own bias is smaller
    openOn(CanSource::Mode::Listen);
    const ForceBars& bars = *window->forces();
    ASSERT_TRUE(eventually([&] { return bars.arrays() == 2 && bars.numberText(0, 1) != "--"; }));
    EXPECT_EQ(bars.legend(), "■ L  □ R");
    EXPECT_TRUE(eventually([&] { return bars.driftText(1).startsWith("bias −0."); }))
        << bars.driftText(1).toStdString();
    EXPECT_TRUE(eventually([&] { return bars.driftText(2).isEmpty(); }))  // the first lines are few
        << bars.driftText(2).toStdString();
    EXPECT_TRUE(eventually([&] { return bars.numberText(1, 0) == "0.0"; }))
        << "less than nothing is not felt: " << bars.numberText(1, 0).toStdString();
    window->resize(1200, 680);
    picture("forces");
    EXPECT_TRUE(gui::cutText(*bars.parentWidget()).empty());
    window->forceUnitButton()->click();
    EXPECT_EQ(bars.unit(), ForceBars::Unit::Volts);
    picture("force-voltages");
    // The preload alone gives 0.3 N: 20 kΩ over 10 kΩ at 5 V.
    EXPECT_GE(bars.numberText(2, 0).toDouble(), 1.67);
    EXPECT_LT(bars.numberText(2, 0).toDouble(), 4.0);
    window->forceUnitButton()->click();
    EXPECT_EQ(bars.unit(), ForceBars::Unit::Newtons);
}

TEST_F(BusConsole, showsAsManyArraysAsTheRobotsFileHas)
{
    const std::string file = contentOf(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
    const auto table = [](const std::string& name, const std::string& side,
                          const std::string& elements) {
        return "\n[[force_array]]\nname = \"" + name + "\"\nside = \"" + side + "\"\nelements = ["
             + elements + "]\n";
    };
    const std::pair<std::string, QString> cases[]{
        {table("front", "left", "1, 2, 3, 4, 5, 6"), QStringLiteral("■ front")},
        {table("L", "left", "1, 2, 3") + table("L tip", "left", "4, 5, 6")
             + table("R", "right", "1, 2, 3") + table("R tip", "right", "4, 5, 6"),
         QStringLiteral("■ L  □ L tip  ▦ R  ▤ R tip")}};
    for (const auto& [tables, legend] : cases) {
        window.reset();
        robot.reset();
        model = *robotModelFrom("arrays.toml", file + tables);
        open();
        const ForceBars& bars = *window->forces();
        ASSERT_TRUE(eventually([&] {
            return bars.legend() == legend && bars.numberText(0) != "--";
        })) << bars.legend().toStdString();
        EXPECT_NE(bars.numberText(5, bars.arrays() - 1), "--");
        EXPECT_EQ(window->alarms().list().alarms().size(), 0U)
            << "no wire of a missing array is broken";
        window->resize(1200, 680);
        QTest::qWait(100);
        picture(QStringLiteral("arrays_%1").arg(bars.arrays()));
        EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    }
}

TEST_F(BusConsole, eachConfirmationNeedsTheHoldTimeOfTheManual)
{
    startQuickRobot();
    MainWindow::Options options = linked(bus.join("can0"), {.mode = CanSource::Mode::Transmit});
    options.model = [] { return Result<LoadedModel>(madeUp()); };
    const MainWindow asOpened(std::move(options));
    EXPECT_EQ(asOpened.header()->arming()->confirmButton()->holdTime(), 1000);
    EXPECT_EQ(asOpened.probeCard()->approveButton()->holdTime(), 1500);
    EXPECT_EQ(asOpened.atemPanel()->releaseButton()->holdTime(), 1500);
}

TEST_F(BusConsole, takesTwoActionsToArmAndNothingMovesBefore)
{
    open();
    EXPECT_EQ(window->header()->sourceName(), "can0");
    ASSERT_TRUE(eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
    picture("disarmed");
    EXPECT_TRUE(window->header()->arming()->armButton()->toolTip().contains(
        QStringLiteral("✔ commands can leave\n✔ no other console sends commands\n")))
        << window->header()->arming()->armButton()->toolTip().toStdString();
    EXPECT_TRUE(window->drivePad()->forwardButton()->toolTip().contains(
        QStringLiteral("✔ telemetry is live\n✘ not armed")));
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    QTest::qWait(400);  // waits for the robot's ten heartbeats
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(eventually([&] { return arming() == ArmingPhase::Confirming; }));
    QTest::keyClick(window.get(), Qt::Key_M);  // shorter than the hold time
    QTest::qWait(300);                         // waits for an event that must not come
    EXPECT_NE(arming(), ArmingPhase::Armed);
    ASSERT_TRUE(confirmsArming(*window));
    EXPECT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    picture("armed");
    QTest::qWait(60);
    QTest::keyClick(window.get(), Qt::Key_M);
    EXPECT_TRUE(eventually([&] { return arming() == ArmingPhase::Disarmed; }));
    EXPECT_TRUE(eventually([&] { return !window->drivePad()->forwardButton()->isEnabled(); }));
}

TEST_F(BusConsole, onceItIsArmedNoBannerSaysNotArmed)
{
    open();
    EXPECT_TRUE(gui::eventually([&] {
        QTest::keyClick(window.get(), Qt::Key_W);
        return says("not driven: not armed");
    }));
    arm();
    EXPECT_TRUE(gui::eventually([&] { return !says("not driven: not armed"); },
                                static_cast<int>(500.0 * ShortNotice::kFor)))
        << "long before it would end anyway";
}

TEST_F(BusConsole, canBeArmedAgainWhereSomethingDisarmedOnTheWay)
{
    open();
    EXPECT_FALSE(terratact::armsOnce(*window, [this] { window->link()->disarm(); }));
    EXPECT_TRUE(exploresUntilAsked());
    EXPECT_EQ(arming(), ArmingPhase::Armed);
}

TEST_F(BusConsole, autoRepeatOfAHeldKeyDoesNotArm)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
    QTest::qWait(600);
    QTest::keyPress(window.get(), Qt::Key_M);
    for (int i = 0; i < 40; ++i) {
        QTest::qWait(15);
        QTest::keyRelease(window.get(), Qt::Key_M);
        QTest::keyPress(window.get(), Qt::Key_M);
    }
    QTest::keyRelease(window.get(), Qt::Key_M);
    EXPECT_EQ(arming(), ArmingPhase::Confirming) << "one long press is one action";
}

TEST_F(BusConsole, driveExploreProbeAndDriveOn)
{
    open();
    ASSERT_TRUE(drives());
    const int epoch = window->link()->view().link.arming.epoch;  // changes with every arming
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
    ASSERT_TRUE(exploresAndProbes());
    EXPECT_TRUE(window->exploration().state().probed);
    picture("presenting");
    ASSERT_TRUE(drives());
    EXPECT_EQ(window->link()->view().link.arming.epoch, epoch) << "it stays armed all the while";
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(BusConsole, coloursAndFontChangeOnceTheRobotStands)
{
    open();
    const auto change = [this](ThemeName theme, int scale) {
        window->preferences().change([=](Preferences& p) {
            p.theme = theme;
            p.fontScale = scale;
        });
    };
    change(ThemeName::Day, 100);
    ASSERT_TRUE(drives());
    change(ThemeName::NightRed, 120);
    QTest::qWait(100);  // waits for a change that must not come
    EXPECT_TRUE(window->link()->view().link.moves);
    EXPECT_EQ(lookInForce().theme, ThemeName::Day);
    const QSize size = window->terrain()->size();
    window->preferences().change([](Preferences& p) { p.layout = Layout::Drive; });
    EXPECT_TRUE(eventually([&] { return window->terrain()->size() != size; }, 2000))
        << "the layout does not wait";
    window->preferences().change([](Preferences& p) { p.layout = Layout::Probe; });
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(eventually([&] { return lookInForce().theme == ThemeName::NightRed; }));
    EXPECT_TRUE(eventually([&] { return lookInForce().fontScale == 120; }));
    change(ThemeName::Day, 100);
}

TEST_F(BusConsole, closingWhileArmedNeedsASecondRequest)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    window->close();
    EXPECT_FALSE(window->isVisible()) << "of a disarmed one at once";
    window->show();
    ASSERT_TRUE(armsOnce());
    window->close();
    ASSERT_TRUE(window->isVisible());
    for (int repeated = 0; repeated < 10; ++repeated) {  // key repeat of one second
        QTest::qWait(100);
        window->close();
    }
    EXPECT_TRUE(window->isVisible())
        << "neither a double click nor a key that repeats is an answer";
    EXPECT_TRUE(eventually([&] { return says("THE ROBOT IS ARMED: close the window again"); }));
    picture("closing-armed");
    QTest::qWait(800);
    EXPECT_EQ(arming(), ArmingPhase::Armed);
    window->close();
    EXPECT_FALSE(window->isVisible());
    EXPECT_TRUE(eventually([&] { return arming() != ArmingPhase::Armed; }));
}

TEST_F(BusConsole, anOldCloseRequestIsForgotten)
{
    open();
    ASSERT_TRUE(armsOnce());
    window->close();
    QTest::qWait(static_cast<int>(1000.0 * ShortNotice::kFor) + 200);
    EXPECT_EQ(arming(), ArmingPhase::Armed);
    window->close();
    EXPECT_TRUE(window->isVisible()) << "that was the first try";
}

TEST_F(BusConsole, aSignalClosesTheWindowOfAnArmedRobotAtOnce)
{
    open();
    ASSERT_TRUE(armsOnce());
    window->closeUnasked();
    EXPECT_FALSE(window->isVisible());
    EXPECT_TRUE(eventually([&] { return arming() != ArmingPhase::Armed; }));
}

TEST_F(BusConsole, aWindowDestroyedWithoutClosingDisarmsTheRobot)
{
    const auto recorder = bus.join("recorder", 0);
    open();
    ASSERT_TRUE(armsOnce());
    (void)framesOf(*recorder);
    window.reset();
    const std::vector<BusFrame> heard = framesOf(*recorder);
    EXPECT_TRUE(std::ranges::any_of(heard, [](const BusFrame& one) {
        return kindOfId(one.frame.id) == FrameKind::Arm;
    })) << "as after a failure that ends the program";
}

TEST_F(BusConsole, showsWhyAProbeWasRefusedInEveryLayout)
{
    open(CanSource::Mode::Transmit, RobotFault::RefuseProbe);
    window->preferences().change([](Preferences& p) { p.layout = Layout::Drive; });
    ASSERT_TRUE(exploresUntilAsked());
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    const QString why = "the robot refused the probe: the arm does not reach that bin";
    EXPECT_TRUE(eventually([&] { return says("Exploration failed: " + why); }));
    EXPECT_FALSE(window->events()->isVisible());
    EXPECT_FALSE(says("exploration failed: " + why)) << "a banner would only move the page";
    EXPECT_TRUE(window->events()->item(0)->text().endsWith("exploration failed: " + why))
        << window->events()->item(0)->text().toStdString();
    EXPECT_TRUE(eventually([&] { return gui::cramped(*window).empty(); })) << "all can be read";
    picture("refused");
}

TEST_F(BusConsole, disarmedRobotEndsTheExploration)
{
    open();
    ASSERT_TRUE(exploresUntilAsked());
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(window->exploration().state().failure, AtemFailure::Disarmed);
    EXPECT_EQ(window->exploration().stateText().english(),
              "the robot is not armed: disarmed by the operator");
    picture("disarmed-while-exploring");
}

TEST_F(BusConsole, noTextIsCutAtTheSmallestSize)
{
    open();
    window->resize(window->minimumSize());
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(window->exploration().state().failure).english;
    QTest::qWait(100);
    EXPECT_EQ(window->size(), window->minimumSize()) << "the layout needs more than this";
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    picture("smallest");
}

}  // namespace
}  // namespace terratact
