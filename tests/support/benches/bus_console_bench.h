#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "app/shell/key_table.h"
#include "core/wire/logs/candump_log.h"
#include "drivers/log_replay.h"
#include "tests/support/benches/arming.h"
#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/benches/staged_robot.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/held_button.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/force_bars.h"

namespace terratact {

inline LoadedModel madeUp()
{
    return {.estimate =
                [](const EstimateRequest& request, const Watch&) {
                    TerrainEstimate e = request.arm.empty() ? stepEstimate() : probedEstimate();
                    e.settings = request.settings;
                    return equalSides(e);
                },
            .name = "fake.ttm",
            .details = {}};
}

/// Collects every estimate of the explorations, newest last.
class Estimates {
public:
    explicit Estimates(Exploration& exploration)
    {
        QObject::connect(&exploration, &Exploration::happened, [this, &exploration] {
            const auto& now = exploration.estimation().estimate();
            if (now && (all_.empty() || all_.back() != *now)) all_.push_back(*now);
        });
    }
    const std::vector<TwoTrackEstimate>& all() const { return all_; }

private:
    std::vector<TwoTrackEstimate> all_;
};

/// Returns all frames that a bus end has received since the last call.
inline std::vector<BusFrame> framesOf(CanBus& end)
{
    std::vector<BusFrame> all;
    std::array<BusFrame, 64> frames;
    for (;;) {
        const auto count = end.receive(frames, std::chrono::milliseconds(0));
        if (!count || *count == 0) return all;
        all.insert(all.end(), frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(*count));
    }
}

/// Returns these frames in the format of candump -L.
inline std::string candumpOf(CanBus& end)
{
    std::string log;
    for (const BusFrame& heard : framesOf(end))
        log += candumpLine(heard.time, "can0", heard.frame) + "\n";
    return log;
}

/// The console and a robot in this process at the other end of a bus.
struct BusConsole : testing::Test, RobotOnBench {
    static void SetUpTestSuite()
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
    }
    void open(CanSource::Mode mode = CanSource::Mode::Transmit, RobotFault fault = RobotFault::None)
    {
        startQuickRobot(fault);
        openOn(mode);
    }
    /// Starts a fast robot with staged telemetry.
    StagedRobot stagedRobot()
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 2.0;
        return {bus, model, SimulatedRobot(model, demoTerrain(), simulation),
                RobotOnBus::Options{.firstEpoch = 9, .speed = 10.0}, time()};
    }
    /// Opens the console on the present robot.
    void openOn(CanSource::Mode mode = CanSource::Mode::Transmit)
    {
        window = console(bus.join("can0"), mode, [] { return Result<LoadedModel>(madeUp()); });
        gui::showActive(*window);
    }
    /// Opens a console with an estimator that is always CLEAR, and a robot on level ground behind the gate.
    void openClear()
    {
        SimulatedRobot::Options simulation;
        simulation.startX = 1.0;
        robot = std::make_unique<RobotInProcess>(
            bus, model, SimulatedRobot(model, flatTerrain(9.0), simulation),
            RobotOnBus::Options{.firstEpoch = 9, .speed = 5.0}, time());
        window = console(bus.join("can0"), CanSource::Mode::Transmit, [] {
            LoadedModel clear = madeUp();
            clear.estimate = [](const EstimateRequest& request, const Watch&) {
                TerrainEstimate e = clearEstimate();
                e.settings = request.settings;
                return equalSides(e);
            };
            return Result<LoadedModel>(std::move(clear));
        });
        gui::showActive(*window);
    }
    /// Opens the console and records the session below `folder`.
    void openRecordedOn(const TemporaryDirectory& folder)
    {
        recording = std::make_shared<SessionRecorder>(SessionRecorder::Options{
            .folder = folder.file("sessions"), .start = someStart(), .patience = kBusyDisk});
        openOn();
    }
    void startQuickRobot(RobotFault fault = RobotFault::None)
    {
        startRobot({.firstEpoch = 9, .speed = 10.0, .fault = fault});
    }
    std::unique_ptr<MainWindow> console(std::unique_ptr<CanBus> end, CanSource::Mode mode,
                                        ModelLoader loader)
    {
        CanSource::Options source{.mode = mode, .waits = mode == CanSource::Mode::Replay};
        if (recording) source.received = [to = recording](auto frames) { to->add(frames); };
        LogReplay* const log = dynamic_cast<LogReplay*>(end.get());
        MainWindow::Options options = linked(std::move(end), std::move(source));
        if (hasReplayBar) options.replay = log;
        options.model = std::move(loader);
        options.recorder = recording;
        if (gamepads) options.gamepad = gamepads();
        options.exploration.driveSpeed = 0.02;
        options.exploration.settings.probeAbove =
            0.005;  // the low threshold always proposes a probe
        auto made = std::make_unique<MainWindow>(std::move(options));
        made->header()->arming()->confirmButton()->setHoldTime(150);
        made->probeCard()->approveButton()->setHoldTime(150);
        made->resize(1280, 720);
        return made;
    }
    /// Saves a picture of the window if TERRATACT_PICTURES is set.
    void picture(const QString& name)
    {
        const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
        if (!folder.isEmpty()) window->grab().save(folder + "/" + name + ".png");
    }
    /// Returns the model's name; empty before it is loaded.
    static QString modelInUse(MainWindow& console)
    {
        return console.exploration().estimation().model().name;
    }
    bool says(const QString& words) const
    {
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
    ArmingPhase arming() const { return armingOf(*window); }
    void arm() { ASSERT_TRUE(arms(*window)); }
    bool armsOnce()
    {
        return terratact::armsOnce(*window, [this] { picture("arming-asks"); });
    }
    /// Arms and drives with key W held; false if something disarmed the console meanwhile.
    bool drives()
    {
        QTest::keyRelease(window.get(), Qt::Key_W);
        QTest::qWait(2 * KeyTable::kRepetition);  // the next press is a new one
        if (!arms(*window)) return false;
        if (!gui::eventually([&] { return window->drivePad()->forwardButton()->isEnabled(); },
                             2000))
            return false;
        QTest::keyPress(window.get(), Qt::Key_W);
        (void)gui::eventually(
            [&] { return arming() != ArmingPhase::Armed || robotDoes(RobotActivity::Driving); });
        return arming() == ArmingPhase::Armed && robotDoes(RobotActivity::Driving);
    }
    /// Waits for the phase; returns false, and fails the test with the reason, if the exploration fails instead.
    bool gets(AtemPhase phase) const
    {
        const AtemState& state = window->exploration().state();
        (void)gui::eventually(
            [&] { return state.phase == phase || state.phase == AtemPhase::Failed; }, 60000);
        EXPECT_EQ(describe(state.phase).english, describe(phase).english)
            << describe(state.failure).english;
        return state.phase == phase;
    }
    /// Explores by keys until a probe is proposed.
    bool exploresUntilAsked()
    {
        if (!arms(*window)) return false;
        if (!gui::eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }))
            return false;
        QTest::keyClick(window.get(), Qt::Key_A);
        return gets(AtemPhase::ProposingProbe)
            && gui::eventually([&] { return window->probeCard()->shown().has_value(); });
    }
    /// Explores by keys, approves the probe and waits for its end.
    bool exploresAndProbes()
    {
        if (!exploresUntilAsked()) return false;
        picture("asks-for-a-probe");
        QTest::keyPress(window.get(), Qt::Key_Space);
        const bool presents = gets(AtemPhase::Presenting);
        QTest::keyRelease(window.get(), Qt::Key_Space);
        return presents;
    }
    bool robotDoes(RobotActivity activity) const
    {
        const auto latest = window->acquisition().latest();
        return latest && latest->sample.measurement.activity == activity;
    }
    bool robotIs(RobotActivity activity)
    {
        return gui::eventually([&] { return robotDoes(activity); });
    }
    bool reaches(AtemPhase phase)
    {
        return gui::eventually([&] { return window->exploration().state().phase == phase; }, 60000);
    }

    std::function<std::unique_ptr<Gamepad>()> gamepads{};  // empty: none is read
    std::shared_ptr<SessionRecorder> recording{};          // used by consoles that are opened later
    bool hasReplayBar = false;  // of consoles that are opened later and replay a log
    std::unique_ptr<MainWindow> window;
};

}  // namespace terratact
