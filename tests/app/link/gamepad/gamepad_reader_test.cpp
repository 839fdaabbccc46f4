// Tests the thread that reads the gamepad: it sends STOP by itself, and silence is the loss of the gamepad.
#include "app/link/gamepad/gamepad_reader.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "app/runtime/steady_now.h"
#include "tests/support/devices/fake_gamepad.h"
#include "tests/support/scripted_source.h"

namespace terratact {
namespace {

struct ReadGamepad : testing::Test {
    ReadGamepad() { state.connection = 1; }
    void open(bool sends = true)
    {
        reader = std::make_unique<GamepadReader>(desk.gamepad(), source);
        reader->setStop(PadMapping(), sends);
        show();
    }
    /// Waits until the state was read.
    void show()
    {
        desk.set(state);
        const int polls = desk.polls();
        (void)eventually([&] { return desk.polls() > polls + 2; });
    }
    static bool eventually(const std::function<bool()>& condition)
    {
        for (int i = 0; i < 20000; ++i) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the reader polls, too
        }
        return false;
    }
    int stopsSent()
    {
        int count = 0;
        for (const Command& command : source.consumeCommands())
            count += std::holds_alternative<StopCommand>(command) ? 1 : 0;
        return count;
    }

    ScriptedSource source;
    GamepadDesk desk;
    GamepadState state;
    std::unique_ptr<GamepadReader> reader;
};

TEST_F(ReadGamepad, sendsStopOncePerPressAndCountsIt)
{
    open();
    state[PadButton::Back] = true;
    show();
    EXPECT_EQ(stopsSent(), 1);
    EXPECT_EQ(reader->consumeStops(), 1);
    EXPECT_EQ(reader->consumeStops(), 0);
    state[PadButton::Back] = false;
    show();
    state[PadButton::RightShoulder] = true;
    show();
    EXPECT_EQ(stopsSent(), 1);
    EXPECT_EQ(reader->consumeStops(), 1);
}

TEST_F(ReadGamepad, sendsNothingElse)
{
    open();
    for (std::size_t i = 0; i < kPadButtons; ++i)
        state.buttons.at(i) = i != static_cast<std::size_t>(PadButton::Back)
                           && i != static_cast<std::size_t>(PadButton::RightShoulder);
    state.axes = {1, -1, 1, 1, 1, 1};
    show();
    EXPECT_TRUE(source.consumeCommands().empty());
    EXPECT_EQ(reader->latest(steadyNow()).axes, state.axes);
}

TEST_F(ReadGamepad, aConsoleThatOnlyListensSendsNoStop)
{
    open(false);
    state[PadButton::Back] = true;
    show();
    EXPECT_EQ(stopsSent(), 0);
    EXPECT_EQ(reader->consumeStops(), 1) << "the window reports why it has no effect";
}

TEST_F(ReadGamepad, aGamepadThatDoesNotAnswerIsLost)
{
    open();
    EXPECT_TRUE(reader->latest(steadyNow()).isConnected());
    EXPECT_FALSE(reader->latest(steadyNow() + 1.0).isConnected()) << "an old state";
    desk.hang(true);
    EXPECT_TRUE(eventually([&] { return !reader->latest(steadyNow()).isConnected(); }));
    desk.hang(false);
    EXPECT_TRUE(eventually([&] { return reader->latest(steadyNow()).isConnected(); }));
}

TEST_F(ReadGamepad, aGamepadThatThrowsIsLostAndSaysWhy)
{
    open();
    desk.breakDown();
    ASSERT_TRUE(eventually([&] { return !reader->latest(steadyNow()).isConnected(); }));
    EXPECT_EQ(reader->latest(steadyNow()).trouble.english(), "the gamepad is on fire");
}

}  // namespace
}  // namespace terratact
