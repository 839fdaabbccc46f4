// Tests the console with an operator's panel.
#include <gtest/gtest.h>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/console/main_window.h"
#include "app/link/robot_in_process.h"
#include "app/runtime/steady_now.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/devices/panel_board.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/sim_source.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"

namespace terratact {
namespace {

using gui::eventually;

struct PanelConsole : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    MainWindow::Options options()
    {
        MainWindow::Options o;
        o.robot = model;
        o.model = [] {
            return Result<LoadedModel>(LoadedModel{
                .estimate =
                    [](const EstimateRequest& request, const Watch&) {
                        TerrainEstimate e = request.arm.empty() ? stepEstimate() : probedEstimate();
                        e.settings = request.settings;
                        return equalSides(e);
                    },
                .name = "fake.ttm",
                .details = {}});
        };
        o.panel = std::make_unique<OperatorPanel>(
            PanelConfig{}, [this](const GpioRequest&) { return board.open(); });
        return o;
    }
    void openSimulated()
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.1;
        MainWindow::Options o = options();
        o.source =
            std::make_unique<SimSource>(SimulatedRobot(model, demoTerrain(), simulation), 20.0);
        o.exploration.linkLostAfter = 3.0;
        show(std::move(o));
    }
    void show(MainWindow::Options o)
    {
        window = std::make_unique<MainWindow>(std::move(o));
        window->atemPanel()->releaseButton()->setHoldTime(150);
        window->resize(1280, 720);
        gui::showActive(*window);
    }
    void push(PanelContact button)
    {
        board.close(button, true);
        QTest::qWait(100);
        board.close(button, false);
    }
    bool reaches(AtemPhase phase)
    {
        return eventually([&] { return window->exploration().state().phase == phase; });
    }
    bool says(const QString& words) const
    {
        const QStringList texts = gui::readableTexts(*window);
        return std::ranges::any_of(texts, [&](const QString& t) { return t.contains(words); });
    }
    void propose()
    {
        ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
        push(PanelContact::Atem);
        ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
        ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
        QTest::qWait(50);  // operators are slower
    }

    RobotModel model = absolem();
    PanelBoard board;
    std::unique_ptr<MainWindow> window;
};

TEST_F(PanelConsole, exploresAndProbesByThePanelAlone)
{
    openSimulated();
    propose();
    board.close(PanelContact::Approve, true);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    board.close(PanelContact::Approve, false);
    EXPECT_TRUE(window->exploration().state().probed);
}

TEST_F(PanelConsole, approvalNeedsTheHoldWhileTheProposalIsVisible)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    push(PanelContact::Atem);
    board.close(PanelContact::Approve, true);  // pressed before the proposal
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    QTest::qWait(2000);  // longer than the hold; the approval must not come
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe)
        << "nobody had seen the question";
    board.close(PanelContact::Approve, false);
    QTest::qWait(100);
    push(PanelContact::Approve);
    QTest::qWait(100);  // longer than contact bounce, which would hide the press
    EXPECT_TRUE(
        eventually([&] { return window->events()->item(0)->text().contains("held for 1.5 s"); }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe) << "too short";

    window->rail()->choose(window->rail()->pageOf(Qt::Key_F7));
    board.close(PanelContact::Approve, true);
    EXPECT_TRUE(eventually([&] {
        return window->events()->item(0)->text().contains("not on the screen");
    })) << window->events()->item(0)->text().toStdString();
    QTest::qWait(2000);  // longer than the hold; the approval must not come
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe)
        << "another page is seen";
    window->rail()->choose(0);
    QTest::qWait(2000);  // longer than the hold; the approval must not come
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe) << "pressed before";
    board.close(PanelContact::Approve, false);
    QTest::qWait(100);
    board.close(PanelContact::Approve, true);
    EXPECT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
}

TEST_F(PanelConsole, refusesByThePanel)
{
    openSimulated();
    propose();
    push(PanelContact::Refuse);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(PanelConsole, lampsShowLinkArmingAndProbing)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return board.lit(0); })) << "link";
    EXPECT_TRUE(eventually([&] { return !board.lit(3); })) << "the buzzer's test has an end";
    propose();
    EXPECT_TRUE(eventually([&] { return board.lit(2) && board.lit(3); })) << "probing, and asked";
    EXPECT_TRUE(eventually([&] { return !board.lit(3); })) << "one sound";
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    push(PanelContact::Refuse);
    EXPECT_TRUE(eventually([&] { return !board.lit(2) && !board.lit(3); }));
}

