// Tests the console with a robot on a CAN bus, through real mouse and key events.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/console/main_window.h"
#include "app/runtime/steady_now.h"
#include "core/wire/frame_layout.h"
#include "tests/support/absolem.h"
#include "tests/support/bus_console_bench.h"
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
    EXPECT_EQ(bars.driftText(2), "");
    EXPECT_EQ(bars.numberText(1, 0), "0.0") << "less than nothing is not felt";
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
    QTest::qWait(400);
    QTest::keyClick(window.get(), Qt::Key_M);
    ASSERT_TRUE(eventually([&] { return arming() == ArmingPhase::Confirming; }));
    QTest::keyClick(window.get(), Qt::Key_M);  // shorter than the hold time
    QTest::qWait(300);
    EXPECT_NE(arming(), ArmingPhase::Armed);
    ASSERT_TRUE(confirmsArming(*window));
    EXPECT_TRUE(eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); }));
    picture("armed");
    QTest::qWait(60);
    QTest::keyClick(window.get(), Qt::Key_M);
    EXPECT_TRUE(eventually([&] { return arming() == ArmingPhase::Disarmed; }));
    EXPECT_TRUE(eventually([&] { return !window->drivePad()->forwardButton()->isEnabled(); }));
}

TEST_F(BusConsole, canBeArmedAgainWhereSomethingDisarmedOnTheWay)
{
    open();
    EXPECT_FALSE(terratact::armsOnce(*window, [this] { window->link()->disarm(); }));
    int goes = 0;
    EXPECT_TRUE(inSomeGo([&] {
        if (++goes == 1) window->link()->disarm();
        return goes > 1 && exploresUntilAsked();
    }));
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
    const bool drivesOn = inSomeGo([this] {
        if (!drives()) return false;
        const int epoch = window->link()->view().link.arming.epoch;  // changes with every arming
        QTest::keyRelease(window.get(), Qt::Key_W);
        EXPECT_TRUE(robotIs(RobotActivity::Halted));
        if (!exploresAndProbes()) return false;
        EXPECT_TRUE(window->exploration().state().probed);
        picture("presenting");
        QTest::qWait(200);
        return drives() && window->link()->view().link.arming.epoch == epoch;
    });
    EXPECT_TRUE(drivesOn) << "it had to be armed anew each time";
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(BusConsole, closingWhileArmedNeedsASecondRequest)
{
    open();
    ASSERT_TRUE(eventually([&] { return window->exploration().linkAlive(); }));
    window->close();
    EXPECT_FALSE(window->isVisible()) << "of a disarmed one at once";
    window->show();
    const auto closesAskedTwice = [&] {
        if (!armsOnce()) return false;
        window->close();
        if (!window->isVisible()) {  // a delay has disarmed it meanwhile
            window->show();
            return false;
        }
        for (int repeated = 0; repeated < 10; ++repeated) {  // key repeat of one second
            QTest::qWait(100);
            window->close();
        }
        EXPECT_TRUE(window->isVisible() || arming() != ArmingPhase::Armed)
            << "neither a double click nor a key that repeats is an answer";
        (void)eventually([&] { return says("THE ROBOT IS ARMED: close the window again"); }, 2000);
        const bool asks = says("THE ROBOT IS ARMED: close the window again");
        picture("closing-armed");
        QTest::qWait(800);
        const bool stillArmed = window->isVisible() && arming() == ArmingPhase::Armed;
        window->close();
        if (asks && stillArmed && !window->isVisible()) return true;
        window->show();
        return false;
    };
    ASSERT_TRUE(inSomeGo(closesAskedTwice));
    EXPECT_TRUE(eventually([&] { return arming() != ArmingPhase::Armed; }));
}

TEST_F(BusConsole, anOldCloseRequestIsForgotten)
{
    open();
    const auto asksAgain = [&] {
        if (arming() != ArmingPhase::Armed && !armsOnce()) return false;
        window->close();
        QTest::qWait(static_cast<int>(1000.0 * ShortNotice::kFor) + 200);
        if (!window->isVisible()) window->show();  // a delay had disarmed it
        if (arming() != ArmingPhase::Armed) return false;
        window->close();
        EXPECT_TRUE(window->isVisible()) << "that was the first try";
        return true;
    };
    EXPECT_TRUE(inSomeGo(asksAgain));
}

TEST_F(BusConsole, aSignalClosesTheWindowOfAnArmedRobotAtOnce)
{
    open();
    ASSERT_TRUE(inSomeGo([&] { return armsOnce(); }));
    window->closeUnasked();
    EXPECT_FALSE(window->isVisible());
    EXPECT_TRUE(eventually([&] { return arming() != ArmingPhase::Armed; }));
}

TEST_F(BusConsole, saysWhyTheRobotRefusedTheProbeInEveryLayout)
{
    open(CanSource::Mode::Transmit, RobotFault::RefuseProbe);
    window->preferences().change([](Preferences& p) { p.layout = Layout::Drive; });
    ASSERT_TRUE(inSomeGo([this] { return exploresUntilAsked(); }));
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

/// Frames on the bus while the window was frozen; times are those of the bus [s].
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

/// An end of a bus that records the thread serving it.
class ServedBus final : public CanBus {
public:
    ServedBus(std::unique_ptr<CanBus> bus, std::shared_ptr<std::atomic<pid_t>> thread)
        : bus_(std::move(bus)), thread_(std::move(thread))
    {
    }
    std::string name() const override { return bus_->name(); }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override
    {
        *thread_ = ::gettid();
        return bus_->receive(frames, patience);
    }
    Status send(const CanFrame& frame) override { return bus_->send(frame); }
    BusState state() const override { return bus_->state(); }
    BusCounters counters() const override { return bus_->counters(); }

private:
    std::unique_ptr<CanBus> bus_;
    std::shared_ptr<std::atomic<pid_t>> thread_;
};

/// Returns how long [s] a thread of this process waited for a processor, by the kernel's accounting; 0 if unknown.
double keptWaiting(pid_t thread)
{
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    double ran = 0.0, waited = 0.0;
    return file >> ran >> waited ? 1e-9 * waited : 0.0;
}

TEST_F(BusConsole, frozenWindowStopsTheDrive)
{
    constexpr int kGoes = 4;
    constexpr double kLimit = 0.1;  // [s]
    operatorAge = GateLimits{}.operatorAge;
    const auto recorder = bus.join("recorder", 0);
    const auto sender = std::make_shared<std::atomic<pid_t>>(0);
    startQuickRobot();
    window = console(std::make_unique<ServedBus>(bus.join("can0"), sender),
                     CanSource::Mode::Transmit, [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    int judged = 0, strictly = 0;
    for (int go = 0; go < 40 && (judged < kGoes || 2 * strictly < judged) && !HasFailure(); ++go) {
        if (!drives()) continue;
        Freeze freeze;
        freeze.began = steadyNow();
        const double waited = keptWaiting(*sender);
        std::this_thread::sleep_for(1s);
        const double kept = keptWaiting(*sender) - waited;
        freeze.ended = steadyNow();
        freeze.frames = framesOf(*recorder);
        // On a busy machine a delay of 100 ms may have ended the drive before.
        const std::vector<double> drives = freeze.timesOf(FrameKind::Drive);
        if (drives.empty()) continue;
        ++judged;
        double last = 0.0;  // time of the last drive frame since the freeze began
        for (const FrameKind kind : {FrameKind::Drive, FrameKind::ConsoleHeartbeat})
            for (const double at : freeze.timesOf(kind)) last = std::max(last, at - freeze.began);
        // The sending thread may have waited for a processor between reading the clock and sending.
        EXPECT_LE(last, kLimit + kept);
        EXPECT_LE(static_cast<double>(drives.size()), kLimit / ConsoleLink::kDrivePeriod + 2.0);
        strictly += last <= kLimit;
        const std::vector<double> disarmings = freeze.timesOf(FrameKind::Arm);
        ASSERT_EQ(disarmings.size(), 1U) << "while the window stood still";
        EXPECT_GT(disarmings.front(), drives.back());
        EXPECT_TRUE(robotIs(RobotActivity::Halted));
        QTest::keyRelease(window.get(), Qt::Key_W);
        EXPECT_EQ(arming(), ArmingPhase::Disarmed);
    }
    EXPECT_GE(judged, kGoes) << "it hardly ever drove into a freeze";
    EXPECT_GE(2 * strictly, judged)
        << "later than " << kLimit << " s in most of " << judged << " goes";
}

/// Counts the wake-ups of the window's thread (queued calls), not the work of a call.
class Posts final : public QObject {
public:
    Posts() { qApp->installEventFilter(this); }
    /// Delivers the pending calls and returns their number.
    int consume()
    {
        count_ = 0;
        QCoreApplication::sendPostedEvents();
        return count_;
    }

protected:
    bool eventFilter(QObject* /*receiver*/, QEvent* event) override
    {
        if (event->type() == QEvent::MetaCall) ++count_;
        return false;
    }

private:
    int count_ = 0;
};

TEST_F(BusConsole, aFloodOfFramesIsNoFloodOfSignals)
{
    constexpr std::uint64_t kFlood = 20'000;
    open(CanSource::Mode::Listen);
    ASSERT_TRUE(eventually([&] { return !modelInUse(*window).isEmpty(); }));
    Posts posts;
    // The window's thread does nothing else while all frames are read.
    (void)posts.consume();
    const std::uint64_t before = window->link()->view().frames.received;
    for (std::uint64_t i = 0; i < kFlood; ++i)
        bus.put({.id = 0x100 + static_cast<std::uint32_t>(i % 200), .length = 8, .data = {}});
    for (const double end = steadyNow() + 60.0; steadyNow() < end;) {
        if (window->link()->view().frames.received >= before + kFlood) break;
        std::this_thread::sleep_for(1ms);
    }
    ASSERT_GE(window->link()->view().frames.received, before + kFlood);
    EXPECT_LT(posts.consume(), 20) << "for " << kFlood << " frames";
}

TEST_F(BusConsole, aFloodOfTelemetryIsNoFloodOfSignalsNorOfPictures)
{
    constexpr int kFlood = 5000;
    constexpr double kPictures = 25.0;  // [Hz]
    /// A source of some thousand telemetry lines a second, all different, as many as requested.
    struct Burst final : MeasurementSource {
        std::atomic<int> left = 1;
        std::string name() const override { return "BURST"; }
        Result<std::optional<Sample>> next(std::chrono::milliseconds) override
        {
            std::this_thread::sleep_for(50us);
            if (left.load() == 0) return std::optional<Sample>{};
            Sample sample;
            sample.measurement.pitch = 0.01 * (--left % 10);
            return std::optional(sample);
        }
        Status send(const Command&) override { return Done{}; }
    };
    MainWindow::Options options;
    options.robot = model;
    auto source = std::make_unique<Burst>();
    std::atomic<int>& left = source->left;
    options.source = std::move(source);
    options.model = [] { return Result<LoadedModel>(madeUp()); };
    window = std::make_unique<MainWindow>(std::move(options));
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return !modelInUse(*window).isEmpty() && left == 0; }));
    Posts posts;
    (void)posts.consume();
    left = kFlood;
    for (const double end = steadyNow() + 60.0; left > 0 && steadyNow() < end;)
        std::this_thread::sleep_for(1ms);
    ASSERT_EQ(left, 0);
    EXPECT_LT(posts.consume(), 20) << "for " << kFlood << " lines";

    const double began = steadyNow();
    const auto pictures = window->meter().frames().count();
    const auto lines = window->acquisition().latest()->count;
    left = std::numeric_limits<int>::max();
    QTest::qWait(1000);
    left = 0;
    EXPECT_LE(static_cast<double>(window->meter().frames().count() - pictures),
              kPictures * (steadyNow() - began) + 2.0);
    EXPECT_GT(window->acquisition().latest()->count, lines + 100);
}

TEST_F(BusConsole, disarmedRobotEndsTheExploration)
{
    open();
    ASSERT_TRUE(inSomeGo([this] { return exploresUntilAsked(); }));
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
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    QTest::keyClick(window.get(), Qt::Key_A);
    ASSERT_TRUE(reaches(AtemPhase::ProposingProbe))
        << describe(window->exploration().state().failure);
    QTest::qWait(100);
    EXPECT_EQ(window->size(), window->minimumSize()) << "the layout needs more than this";
    EXPECT_EQ(gui::cutWhenSettled(*window), std::vector<std::string>());
    picture("smallest");
}

}  // namespace
}  // namespace terratact
