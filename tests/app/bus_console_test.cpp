// The console on a robot on a bus, as an operator meets it.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <thread>

#include "app/main_window.h"
#include "app/robot_in_process.h"
#include "app/steady_now.h"
#include "core/sim/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/event_list.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/probe_card.h"
#include "widgets/status_header.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using gui::eventually;

LoadedModel madeUp()
{
    return {.estimate =
                [](const EstimateRequest& request, const Watch&) {
                    TerrainEstimate e = request.arm.empty() ? stepEstimate() : probedEstimate();
                    e.settings = request.settings;
                    return e;
                },
            .name = "fake.ttm",
            .details = {}};
}

struct BusConsole : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(CanSource::Mode mode = CanSource::Mode::Transmit)
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation),
            RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0});
        auto source =
            std::make_unique<CanSource>(bus.join("can0"), model, CanSource::Options{.mode = mode});
        MainWindow::Options options;
        options.robot = model;
        options.link = source.get();
        options.source = std::move(source);
        options.model = [] { return Result<LoadedModel>(madeUp()); };
        options.exploration.driveSpeed = 0.02;
        window = std::make_unique<MainWindow>(std::move(options));
        window->header()->arming()->confirmButton()->setHoldTime(150);
        window->probeCard()->approveButton()->setHoldTime(150);
        window->resize(1280, 720);
        gui::showActive(*window);
    }
    ~BusConsole() override
    {
        window.reset();  // its source lives on the bus
        robot.reset();
    }
    /// For whoever wants to see: pictures of the window go where TERRATACT_PICTURES says.
    void picture(const QString& name)
    {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (!folder.isEmpty()) window->grab().save(folder + "/" + name + ".png");
    }
    ArmingPhase arming() const { return window->link()->view().link.arming.phase; }
    bool holds(int key, ArmingPhase until)
    {
        QTest::qWait(60);  // no operator is faster, only a server that repeats a held key
        QTest::keyPress(window.get(), static_cast<Qt::Key>(key));
        const bool reached = eventually([&] { return arming() == until; });
        QTest::keyRelease(window.get(), static_cast<Qt::Key>(key));
        return reached;
    }
    void arm()
    {
        ASSERT_TRUE(
            eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
        QTest::qWait(400);  // the robot wants ten heartbeats
        QTest::keyClick(window.get(), Qt::Key_M);
        ASSERT_TRUE(
            eventually([&] { return window->header()->arming()->confirmButton()->isVisible(); }));
        picture("arming-asks");
        ASSERT_TRUE(holds(Qt::Key_M, ArmingPhase::Armed));
    }
    bool robotIs(RobotActivity activity)
    {
        return eventually([&] {
            const auto latest = window->acquisition().latest();
            return latest && latest->sample.measurement.activity == activity;
        });
    }
    bool reaches(AtemPhase phase)
    {
        return eventually([&] { return window->exploration().state().phase == phase; }, 60000);
    }

    RobotModel model = absolem();
    MemoryBus bus{steadyNow};
    std::unique_ptr<RobotInProcess> robot;
    std::unique_ptr<MainWindow> window;
};

TEST_F(BusConsole, takesTwoActionsToArmAndNothingMovesBefore)
{
    open();
    EXPECT_EQ(window->header()->sourceName(), "can0");
    ASSERT_TRUE(eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }));
    picture("disarmed");
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    EXPECT_FALSE(window->atemPanel()->requestButton()->isEnabled());
    QTest::qWait(400);
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(eventually([&] { return arming() == ArmingPhase::Confirming; }));
    QTest::keyClick(window.get(), Qt::Key_M);  // too short
    QTest::qWait(300);
    EXPECT_NE(arming(), ArmingPhase::Armed);
    ASSERT_TRUE(holds(Qt::Key_M, ArmingPhase::Armed));
    EXPECT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    picture("armed");
    QTest::qWait(60);
    QTest::keyClick(window.get(), Qt::Key_M);
    EXPECT_TRUE(eventually([&] { return arming() == ArmingPhase::Disarmed; }));
    EXPECT_TRUE(eventually([&] { return !window->drivePad()->forwardButton()->isEnabled(); }));
}

TEST_F(BusConsole, heldKeyThatAnXServerRepeatsArmsNothing)
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
    arm();
    ASSERT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyRelease(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(window->exploration().state().failure);
    ASSERT_TRUE(eventually([&] { return window->probeCard()->asks(); }));
    picture("asks-for-a-probe");
    QTest::keyPress(window.get(), Qt::Key_Space);
    ASSERT_TRUE(robotIs(RobotActivity::Probing));
    QTest::keyRelease(window.get(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting)) << describe(window->exploration().state().failure);
    EXPECT_TRUE(window->exploration().state().probed);
    picture("presenting");
    ASSERT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    QTest::qWait(200);
    QTest::keyPress(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Driving)) << "the exploration has ended for the robot, too";
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(BusConsole, frozenWindowStopsTheDrive)
{
    open();
    arm();
    ASSERT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    const std::uint64_t before = window->link()->view().frames.sent;
    std::this_thread::sleep_for(1s);
    const std::uint64_t after = window->link()->view().frames.sent;
    // 100 ms of drives every 20 ms, a heartbeat, a halt, a disarming; with room for a busy machine.
    EXPECT_LE(after - before, 15U);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_EQ(arming(), ArmingPhase::Disarmed);
}

TEST_F(BusConsole, disarmedRobotEndsTheExploration)
{
    open();
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(reaches(AtemPhase::Failed));
    EXPECT_EQ(window->exploration().state().failure, AtemFailure::Disarmed);
    picture("disarmed-while-exploring");
}

TEST_F(BusConsole, noTextIsCutAtTheSmallestSize)
{
    open();
    window->resize(window->minimumSize());
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    QTest::qWait(100);
    EXPECT_EQ(window->size(), window->minimumSize()) << "the layout needs more than this";
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    picture("smallest");
}

TEST_F(BusConsole, lostLinkIsSaidWithItsCure)
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

TEST_F(BusConsole, listensOnlyUnlessToldToTransmit)
{
    open(CanSource::Mode::Listen);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    EXPECT_FALSE(window->header()->arming()->armButton()->isEnabled());
    EXPECT_TRUE(window->header()->arming()->armButton()->toolTip().contains("--transmit"));
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_F12);
    QTest::qWait(100);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle) << "nothing is stopped";
    EXPECT_EQ(window->link()->view().frames.sent, 0U);
    picture("listening");
}

}  // namespace
}  // namespace terratact
