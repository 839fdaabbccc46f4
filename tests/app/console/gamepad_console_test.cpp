// Tests the gamepad at the console: it acts by the window's own buttons, and whatever ends a hold lets go.
#include <gtest/gtest.h>

#include <QMenu>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "app/console/main_window.h"
#include "drivers/sdl_gamepad.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/devices/fake_gamepad.h"
#include "tests/support/devices/virtual_pad.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

using gui::eventually;

/// Counts how often a gamepad was read.
class CountedGamepad final : public Gamepad {
public:
    CountedGamepad(std::unique_ptr<Gamepad> gamepad, std::shared_ptr<std::atomic<int>> reads)
        : gamepad_(std::move(gamepad)), reads_(std::move(reads))
    {
    }
    GamepadState poll(std::chrono::milliseconds pause) override
    {
        GamepadState state = gamepad_->poll(pause);
        ++*reads_;
        return state;
    }

private:
    std::unique_ptr<Gamepad> gamepad_;
    std::shared_ptr<std::atomic<int>> reads_;
};

/// A console with a scripted robot and a virtual joystick of SDL.
struct GamepadConsole : BusConsole {
    void openScripted(std::unique_ptr<Gamepad> gamepad)
    {
        auto source = std::make_unique<ScriptedSource>();
        script = source.get();
        MainWindow::Options options;
        options.robot = model;
        options.source = std::move(source);
        options.model = [] { return Result<LoadedModel>(madeUp()); };
        options.exploration.linkLostAfter = options.exploration.staleAfter = 3.0;
        options.gamepad = std::move(gamepad);
        options.inputClock = time();
        window = std::make_unique<MainWindow>(std::move(options));
        window->probeCard()->approveButton()->setHoldTime(150);
        window->resize(1280, 720);
        gui::showActive(*window);
        ASSERT_TRUE(eventually([&] { return forward()->isEnabled(); }));
    }
    void openScripted()
    {
        openScripted(sdlPad());
        ASSERT_TRUE(eventually([&] { return hasEvent("gamepad connected: Test pad"); }));
    }
    HeldButton* forward() const { return window->drivePad()->forwardButton(); }
    HeldButton* back() const { return window->drivePad()->backButton(); }
    bool hasEvent(const QString& words) const
    {
        return !window->events()->findItems(words, Qt::MatchContains).empty();
    }
    std::unique_ptr<Gamepad> sdlPad() const
    {
        return std::make_unique<CountedGamepad>(openSdlGamepad(), reads);
    }
    /// Waits until the console has read the present state of the pad, and the window has polled.
    void settle() const
    {
        const int seen = *reads;
        (void)eventually([&] { return *reads >= seen + 3; },
                         1000);  // a gamepad that hangs is not read
        for (int look = 0; look < 3; ++look) QTest::qWait(20);
    }
    void deadMan(bool held) { pad->set(PadAxis::RightTrigger, held ? 1.0 : 0.0); }
    void push(double forward) { pad->set(PadAxis::LeftY, -forward); }
    /// Holds the dead-man, then pushes the stick.
    void holdsThenPushes()
    {
        push(0.0);
        deadMan(false);
        settle();
        deadMan(true);
        settle();
        push(1.0);
    }
    bool drives()
    {
        holdsThenPushes();
        return eventually([&] { return forward()->isHeld(); }, 3000);
    }
    /// Returns true if the robot got a halt command and the held pad drives no more.
    bool haltsForGood()
    {
        if (!eventually([&] { return !forward()->isHeld(); }, 3000)) return false;
        return eventually([&] { return sent<HaltCommand>() > 0; }, 3000) && drivesNothing();
    }
    bool drivesNothing()
    {
        settle();
        (void)sent<DriveCommand>();
        commands.clear();
        QTest::qWait(150);  // waits for an event that must not come
        return sent<DriveCommand>() == 0 && !forward()->isHeld();
    }
    template <class C>
    int sent()
    {
        for (const Command& command : script->consumeCommands()) commands.push_back(command);
        return static_cast<int>(std::ranges::count_if(
            commands, [](const Command& c) { return std::holds_alternative<C>(c); }));
    }
    double lastSpeed()
    {
        (void)sent<DriveCommand>();
        double speed = 0.0;
        for (const Command& command : commands)
            if (const auto* drive = std::get_if<DriveCommand>(&command)) speed = drive->speed;
        return speed;
    }
    void tap(PadButton button)
    {
        pad->set(button, true);
        settle();
        pad->set(button, false);
        settle();
    }

