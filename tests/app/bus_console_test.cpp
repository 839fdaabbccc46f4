// The console on a robot on a bus, as an operator meets it.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <string>
#include <thread>
#include <vector>

#include "app/bus_words.h"
#include "app/main_window.h"
#include "app/resources.h"
#include "app/robot_in_process.h"
#include "app/signals_page.h"
#include "app/steady_now.h"
#include "core/sim/terrain_shapes.h"
#include "core/wire/candump_log.h"
#include "core/wire/frame_layout.h"
#include "drivers/candump_replay.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/staged_robot.h"
#include "tests/support/temporary_directory.h"
#include "widgets/arming_control.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/event_list.h"
#include "widgets/force_bars.h"
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

/// Every estimate that an exploration comes to, the newest last.
class Estimates {
public:
    explicit Estimates(Exploration& exploration)
    {
        QObject::connect(&exploration, &Exploration::happened, [this, &exploration] {
            const auto& now = exploration.estimation().estimate();
            if (now && (all_.empty() || all_.back() != *now)) all_.push_back(*now);
        });
    }
    const std::vector<TerrainEstimate>& all() const { return all_; }

private:
    std::vector<TerrainEstimate> all_;
};

/// All that an end of a bus has received since it was asked last.
std::vector<BusFrame> framesOf(CanBus& end)
{
    std::vector<BusFrame> all;
    std::array<BusFrame, 64> frames;
    for (;;) {
        const auto count = end.receive(frames, 0ms);
        if (!count || *count == 0) return all;
        all.insert(all.end(), frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(*count));
    }
}

/// The same as candump -L would have written it.
std::string candumpOf(CanBus& end)
{
    std::string log;
    for (const BusFrame& heard : framesOf(end))
        log += candumpLine(heard.time, "can0", heard.frame) + "\n";
    return log;
}

struct BusConsole : testing::Test {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(CanSource::Mode mode = CanSource::Mode::Transmit, RobotFault fault = RobotFault::None)
    {
        startRobot(fault);
        window = console(bus.join("can0"), mode, [] { return Result<LoadedModel>(madeUp()); });
        gui::showActive(*window);
    }
    void startRobot(RobotFault fault = RobotFault::None)
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, demoTerrain(), simulation),
            RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0, .fault = fault});
    }
    std::unique_ptr<MainWindow> console(std::unique_ptr<CanBus> end, CanSource::Mode mode,
                                        ModelLoader loader) const
    {
        auto source = std::make_unique<CanSource>(
            std::move(end), model,
            CanSource::Options{.mode = mode,
                               .link = {.gate = {.operatorAge = operatorAge}},
                               .waits = mode == CanSource::Mode::Replay});
        MainWindow::Options options;
        options.robot = model;
        options.link = source.get();
        options.source = std::move(source);
        options.model = std::move(loader);
        options.exploration.driveSpeed = 0.02;
        options.exploration.settings.probeAbove = 0.005;  // there is always something to probe
        auto made = std::make_unique<MainWindow>(std::move(options));
        made->header()->arming()->confirmButton()->setHoldTime(150);
        made->probeCard()->approveButton()->setHoldTime(150);
        made->resize(1280, 720);
        return made;
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
    static bool hasModel(MainWindow& console)
    {
        const QList<Precondition> all = console.exploration().preconditions();
        return std::ranges::any_of(
            all, [](const Precondition& p) { return p.text == "model default.ttm is ready"; });
    }
    bool says(const QString& words) const
    {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
    ArmingPhase arming() const { return window->link()->view().link.arming.phase; }
    bool holds(int key, ArmingPhase until)
    {
        QTest::qWait(60);  // no operator is faster, only a server that repeats a held key
        QTest::keyPress(window.get(), static_cast<Qt::Key>(key));
        (void)eventually([&] { return arming() == until || arming() == ArmingPhase::Disarmed; });
        QTest::keyRelease(window.get(), static_cast<Qt::Key>(key));
        return arming() == until;
    }
    /// Both actions; false where something disarmed the console between them, or before the first.
    bool arms()
    {
        if (!eventually([&] { return window->header()->arming()->armButton()->isEnabled(); }))
            return false;
        QTest::qWait(400);  // the robot wants ten heartbeats
        QTest::keyClick(window.get(), Qt::Key_M);
        if (!eventually([&] { return window->header()->arming()->confirmButton()->isVisible(); },
                        2000))
            return false;
        picture("arming-asks");
        return holds(Qt::Key_M, ArmingPhase::Armed);
    }
    void arm() { ASSERT_TRUE(arms()); }
    /// Arms and drives, key W held; false where something disarmed the console on the way.
    bool drives()
    {
        QTest::keyRelease(window.get(), Qt::Key_W);
        if (arming() != ArmingPhase::Armed && !arms()) return false;
        if (!eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }, 2000))
            return false;
        QTest::keyPress(window.get(), Qt::Key_W);
        (void)eventually(
            [&] { return arming() != ArmingPhase::Armed || robotDoes(RobotActivity::Driving); });
        return arming() == ArmingPhase::Armed && robotDoes(RobotActivity::Driving);
    }
    /// Explores and probes by keys; false where something disarmed the console on the way.
    bool exploresAndProbes()
    {
        const auto failsOnlyDisarmed = [this] {
            const AtemState& state = window->exploration().state();
            EXPECT_TRUE(state.phase == AtemPhase::Failed
                        && (state.failure == AtemFailure::Disarmed
                            || state.failure == AtemFailure::LinkLost))
                << describe(state.phase) << ": " << describe(state.failure);
            return false;
        };
        const auto gets = [this](AtemPhase phase) {
            (void)eventually(
                [&] {
                    const AtemPhase now = window->exploration().state().phase;
                    return now == phase || now == AtemPhase::Failed;
                },
                60000);
            return window->exploration().state().phase == phase;
        };
        if (!eventually([&] {
                return window->atemPanel()->requestButton()->isEnabled()
                    || arming() != ArmingPhase::Armed;
            })
            || arming() != ArmingPhase::Armed)
            return false;
        QTest::keyClick(window.get(), Qt::Key_A);
        if (!gets(AtemPhase::ProposingProbe)) return failsOnlyDisarmed();
        EXPECT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
        picture("asks-for-a-probe");
        QTest::keyPress(window.get(), Qt::Key_Space);
        const bool presents = gets(AtemPhase::Presenting);
        QTest::keyRelease(window.get(), Qt::Key_Space);
        return presents || failsOnlyDisarmed();
    }
    bool robotDoes(RobotActivity activity) const
    {
        const auto latest = window->acquisition().latest();
        return latest && latest->sample.measurement.activity == activity;
    }
    bool robotIs(RobotActivity activity)
    {
        return eventually([&] { return robotDoes(activity); });
    }
    bool reaches(AtemPhase phase)
    {
        return eventually([&] { return window->exploration().state().phase == phase; }, 60000);
    }

    RobotModel model = absolem();
    double operatorAge = 1.0;  // [s] instead of 0.1: only a test that freezes the window means it
    MemoryBus bus{steadyNow};
    std::unique_ptr<RobotInProcess> robot;
    std::unique_ptr<MainWindow> window;
};

