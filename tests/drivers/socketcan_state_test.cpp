// States of a CAN interface: full queues, lost interfaces, and errors of the controller.
#include <gtest/gtest.h>
#include <linux/can.h>

#include <cerrno>
#include <string>
#include <thread>
#include <vector>

#include "drivers/socketcan.h"
#include "tests/drivers/fake_can_socket.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

TEST_F(OnABus, aFullQueueRefusesAndIsTriedAgainOnlyByTheCaller)
{
    kernel.writeError = ENOBUFS;
    EXPECT_NE(refusal().find("queue is full"), std::string::npos);
    EXPECT_EQ(bus->state(), BusState::Up) << "once is a hiccup";
    for (int i = 0; i < 4; ++i) {
        kernel.pass(0.02);
        EXPECT_NE(refusal(), "");
    }
    EXPECT_EQ(bus->state(), BusState::Stalled);
    kernel.writeError = 0;
    EXPECT_EQ(refusal(), "");
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(kernel.written.size(), 1u);
    EXPECT_EQ(bus->counters().notSent, 5u);
}

TEST_F(OnABus, anOldFullQueueIsForgotten)
{
    kernel.writeError = EAGAIN;
    for (int i = 0; i < 5; ++i) {
        (void)refusal();
        kernel.pass(0.02);
    }
    ASSERT_EQ(bus->state(), BusState::Stalled);
    kernel.pass(1.0);
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_NE(refusal(), "");
    EXPECT_EQ(bus->state(), BusState::Up) << "a new hiccup, not the old one going on";
}

TEST_F(OnABus, downInterfaceIsAStateAndDropsSentFrames)
{
    ASSERT_EQ(refusal(1), "");
    kernel.up = false;
    kernel.readError = ENETDOWN;
    EXPECT_EQ(receive(20ms), 0u);
    EXPECT_EQ(bus->state(), BusState::Down);
    EXPECT_NE(refusal().find("ip link set can0 up type can bitrate"), std::string::npos);
    kernel.up = true;
    EXPECT_EQ(receive(300ms), 0u);
    EXPECT_EQ(bus->state(), BusState::Up) << "no echo of before is missed";
    EXPECT_EQ(refusal(2), "");
    EXPECT_EQ(kernel.opened, 1) << "on the same socket";
}

TEST_F(OnABus, sendMayDetectADownInterface)
{
    kernel.writeError = ENETDOWN;
    kernel.up = false;
    EXPECT_NE(refusal().find("is down"), std::string::npos);
    EXPECT_EQ(bus->state(), BusState::Down);
}

TEST_F(OnABus, silentlyRemovedInterfaceIsDetected)
{
    kernel.present = false;
    (void)receive(300ms);
    EXPECT_EQ(bus->state(), BusState::Absent);
    EXPECT_EQ(kernel.closed, 1);
}

TEST_F(OnABus, anInterfaceThatComesBackIsOpenedAgainByItsName)
{
    for (const int code : {ENODEV, ENXIO}) {
        const int before = kernel.opened;
        (void)receive();
        ASSERT_EQ(refusal(1), "");
        kernel.present = false;
        if (code == ENODEV) {
            kernel.readError = code;
        } else {
            kernel.writeError = code;
            EXPECT_NE(refusal(), "");
        }
        (void)receive(50ms);
        EXPECT_EQ(bus->state(), BusState::Absent);
        EXPECT_NE(refusal().find("does not exist"), std::string::npos);
        kernel.readError = kernel.writeError = 0;
        kernel.present = true;
        (void)receive(2000ms);
        EXPECT_EQ(bus->state(), BusState::Up);
        EXPECT_EQ(kernel.opened, before + 1);
        EXPECT_EQ(kernel.closed, kernel.opened - 1);
        kernel.put(frameOfId(5));
        EXPECT_EQ(receive(), 1u);
    }
    EXPECT_EQ(bus->counters().reopened, 2u);
}

TEST_F(OnABus, lostInterfaceIsReplacedDespiteAReusedIndex)
{
    kernel.writeError = ENXIO;
    EXPECT_NE(refusal(), "");
    kernel.writeError = 0;
    (void)receive(150ms);
    EXPECT_EQ(kernel.opened, 2);
    EXPECT_EQ(bus->state(), BusState::Up);
}