    std::unique_ptr<VirtualPad> pad = std::make_unique<VirtualPad>();
    std::shared_ptr<std::atomic<int>> reads = std::make_shared<std::atomic<int>>(0);
    ScriptedSource* script = nullptr;
    std::vector<Command> commands;
};

TEST_F(GamepadConsole, drivesAtTheSpeedOfTheStickWhileTheDeadManIsHeld)
{
    ASSERT_NO_FATAL_FAILURE(openScripted());
    push(1.0);
    ASSERT_TRUE(drivesNothing()) << "the stick alone";
    ASSERT_TRUE(drives());
    EXPECT_DOUBLE_EQ(lastSpeed(), 0.2);
    push(0.575);
    EXPECT_TRUE(eventually([&] { return lastSpeed() == 0.1; }, 3000)) << lastSpeed();
    EXPECT_EQ(sent<HaltCommand>(), 0);
    push(-1.0);
    EXPECT_TRUE(eventually([&] { return back()->isHeld(); }, 3000));
    EXPECT_TRUE(eventually([&] { return lastSpeed() == -0.2; }, 3000)) << lastSpeed();
    EXPECT_EQ(sent<HaltCommand>(), 1) << "before it turns round";
    EXPECT_FALSE(forward()->isHeld());
    deadMan(false);
    EXPECT_TRUE(eventually([&] { return sent<HaltCommand>() == 2; }, 3000));
    EXPECT_FALSE(back()->isHeld());
    QTest::keyPress(window.get(), Qt::Key_W);
    EXPECT_TRUE(
        eventually([&] { return lastSpeed() == window->exploration().options().driveSpeed; }));
    QTest::keyRelease(window.get(), Qt::Key_W);
}

TEST_F(GamepadConsole, theLossOfThePadLetsGo)
{
    ASSERT_NO_FATAL_FAILURE(openScripted());
    ASSERT_TRUE(drives());
    pad->detach();
    EXPECT_TRUE(haltsForGood());
    EXPECT_TRUE(hasEvent("gamepad lost: all its controls are released"));
    pad = std::make_unique<VirtualPad>("Other pad");
    EXPECT_TRUE(eventually([&] { return hasEvent("gamepad connected: Other pad"); }));
    EXPECT_TRUE(drives());
}

TEST_F(GamepadConsole, whateverLeavesTheWindowLetsGoUntilTheNextPress)
{
    ASSERT_NO_FATAL_FAILURE(openScripted());
    QWidget other;
    QMenu menu(window.get());
    menu.addAction("an entry");  // Qt 6.8 shows no empty menu
    const auto freeze = [this] {
        clock.leave();
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
        while (std::chrono::steady_clock::now() < end) continue;
    };
    const std::vector<std::pair<const char*, std::function<void()>>> leaving{
        {"another window",
         [&] {
             gui::showActive(other);
             EXPECT_TRUE(haltsForGood());
             other.close();
             gui::showActive(*window);
         }},
        {"another page",
         [&] {
             QTest::keyClick(window.get(), Qt::Key_F3);
             EXPECT_TRUE(haltsForGood());
             QTest::keyClick(window.get(), Qt::Key_F2);
         }},
        {"the gamepad's page",
         [&] {
             QTest::keyClick(window.get(), Qt::Key_F10);
             EXPECT_TRUE(haltsForGood());
             QTest::keyClick(window.get(), Qt::Key_F2);
         }},
        {"a menu",
         [&] {
             menu.popup(window->mapToGlobal(QPoint(10, 10)));
             EXPECT_TRUE(haltsForGood());
             menu.close();
         }},
        {"a freeze", freeze},
        {"another control", [&] { forward()->letGo(); }}};
    for (const auto& [name, leave] : leaving) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(drives());
        commands.clear();
        leave();
        EXPECT_TRUE(eventually([&] { return !forward()->isHeld(); }, 3000));
        EXPECT_TRUE(drivesNothing()) << "still held";
        push(0.0);
        settle();
        push(1.0);
        EXPECT_TRUE(drivesNothing()) << "the dead-man control was not released";
    }
    EXPECT_TRUE(drives());
}