TEST_F(BusConsole, showsTheForcesOfBothArraysTheirVoltagesAndADriftedBias)
{
    startRobot();
    model.forceCalibration.biasLeft[1] += 0.5;  // the robot's own is smaller
    window = console(bus.join("can0"), CanSource::Mode::Listen,
                     [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    const ForceBars& bars = *window->forces();
    ASSERT_TRUE(eventually([&] { return bars.arrays() == 2 && bars.numberText(0, 1) != "--"; }));
    EXPECT_EQ(bars.legend(), "■ L  □ R");
    EXPECT_TRUE(eventually([&] { return bars.driftText(1).startsWith("bias −0."); }))
        << bars.driftText(1).toStdString();
    EXPECT_EQ(bars.driftText(2), "");
    EXPECT_EQ(bars.numberText(1, 0), "0.0") << "less than nothing is not felt";
    window->resize(1200, 680);
    picture("forces");
    EXPECT_TRUE(gui::cutText(*bars.parentWidget()).empty());
    window->forceUnitButton()->click();
    EXPECT_EQ(bars.unit(), ForceBars::Unit::Volts);
    picture("force-voltages");
    // The sandwich alone: 0.3 N, 20 kΩ over 10 kΩ at 5 V.
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
        EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    }
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
    // On a busy machine heartbeats may come too late and disarm the console in some go; in every go is somebody's
    // fault, as where the end of an exploration disarms.
    bool drivesOn = false;
    for (int go = 0; go < 10 && !drivesOn && !HasFailure(); ++go) {
        if (!drives()) continue;
        const int epoch = window->link()->view().link.arming.epoch;  // another for every arming
        QTest::keyRelease(window.get(), Qt::Key_W);
        ASSERT_TRUE(robotIs(RobotActivity::Halted));
        if (!exploresAndProbes()) continue;
        EXPECT_TRUE(window->exploration().state().probed);
        picture("presenting");
        QTest::qWait(200);
        drivesOn = drives() && window->link()->view().link.arming.epoch == epoch;
    }
    EXPECT_TRUE(drivesOn) << "it had to be armed anew each time";
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(BusConsole, saysWhyTheRobotRefusedTheProbeInEveryLayout)
{
    open(CanSource::Mode::Transmit, RobotFault::RefuseProbe);
    window->preferences().change([](Preferences& p) { p.layout = Layout::Drive; });
    arm();
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe));
    ASSERT_TRUE(eventually([&] { return window->probeCard()->shown().has_value(); }));
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

/// What was on the bus while the window stood still; times are the bus's own [s].
struct Freeze {
    double began = 0.0, ended = 0.0;
    std::vector<BusFrame> frames{};
    std::vector<double> timesOf(FrameKind kind) const
    {
        std::vector<double> times;
        for (const BusFrame& heard : frames)
            if (kindOfId(heard.frame.id) == kind && heard.time > began && heard.time <= ended)
                times.push_back(heard.time);
        return times;
    }
};

TEST_F(BusConsole, frozenWindowStopsTheDrive)
{
    operatorAge = GateLimits{}.operatorAge;
    const auto recorder = bus.join("recorder", 0);
    open();
    // On a busy machine this window may have been held up for 100 ms before, and the drive has ended with that; or the
    // thread that sends, between its look at the clock and the bus.  Too late in every go is the console's fault.
    Freeze freeze;
    std::vector<double> last;  // frames that keep it driving, since the freeze began
    for (int go = 0; go < 20 && last.size() < 4 && (last.empty() || last.back() > 0.1); ++go) {
        if (!drives()) continue;
        freeze.began = steadyNow();
        std::this_thread::sleep_for(1s);
        freeze.ended = steadyNow();
        freeze.frames = framesOf(*recorder);
        if (freeze.timesOf(FrameKind::Drive).empty()) continue;
        last.push_back(0.0);
        for (const FrameKind kind : {FrameKind::Drive, FrameKind::ConsoleHeartbeat})
            for (const double at : freeze.timesOf(kind))
                last.back() = std::max(last.back(), at - freeze.began);
    }
    ASSERT_FALSE(last.empty()) << "it never drove into a freeze";
    EXPECT_LE(last.back(), 0.1) << "in " << last.size() << " goes";
    const std::vector<double> drives = freeze.timesOf(FrameKind::Drive);
    const std::vector<double> disarmings = freeze.timesOf(FrameKind::Arm);
    ASSERT_EQ(disarmings.size(), 1U) << "while the window stood still";
    EXPECT_GT(disarmings.front(), drives.back());
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
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(window->exploration().state().failure);
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
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(window->exploration().state().failure);
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

TEST_F(BusConsole, telemetryThatStopsAloneIsNoLostLink)
{
    SimulatedRobot::Options simulation;
    simulation.startX = 2.0;
    StagedRobot numb(bus, model, SimulatedRobot(model, demoTerrain(), simulation),
                     RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0});
    window = console(bus.join("can0"), CanSource::Mode::Transmit,
                     [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    numb.stage({.isNumb = true});
    EXPECT_TRUE(eventually([&] {
        return says("TELEMETRY LOST for") && says("frames still come, heartbeat")
            && says("no measured value is live");
    }));
    EXPECT_FALSE(says("nothing on this screen is live"));
    picture("telemetry-stopped");
    numb.stage({.isMute = true});
    EXPECT_TRUE(eventually([&] { return says("nothing on this screen is live"); }));
    EXPECT_FALSE(says("frames still come"));
    window.reset();
}

TEST(StillComes, isToldOfFramesOfTheRobotThatMayBeUsed)
{
    const auto frame = [](std::optional<FrameKind> kind, std::optional<double> age) {
        TappedFrame made;
        made.kind = kind;
        made.age = age;
        return made;
    };
    EXPECT_EQ(stillComes({}), "");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotHeartbeat, 0.1), frame(FrameKind::Attitude, 0.8)}),
              "frames still come, heartbeat 100 ms old");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotHeartbeat, 3.0), frame(FrameKind::Odometry, 0.02)}),
              "frames still come, heartbeat 3.0 s old");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotHeartbeat, {}), frame(FrameKind::Odometry, 0.02)}),
              "frames still come");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotStatus, 0.5), frame(FrameKind::Odometry, 0.02)}),
              "frames still come, status 500 ms old");
    EXPECT_EQ(stillComes({frame(FrameKind::RobotHeartbeat, 0.26)}), "");
    EXPECT_EQ(stillComes({frame(FrameKind::ConsoleHeartbeat, 0.0), frame({}, 0.0)}), "")
        << "neither is the robot's";
}

