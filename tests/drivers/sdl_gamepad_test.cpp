// Tests the gamepad driver with virtual joysticks of SDL, and with a device of the kernel where uinput exists.
#include "drivers/sdl_gamepad.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/uinput.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <memory>

#include "tests/support/devices/virtual_pad.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

struct SdlGamepads : testing::Test {
    GamepadState poll() { return gamepads->poll(0ms); }
    std::unique_ptr<Gamepad> gamepads = openSdlGamepad();
};

TEST_F(SdlGamepads, reportNothingWithoutADevice)
{
    const GamepadState state = poll();
    EXPECT_FALSE(state.isConnected());
    EXPECT_TRUE(state.trouble.empty()) << state.trouble.english();
}

TEST_F(SdlGamepads, reportEveryAxisAndButton)
{
    VirtualPad pad("Rescue pad");
    EXPECT_EQ(poll().name, "Rescue pad");
    EXPECT_FALSE(poll().radio);
    for (std::size_t i = 0; i < kPadAxes; ++i) {
        const auto axis = static_cast<PadAxis>(i);
        for (const double value : {1.0, 0.25, 0.0}) {
            pad.set(axis, value);
            EXPECT_NEAR(poll()[axis], value, 1e-3) << name(axis);
        }
    }
    pad.set(PadAxis::LeftY, -1.0);
    EXPECT_DOUBLE_EQ(poll()[PadAxis::LeftY], -1.0);
    for (std::size_t i = 0; i < kPadButtons; ++i) {
        const auto button = static_cast<PadButton>(i);
        pad.set(button, true);
        const GamepadState state = poll();
        for (std::size_t k = 0; k < kPadButtons; ++k)
            EXPECT_EQ(state.buttons.at(k), k == i) << name(static_cast<PadButton>(k));
        pad.set(button, false);
    }
}

TEST_F(SdlGamepads, aLostPadIsOneWithoutAnyControl)
{
    auto pad = std::make_unique<VirtualPad>();
    pad->set(PadAxis::RightTrigger, 1.0);
    pad->set(PadButton::A, true);
    EXPECT_EQ(poll().connection, 1U);
    EXPECT_GT(poll()[PadAxis::RightTrigger], 0.9);
    pad->detach();
    const GamepadState lost = poll();
    EXPECT_FALSE(lost.isConnected());
    EXPECT_EQ(lost[PadAxis::RightTrigger], 0.0);
    EXPECT_FALSE(lost[PadButton::A]);
    const VirtualPad again;
    EXPECT_EQ(poll().connection, 2U) << "another connection, so held controls do not go on";
}

TEST_F(SdlGamepads, readTheFirstUntilItIsLost)
{
    auto first = std::make_unique<VirtualPad>("First");
    EXPECT_EQ(poll().name, "First");
    const VirtualPad second("Second");
    EXPECT_EQ(poll().name, "First");
    first->detach();
    EXPECT_EQ(poll().name, "Second");
}

TEST_F(SdlGamepads, aJoystickWithoutALayoutIsNamed)
{
    const VirtualPad odd("Odd stick", VirtualPad::Kind::UnknownJoystick);
    const GamepadState state = poll();
    EXPECT_FALSE(state.isConnected());
    EXPECT_EQ(state.trouble.english(),
              "“Odd stick” is not used, because SDL knows no layout of it: set "
              "SDL_GAMECONTROLLERCONFIG, or use another gamepad");
    const VirtualPad good("Good pad");
    EXPECT_EQ(poll().name, "Good pad");
    EXPECT_TRUE(poll().trouble.empty());
}

TEST_F(SdlGamepads, leaveTheSignalsToTheProgram)
{
    poll();
    for (const int signal : {SIGINT, SIGTERM}) {
        struct sigaction now {};
        ASSERT_EQ(sigaction(signal, nullptr, &now), 0);
        EXPECT_EQ(now.sa_handler, SIG_DFL) << signal;
    }
}

/// A gamepad of the kernel, as a USB or Bluetooth device would be.
class KernelPad {
public:
    KernelPad(int file, std::uint16_t bus) : file_(file)
    {
        ioctl(file_, UI_SET_EVBIT, EV_KEY);
        ioctl(file_, UI_SET_EVBIT, EV_ABS);
        for (const int key : {BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT,
                              BTN_START, BTN_MODE, BTN_THUMBL, BTN_THUMBR})
            ioctl(file_, UI_SET_KEYBIT, key);
        for (const int axis : {ABS_X, ABS_Y, ABS_RX, ABS_RY, ABS_Z, ABS_RZ, ABS_HAT0X, ABS_HAT0Y}) {
            uinput_abs_setup setup{};
            setup.code = static_cast<std::uint16_t>(axis);
            const bool isTrigger = axis == ABS_Z || axis == ABS_RZ;
            const bool isHat = axis == ABS_HAT0X || axis == ABS_HAT0Y;
            setup.absinfo.minimum = isTrigger ? 0 : isHat ? -1 : -32768;
            setup.absinfo.maximum = isTrigger ? 255 : isHat ? 1 : 32767;
            ioctl(file_, UI_ABS_SETUP, &setup);
        }
        uinput_setup setup{};
        setup.id = {.bustype = bus, .vendor = 0x045e, .product = 0x028e, .version = 0x0114};
        std::strcpy(setup.name, "Microsoft X-Box 360 pad");
        ioctl(file_, UI_DEV_SETUP, &setup);
        ioctl(file_, UI_DEV_CREATE);
    }
    KernelPad(const KernelPad&) = delete;
    KernelPad& operator=(const KernelPad&) = delete;
    ~KernelPad()
    {
        ioctl(file_, UI_DEV_DESTROY);
        ::close(file_);
    }
    void send(std::uint16_t type, std::uint16_t code, int value) const
    {
        for (const input_event& event :
             {input_event{.time = {}, .type = type, .code = code, .value = value},
              input_event{.time = {}, .type = EV_SYN, .code = SYN_REPORT, .value = 0}})
            ASSERT_EQ(::write(file_, &event, sizeof event), static_cast<ssize_t>(sizeof event));
    }

private:
    int file_;
};

TEST_F(SdlGamepads, readADeviceOfTheKernelAndNoticeItsLoss)
{
    for (const auto& [bus, radio] : {std::pair{BUS_USB, false}, std::pair{BUS_BLUETOOTH, true}}) {
        const int file = ::open("/dev/uinput", O_WRONLY | O_NONBLOCK);
        if (file < 0) GTEST_SKIP() << "no /dev/uinput here";
        auto pad = std::make_unique<KernelPad>(file, static_cast<std::uint16_t>(bus));
        const auto eventually = [&](const auto& condition) {
            for (int i = 0; i < 1000; ++i)
                if (condition(gamepads->poll(5ms))) return true;
            return false;
        };
        ASSERT_TRUE(eventually([](const GamepadState& s) { return s.isConnected(); }));
        EXPECT_EQ(poll().radio, radio);
        pad->send(EV_ABS, ABS_RZ, 255);
        pad->send(EV_ABS, ABS_Y, -32768);
        pad->send(EV_KEY, BTN_TR, 1);
        EXPECT_TRUE(eventually([](const GamepadState& s) {
            return s[PadAxis::RightTrigger] > 0.99 && s[PadAxis::LeftY] < -0.99
                && s[PadButton::RightShoulder];
        }));
        pad.reset();
        EXPECT_TRUE(eventually([](const GamepadState& s) { return !s.isConnected(); }));
    }
}

}  // namespace
}  // namespace terratact