TEST_F(GamepadConsole, whatIsHeldWhenThePadAppearsMeansNothing)
{
    GamepadDesk desk;
    ASSERT_NO_FATAL_FAILURE(openScripted(std::make_unique<CountedGamepad>(desk.gamepad(), reads)));
    GamepadState held;
    held.connection = 1;
    held.name = "Held pad";
    held[PadAxis::RightTrigger] = 1.0;
    held[PadAxis::LeftY] = -1.0;
    held[PadButton::Back] = held[PadButton::X] = true;
    desk.set(held);
    ASSERT_TRUE(eventually([&] { return hasEvent("gamepad connected: Held pad"); }));
    EXPECT_TRUE(drivesNothing());
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle) << "neither STOP nor explore";
    held[PadAxis::RightTrigger] = held[PadAxis::LeftY] = 0.0;
    desk.set(held);
    settle();
    held[PadAxis::RightTrigger] = 1.0;
    desk.set(held);
    settle();
    held[PadAxis::LeftY] = -1.0;
    desk.set(held);
    EXPECT_TRUE(eventually([&] { return forward()->isHeld(); }, 3000));
    desk.hang(true);
    EXPECT_TRUE(haltsForGood()) << "a gamepad that does not answer is lost";
    desk.hang(false);
    EXPECT_TRUE(drivesNothing());
    window.reset();
}

TEST_F(GamepadConsole, anUnmetPreconditionIsShown)
{
    ASSERT_NO_FATAL_FAILURE(openScripted());
    QTest::keyClick(window.get(), Qt::Key_F3);
    settle();  // a control counts once it was seen at rest
    push(1.0);
    deadMan(true);
    EXPECT_TRUE(eventually([&] { return hasEvent("hold the dead-man control first"); }));
    holdsThenPushes();
    EXPECT_TRUE(eventually([&] { return hasEvent("it is done on the page Terrain (F2)"); }));
    EXPECT_TRUE(drivesNothing());
}

TEST_F(GamepadConsole, theStepLimitChangesByOneStepPerPress)
{
    ASSERT_NO_FATAL_FAILURE(openScripted());
    const auto limit = [&] { return window->exploration().options().stepLimit; };
    const double before = limit();
    settle();  // a control counts once it was seen at rest
    pad->set(PadButton::Up, true);
    EXPECT_TRUE(eventually([&] { return limit() > before; }));
    pad->set(PadButton::Up, false);
    settle();
    EXPECT_NEAR(limit(), before + 0.01, 1e-9) << "one step, however long it is pressed";
    pad->set(PadButton::Down, true);
    EXPECT_TRUE(eventually([&] { return limit() < before + 0.005; }));
    pad->set(PadButton::Down, false);
    settle();
    EXPECT_DOUBLE_EQ(limit(), before);
}

/// The same gamepad with a robot behind the command gate.
struct GamepadThroughTheGate : GamepadConsole {
    void open()
    {
        gamepads = [this] { return sdlPad(); };
        BusConsole::open();
        ASSERT_TRUE(eventually([&] { return hasEvent("gamepad connected: Test pad"); }));
    }
    /// Arms by the keyboard; explores by the gamepad until a probe is proposed.
    bool asks()
    {
        if (!arms(*window)) return false;
        if (!eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }, 5000))
            return false;
        tap(PadButton::X);
        return gets(AtemPhase::ProposingProbe)
            && eventually([&] { return window->probeCard()->shown().has_value(); });
    }
    /// Arms by the keyboard; drives by the gamepad.
    bool drives()
    {
        return arms(*window) && eventually([&] { return forward()->isEnabled(); })
            && GamepadConsole::drives() && robotIs(RobotActivity::Driving);
    }
    AtemPhase phase() const { return window->exploration().state().phase; }
};