TEST_F(BusConsole, saysInTheHeaderHowTheBusIs)
{
    startRobot();
    window = console(bus.join("can0"), CanSource::Mode::Listen,
                     [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
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
    // The rows of the robot are as old as the frames that they came in.
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(eventually(
        [&] { return window->readout()->ageText(RobotReadout::Pitch).endsWith(" ms"); }));
    picture("bus-chip");
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
    EXPECT_TRUE(says("STOP HAS NO EFFECT HERE"));
    QPushButton& stop = *window->header()->stopButton();
    EXPECT_EQ(stop.text(), "STOP: no commands");
    const QImage image = gui::painted(stop);
    EXPECT_EQ(image.pixelColor(12, image.height() / 2), theme().chip.area) << "it looks like none";
    EXPECT_EQ(window->link()->view().frames.sent, 0U);
    picture("listening");
}

TEST_F(BusConsole, whoeverListensOrReplaysComesToTheSameEstimates)
{
    const auto shipped = [this] {
        return modelFileLoader(resourcePath("models/default.ttm"), model);
    };
    const auto recorder = bus.join("recorder", 0);
    startRobot();
    const auto listener = console(bus.join("can1"), CanSource::Mode::Listen, shipped());
    const Estimates heard(listener->exploration());
    window = console(bus.join("can0"), CanSource::Mode::Transmit, shipped());
    const Estimates made(window->exploration());
    gui::showActive(*window);
    for (MainWindow* one : {listener.get(), window.get()})
        ASSERT_TRUE(eventually([&] { return hasModel(*one); }));
    arm();
    ASSERT_TRUE(exploresAndProbes());
    ASSERT_TRUE(eventually([&] { return heard.all().size() == 2; }));
    const auto ledger = window->exploration().estimation().ledger().entries();
    const TemporaryDirectory directory;
    const std::string log = directory.write("atem.log", candumpOf(*recorder));
    window.reset();

    auto replay = CandumpReplay::open(log, {.speed = 2.0});
    ASSERT_TRUE(replay) << replay.error().text;
    window = console(std::move(*replay), CanSource::Mode::Replay, shipped());
    const Estimates replayed(window->exploration());
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return replayed.all().size() == 1; }));
    picture("following");
    ASSERT_TRUE(eventually([&] { return window->exploration().ended(); }));
    ASSERT_TRUE(eventually([&] { return replayed.all().size() == 2; }));
    ASSERT_EQ(made.all().size(), 2U);
    EXPECT_EQ(std::ranges::count(made.all()[0].origin, Origin::Arm), 0);
    EXPECT_EQ(std::ranges::count(made.all()[1].origin, Origin::Arm), 1);
    EXPECT_EQ(heard.all(), made.all());
    EXPECT_EQ(replayed.all(), made.all());
    ASSERT_EQ(ledger.size(), 1U);
    EXPECT_EQ(listener->exploration().estimation().ledger().entries(), ledger);
    EXPECT_TRUE(eventually([&] { return window->probeCard()->tells(); }))
        << "what a probe would buy is known here, too";
    EXPECT_FALSE(window->probeCard()->asks());
    EXPECT_EQ(window->exploration().estimation().ledger().entries(), ledger);
    EXPECT_EQ(listener->link()->view().frames.sent, 0U);
}