TEST_F(PanelConsole, buzzerSoundsOncePerLostLinkUnlessMuted)
{
    for (const bool sound : {true, false}) {
        MainWindow::Options o = options();
        auto source = std::make_unique<ScriptedSource>();
        ScriptedSource* script = source.get();
        o.source = std::move(source);
        show(std::move(o));
        window->preferences().change([&](Preferences& p) { p.sound = sound; });
        ASSERT_TRUE(eventually([&] { return board.lit(0); })) << "the lamps' test is over";
        QTest::qWait(1800);
        ASSERT_FALSE(board.lit(3));
        script->setSilent(true);
        ASSERT_TRUE(eventually([&] { return !window->exploration().linkAlive(); }));
        const auto isSounding = [&] { return board.lit(3); };
        EXPECT_EQ(sound ? eventually(isSounding) : QTest::qWaitFor(isSounding, 1000), sound);
        EXPECT_TRUE(eventually([&] { return !board.lit(3); }, 3000)) << "and then it is quiet";
        EXPECT_FALSE(window->exploration().linkAlive());
        window.reset();
    }
}

TEST_F(PanelConsole, stopLatchesUntilPanelAndWindowReleaseIt)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    board.close(PanelContact::Stop, false);
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    QTest::keyPress(window.get(), Qt::Key_R);
    QTest::qWait(400);  // longer than the hold time
    QTest::keyRelease(window.get(), Qt::Key_R);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Stopped) << "it is still pressed";
    board.close(PanelContact::Stop, true);
    QTest::qWait(200);  // waits for an event that must not come
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Stopped) << "it releases nothing";
    QTest::keyPress(window.get(), Qt::Key_R);
    EXPECT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
}

TEST_F(PanelConsole, stopThatIsPressedFromTheStartForbidsToDrive)
{
    board.close(PanelContact::Stop, false);
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    QTest::qWait(200);  // waits for an event that must not come
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    board.close(PanelContact::Stop, true);
    EXPECT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
}

TEST_F(PanelConsole, diagnosticsShowTheStateOfThePanel)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    const auto says = [&](const char* words) {
        return window->diagnosticsPage()->text().contains(QString::fromUtf8(words));
    };
    EXPECT_TRUE(says("panel: ✔ answers"));
    EXPECT_TRUE(says("contact stop: closed"));
    EXPECT_TRUE(says("contact atem: open · edges 0 · presses 0"));
    EXPECT_TRUE(says("STOP to the bus: --"));
    push(PanelContact::Atem);
    EXPECT_TRUE(eventually([&] { return says("contact atem: open · edges 2 · presses 1"); }))
        << window->diagnosticsPage()->text().toStdString();
    board.close(PanelContact::Stop, false);
    EXPECT_TRUE(eventually([&] { return says("of 1\n"); }))
        << window->diagnosticsPage()->text().toStdString();
}

TEST_F(PanelConsole, coveredProposalIsNeitherShownNorApproved)
{
    openSimulated();
    ASSERT_NO_FATAL_FAILURE(propose());
    const ProbeCard& card = *window->probeCard();
    QDialog dialog(window.get());
    dialog.setGeometry(QRect(card.mapToGlobal(QPoint()), card.size() / 2));
    dialog.show();
    EXPECT_TRUE(eventually([&] { return !card.shown(); }));
    const auto* banner = window->findChild<QLabel*>("question");
    EXPECT_TRUE(eventually([&] { return banner->isVisible(); }));
    board.close(PanelContact::Approve, true);
    EXPECT_TRUE(eventually([&] {
        return !window->events()
                    ->findItems("close the window that covers the question", Qt::MatchContains)
                    .empty();
    }));
    QTest::qWait(1000 * PanelControl::kApproveHold + 200);  // waits for an event that must not come
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    board.close(PanelContact::Approve, false);
    dialog.close();
    EXPECT_TRUE(eventually([&] { return card.shown() && !banner->isVisible(); }));
}

TEST_F(PanelConsole, panelMissingFromTheStartCausesNoStop)
{
    board.unplug();
    openSimulated();
    EXPECT_TRUE(eventually([&] { return says("PANEL LOST: connect the operator's panel, or"); }));
    EXPECT_FALSE(says("hold R"));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle);
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_TRUE(reaches(AtemPhase::Stopped));
    EXPECT_TRUE(eventually([&] { return says("hold R"); }));
}

TEST_F(PanelConsole, aPanelThatDoesNotReturnStops)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    board.hang(true);
    EXPECT_TRUE(reaches(AtemPhase::Stopped));
    EXPECT_TRUE(eventually([&] { return says("PANEL LOST, STOP is asserted"); }));
    board.hang(false);
    EXPECT_TRUE(eventually([&] { return !says("PANEL LOST"); }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Stopped);
    QTest::keyPress(window.get(), Qt::Key_R);
    EXPECT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
}