TEST_F(OnABus, searchForAnAbsentInterfaceIsPaced)
{
    kernel.present = false;
    (void)receive(100ms);
    (void)receive(0ms);
    kernel.naps = kernel.reads = 0;
    const double begin = kernel.now;
    (void)receive(60'000ms);
    EXPECT_NEAR(kernel.now - begin, 60.0, 1e-9) << "patience is patience";
    EXPECT_EQ(kernel.reads, 0);
    EXPECT_LE(kernel.naps, 70);
    kernel.present = true;
    const double back = kernel.now;
    while (bus->state() != BusState::Up) (void)receive(20ms);
    EXPECT_LE(kernel.now - back, 1.1);
}

TEST_F(OnABus, downInterfaceCausesNoBusyLoop)
{
    kernel.up = false;
    (void)receive(20ms);
    kernel.reads = 0;
    const double end = kernel.now + 1.0;
    while (kernel.now < end) {
        kernel.readError = ENETDOWN;
        (void)receive(100ms);
    }
    EXPECT_LE(kernel.reads, 110);
}

TEST(SocketCan, anInterfaceThatIsNotThereYetIsWaitedFor)
{
    Kernel kernel;
    kernel.present = false;
    const auto bus = opened(kernel);
    EXPECT_EQ(bus->state(), BusState::Absent);
    kernel.present = true;
    std::array<BusFrame, 1> one{};
    ASSERT_TRUE(bus->receive(one, 1500ms));
    EXPECT_EQ(bus->state(), BusState::Up);
}

TEST_F(OnABus, unknownFaultIsAnErrorWithoutABusyLoop)
{
    kernel.readError = ENOMEM;
    const double begin = kernel.now;
    const auto count = bus->receive(frames, 100ms);
    ASSERT_FALSE(count);
    EXPECT_EQ(count.error().code, ENOMEM);
    EXPECT_GT(kernel.now, begin);
    kernel.writeError = EINTR;
    EXPECT_NE(refusal(), "") << "not sent, and not tried again";
    EXPECT_TRUE(kernel.written.empty());
    EXPECT_EQ(bus->state(), BusState::Up);
}

TEST_F(OnABus, dropsAreCountedOverReopenings)
{
    kernel.drops = 7;
    (void)receive(150ms);
    kernel.present = false;
    (void)receive(150ms);
    kernel.drops = 0;
    kernel.present = true;
    (void)receive(1500ms);
    kernel.drops = 3;
    EXPECT_EQ(bus->counters().dropped, 10u);
}

TEST_F(OnABus, theControllersErrorsAreStates)
{
    const auto say = [this](std::uint32_t classes, std::uint8_t controller) {
        kernel.put({.id = classes, .error = true, .length = 8, .data = {0, controller}});
        (void)receive();
        return bus->state();
    };
    EXPECT_EQ(say(0x004, 0x08), BusState::ErrorWarning);
    EXPECT_EQ(say(0x004, 0x40), BusState::Up) << "active again";
    EXPECT_EQ(say(0x004, 0x04), BusState::ErrorWarning);
    EXPECT_EQ(say(0x004, 0x20), BusState::ErrorPassive);
    EXPECT_EQ(refusal(1), "") << "still works";
    EXPECT_EQ(say(0x040, 0), BusState::BusOff);
    EXPECT_NE(refusal().find("type can restart"), std::string::npos);
    EXPECT_EQ(say(0x020, 0), BusState::BusOff) << "no acknowledgement says nothing new";
    kernel.pass(1.0);
    EXPECT_EQ(say(0x100, 0), BusState::Up) << "and what the controller forgot is not waited for";
    EXPECT_EQ(refusal(2), "");
    EXPECT_EQ(bus->counters().errorFrames, 7u);
}

TEST_F(OnABus, aForgedErrorChangesNothingAndIsCounted)
{
    kernel.put({.id = 0x040, .error = true, .length = 8}, true);
    EXPECT_EQ(receive(), 1u);
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(bus->counters().forgedErrors, 1u);
    EXPECT_EQ(bus->counters().errorFrames, 1u);
}

TEST_F(OnABus, settingTheInterfaceDownClearsItsErrors)
{
    kernel.put({.id = 0x040, .error = true, .length = 8});
    (void)receive();
    kernel.up = false;
    (void)receive(150ms);
    kernel.up = true;
    (void)receive(150ms);
    EXPECT_EQ(bus->state(), BusState::Up);
}

}  // namespace
}  // namespace terratact
