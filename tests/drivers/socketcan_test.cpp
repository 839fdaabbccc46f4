// Names, options and times of a CAN interface.
#include "drivers/socketcan.h"

#include <gtest/gtest.h>
#include <linux/can.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/drivers/fake_can_socket.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

TEST(InterfaceName, isShortAndPlain)
{
    for (const char* good : {"can0", "vcan1", "slcan-front", "a", "CAN_1.2", "fifteen-letters"})
        EXPECT_TRUE(checkInterfaceName(good)) << good;
    for (const std::string& bad :
         {std::string(), std::string("sixteen-letters!"), std::string(16, 'a'),
          std::string(4000, 'a'), std::string("can 0"), std::string("can0;reboot"),
          std::string("../can0"), std::string("can0\n"), std::string("can\0x", 5),
          std::string("кан0"), std::string("."), std::string("..")}) {
        const Status checked = checkInterfaceName(bad);
        ASSERT_FALSE(checked) << bad;
        EXPECT_NE(checked.error().text.find("can0"), std::string::npos);
        EXPECT_LT(checked.error().text.size(), 250u);
        for (const char c : checked.error().text)
            EXPECT_FALSE(c >= 0 && c < ' ') << "nothing that a terminal obeys";
    }
}

TEST(SocketCan, refusesABadNameWithoutTheKernel)
{
    Kernel kernel;
    EXPECT_FALSE(SocketCan::open({.interface = "can0/../x"}, systemOf(kernel)));
    EXPECT_EQ(kernel.opened, 0);
}

TEST(SocketCan, aKernelWithoutCanIsAnError)
{
    Kernel kernel;
    kernel.noSocket = EAFNOSUPPORT;
    const auto bus = SocketCan::open({.interface = "can0"}, systemOf(kernel));
    ASSERT_FALSE(bus);
    EXPECT_EQ(bus.error().code, EAFNOSUPPORT);
}

TEST(SocketCan, invalidOptionsThrow)
{
    Kernel kernel;
    EXPECT_THROW(
        (void)SocketCan::open({.interface = "can0", .stalledAfter = 0.0}, systemOf(kernel)),
        std::invalid_argument);
    EXPECT_THROW((void)SocketCan::open({.interface = "can0", .receiveBuffer = 0}, systemOf(kernel)),
                 std::invalid_argument);
}

TEST(SocketCan, isReceiveOnlyByDefault)
{
    Kernel kernel;
    const auto bus = opened(kernel, {});
    const Status sent = bus->send(frameOfId(1));
    ASSERT_FALSE(sent);
    EXPECT_NE(sent.error().text.find("receive only"), std::string::npos) << sent.error().text;
    EXPECT_TRUE(kernel.written.empty());
    EXPECT_EQ(bus->counters().notSent, 1u);
}

TEST(SocketCan, warnsOfASmallBufferAndNamesTheCommand)
{
    Kernel kernel;
    EXPECT_EQ(opened(kernel)->warning(), "");
    kernel.buffer = 425'984;
    EXPECT_NE(opened(kernel)->warning().find("sysctl -w net.core.rmem_max=4194304"),
              std::string::npos);
}

TEST_F(OnABus, framesThatNoControllerSendsThrow)
{
    EXPECT_THROW((void)bus->send({.id = 0x800}), std::invalid_argument);
    EXPECT_THROW((void)bus->send({.id = 0x20000000, .extended = true}), std::invalid_argument);
    EXPECT_THROW((void)bus->send({.id = 1, .error = true}), std::invalid_argument);
    EXPECT_THROW((void)bus->send({.id = 1, .fd = true}), std::invalid_argument);
    EXPECT_THROW((void)bus->send({.id = 1, .length = 9}), std::invalid_argument);
    EXPECT_THROW((void)bus->receive({}, 0ms), std::invalid_argument);
}

TEST_F(OnABus, aFramesTimeIsWhenTheKernelGotIt)
{
    (void)receive();
    kernel.put(frameOfId(1));
    kernel.pass(0.25);  // before anybody reads it
    ASSERT_EQ(receive(), 1u);
    EXPECT_NEAR(frames[0].time, 100.0, 1e-6);
    EXPECT_NEAR(frames[0].wallTime, 5000.0, 1e-6);
}

TEST_F(OnABus, clockStepDoesNotChangeAFramesAge)
{
    kernel.pass(5.0);
    (void)receive();
    const double quiet = kernel.now;
    kernel.put(frameOfId(1));
    kernel.wall += 86'400.0;
    ASSERT_EQ(receive(), 1u);
    EXPECT_GE(frames[0].time, quiet) << "no older than the moment when nothing was there";
    kernel.put(frameOfId(2));
    kernel.wall -= 3'600.0;
    ASSERT_EQ(receive(), 1u);
    EXPECT_LE(frames[0].time, kernel.now);
}

TEST(SocketCan, sendsWhileAnotherThreadReceives)
{
    std::array<int, 2> ends{};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()), 0);
    const PosixFd other(ends[0]);
    SocketCan::System system;
    system.openSocket = [fd = ends[1]] { return canSocketOn(PosixFd(fd), "lo"); };
    system.steadyTime = system.wallTime = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    };
    system.sleep = [](double) {};
    const auto opened = SocketCan::open(
        {.interface = "can0", .transmit = true, .maxUnconfirmed = 0, .stalledAfter = 60.0}, system);
    ASSERT_TRUE(opened);
    SocketCan& bus = **opened;

    std::jthread sender([&bus] {
        for (std::uint32_t i = 0; i < 200;) i += bus.send(frameOfId(i)) ? 1 : 0;
    });
    std::jthread mirror([&other] {  // returns every frame, as another node would
        can_frame frame{};
        for (int i = 0; i < 200; ++i) {
            (void)::recv(other.get(), &frame, sizeof frame, 0);
            (void)::send(other.get(), &frame, sizeof frame, 0);
        }
    });
    std::array<BusFrame, 8> some;
    for (std::uint32_t next = 0; next < 200;) {
        const auto count = bus.receive(some, 10ms);
        ASSERT_TRUE(count);
        for (std::size_t i = 0; i < *count; ++i) EXPECT_EQ(some[i].frame.id, next++);
        (void)bus.state();
    }
    EXPECT_EQ(bus.counters().sent, 200u);
    EXPECT_EQ(bus.counters().received, 200u);
}

TEST(BusState, everyOneHasASentenceWithTheBusInIt)
{
    for (const BusState state :
         {BusState::Up, BusState::Stalled, BusState::ErrorWarning, BusState::ErrorPassive,
          BusState::BusOff, BusState::Down, BusState::Absent, BusState::Ended})
        EXPECT_TRUE(describe(state, "can7").english().starts_with("can7"))
            << describe(state, "can7").english();
    EXPECT_NE(
        describe(BusState::Absent, "vcan0").english().find("sudo ip link add dev vcan0 type vcan"),
        std::string::npos);
    EXPECT_NE(describe(BusState::Down, "vcan0").english().find("sudo ip link set vcan0 up"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