TEST_F(BusConsole, aLogHasAnEndAndNoLostLink)
{
    auto replay = CandumpReplay::open(TERRATACT_SOURCE_DIR "/docs/can_demo.log", {});
    ASSERT_TRUE(replay) << replay.error().text;
    window = console(std::move(*replay), CanSource::Mode::Replay, [] {
        std::this_thread::sleep_for(500ms);  // longer than the whole log
        return Result<LoadedModel>(madeUp());
    });
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return says("END OF THE LOG"); }));
    QTest::qWait(500);  // a link would be lost by now
    EXPECT_TRUE(says("END OF THE LOG"));
    EXPECT_FALSE(says("LINK LOST"));
    EXPECT_TRUE(says("the log has ended"));
    for (const Alarm& alarm : window->alarms().list().alarms()) {
        EXPECT_EQ(alarm.severity, Severity::Caution) << alarm.text;
        for (const char* id : {"link", "silence", "bus"}) EXPECT_NE(alarm.id, id) << alarm.text;
    }
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(eventually([&] { return says("REPLAY can_demo.log has ended"); }));
    for (const QLabel* label : window->findChildren<QLabel*>())
        EXPECT_FALSE((label->text() + label->toolTip()).contains("does not exist"));
    QTest::keyClick(window.get(), Qt::Key_F2);
    EXPECT_TRUE(says("Following"));
    EXPECT_TRUE(window->exploration().estimation().estimate()) << "its press waited for the model";
    EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
    picture("end-of-the-log");
}

}  // namespace
}  // namespace terratact