TEST_F(PanelConsole, lossOfThePanelStopsAndIsShownUntilItIsBack)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    EXPECT_FALSE(says("PANEL LOST"));
    board.unplug();
    EXPECT_TRUE(reaches(AtemPhase::Stopped));
    EXPECT_TRUE(eventually([&] { return !window->atemPanel()->requestButton()->isEnabled(); }));
    EXPECT_TRUE(eventually([&] { return says("PANEL LOST, STOP is asserted"); }));
    EXPECT_FALSE(says("STOP was pressed")) << "nobody did";
    QTest::keyPress(window.get(), Qt::Key_R);
    EXPECT_TRUE(eventually([&] {
        return !window->events()->findItems("connect it first", Qt::MatchContains).empty();
    }));
    QTest::keyRelease(window.get(), Qt::Key_R);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Stopped);
    board.plugIn();
    EXPECT_TRUE(eventually([&] { return !says("PANEL LOST"); }));
    QTest::keyPress(window.get(), Qt::Key_R);
    EXPECT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
}

TEST_F(PanelConsole, lossOfThePanelOfAConsoleThatOnlyListensMeansNoStop)
{
    MemoryBus bus{steadyNow};
    CanSource link{bus.join("can0"), model, {.mode = CanSource::Mode::Listen}};
    MainWindow::Options o = options();
    auto source = std::make_unique<ScriptedSource>();
    Measurement stopped;
    stopped.activity = RobotActivity::Stopped;  // stopped from elsewhere
    source->setMeasurement(stopped);
    o.source = std::move(source);
    o.link = &link;
    show(std::move(o));
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    board.unplug();
    EXPECT_TRUE(eventually([&] { return says("PANEL LOST: connect the operator's panel"); }));
    EXPECT_FALSE(says("PANEL LOST, STOP is asserted"));
    EXPECT_FALSE(window->events()->findItems("the panel is lost", Qt::MatchContains).empty());
    EXPECT_TRUE(window->events()->findItems("means STOP", Qt::MatchContains).empty());
    const auto alarms = window->alarms().list().alarms();
    EXPECT_TRUE(std::ranges::any_of(alarms, [](const Alarm& alarm) {
        return alarm.text.english() == "The operator's panel does not answer";
    }));
    window.reset();  // the window uses the link
}

TEST_F(PanelConsole, panelThatThrowsIsALostPanelAndEndsNothingElse)
{
    openSimulated();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    board.breakDown();
    EXPECT_TRUE(reaches(AtemPhase::Stopped));
    EXPECT_TRUE(eventually([&] { return !window->atemPanel()->requestButton()->isEnabled(); }));
}

TEST_F(PanelConsole, robotOnABusIsDisarmedWithThePanel)
{
    MemoryBus bus{steadyNow};
    SimulatedRobot::Options simulation;
    simulation.startX = 2.1;
    const RobotInProcess robot(bus, model, SimulatedRobot(model, demoTerrain(), simulation),
                               RobotOnBus::Options{});
    MainWindow::Options o = options();
    auto source = std::make_unique<CanSource>(
        bus.join("can0"), model, CanSource::Options{.mode = CanSource::Mode::Transmit});
    o.link = source.get();
    o.source = std::move(source);
    board.close(PanelContact::Stop, false);
    show(std::move(o));
    ASSERT_TRUE(eventually([&] { return !whyNotArming(window->link()->view()); }));
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_FALSE(window->header()->arming()->armButton()->isEnabled()) << "STOP is pressed";
    board.close(PanelContact::Stop, true);
    window->header()->arming()->confirmButton()->setHoldTime(100);
    ASSERT_TRUE(eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
    QTest::qWait(600);
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(
        eventually([&] { return window->header()->arming()->confirmButton()->isVisible(); }));
    QTest::qWait(60);  // a second action, not key repeat
    QTest::keyPress(window.get(), Qt::Key_M);
    const auto phase = [&] { return window->link()->view().link.arming.phase; };
    ASSERT_TRUE(eventually([&] { return phase() == ArmingPhase::Armed; }));
    QTest::keyRelease(window.get(), Qt::Key_M);
    ASSERT_TRUE(eventually([&] { return board.lit(1); })) << "armed";
    board.unplug();
    EXPECT_TRUE(eventually([&] { return phase() == ArmingPhase::Disarmed; }));
    QTest::qWait(300);  // lets frames on their way arrive
    const std::uint64_t heartbeats = window->link()->view().frames.sent;
    QTest::qWait(500);  // a rate by the real clock
    EXPECT_LE(window->link()->view().frames.sent - heartbeats, 4U)
        << "without the panel there is no heartbeat, only STOP until the robot has confirmed it";
    window.reset();
}

}  // namespace
}  // namespace terratact