TEST_F(GamepadThroughTheGate, drivesOnlyWhileArmed)
{
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(eventually([&] {
        const auto why = window->exploration().whyNotDriving();
        return why && why->english().starts_with("not armed");
    }));
    holdsThenPushes();
    EXPECT_TRUE(eventually([&] { return hasEvent("not driven: not armed"); }));
    EXPECT_FALSE(robotDoes(RobotActivity::Driving));
    EXPECT_TRUE(drives());
    deadMan(false);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(GamepadThroughTheGate, theLossOfThePadHaltsTheRobot)
{
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(drives());
    pad->detach();
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
    EXPECT_EQ(arming(), ArmingPhase::Armed);
}

TEST_F(GamepadThroughTheGate, stopActsUnarmedInAnyWindowAndOnAnyPage)
{
    ASSERT_NO_FATAL_FAILURE(open());
    QWidget other;
    const std::vector<std::pair<const char*, std::function<void()>>> places{
        {"its window", [] {}},
        {"the gamepad's page", [&] { QTest::keyClick(window.get(), Qt::Key_F10); }},
        {"another window", [&] { gui::showActive(other); }}};
    for (const auto& [name, go] : places)
        for (const PadButton button : {PadButton::RightShoulder, PadButton::Back}) {
            SCOPED_TRACE(name);
            EXPECT_EQ(arming(), ArmingPhase::Disarmed);
            go();
            tap(button);
            EXPECT_TRUE(robotIs(RobotActivity::Stopped));
            EXPECT_TRUE(reaches(AtemPhase::Stopped));
            EXPECT_TRUE(hasEvent("STOP pressed on the gamepad"));
            window->exploration().releaseStop();
            EXPECT_TRUE(reaches(AtemPhase::Idle));
            EXPECT_TRUE(robotIs(RobotActivity::Halted));
        }
}

TEST_F(GamepadThroughTheGate, stopDoesNotWaitForAFrozenWindow)
{
    ASSERT_NO_FATAL_FAILURE(open());
    pad->set(PadButton::Back, true);
    clock.leave();  // no event of the window is handled here
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!robotDoes(RobotActivity::Stopped) && std::chrono::steady_clock::now() < end) continue;
    EXPECT_TRUE(robotDoes(RobotActivity::Stopped));
}

TEST_F(GamepadThroughTheGate, aProbeIsApprovedByAHoldAndAReleaseCancels)
{
    ASSERT_NO_FATAL_FAILURE(open());
    HoldToConfirmButton& approve = *window->probeCard()->approveButton();
    pad->set(PadButton::A, true);  // pressed before the question: it approves nothing
    ASSERT_TRUE(asks());
    settle();
    EXPECT_FALSE(approve.isHeld());
    pad->set(PadButton::A, false);
    settle();
    approve.setHoldTime(60'000);
    pad->set(PadButton::A, true);
    EXPECT_TRUE(eventually([&] { return approve.share() > 0.0; }, 3000));
    pad->set(PadButton::A, false);
    EXPECT_TRUE(eventually([&] { return !approve.isHeld(); }, 3000));
    ASSERT_EQ(phase(), AtemPhase::ProposingProbe);
    approve.setHoldTime(150);
    pad->set(PadButton::A, true);
    EXPECT_TRUE(gets(AtemPhase::Presenting));
    EXPECT_TRUE(window->exploration().state().probed);
}

TEST_F(GamepadThroughTheGate, aProbeIsRefusedByAPress)
{
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(asks());
    tap(PadButton::B);
    ASSERT_TRUE(gets(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(GamepadThroughTheGate, feelsForwardWhileItsTriggerIsHeld)
{
    gamepads = [this] { return sdlPad(); };
    openClear();
    const auto loops = [&] { return window->exploration().state().loops; };
    ASSERT_TRUE(arms(*window));
    ASSERT_TRUE(eventually([&] { return window->drivePad()->feelButton()->isEnabled(); }));
    pad->set(PadAxis::LeftTrigger, 1.0);
    ASSERT_TRUE(eventually([&] { return loops(); }));
    ASSERT_TRUE(
        eventually([&] { return !loops() || window->exploration().pace().way > 0.05; }, 60000));
    ASSERT_TRUE(loops());
    pad->set(PadAxis::LeftTrigger, 0.0);
    EXPECT_TRUE(eventually([&] { return !loops(); }, 3000));
    EXPECT_EQ(window->exploration().state().loopEnd, LoopEnd::LetGo);
}

}  // namespace
}  // namespace terratact
