// Tests SocketCan with a real kernel: vcan0 is up and echoes like an adapter.
#include "drivers/socketcan.h"

#include <gtest/gtest.h>

#include <linux/can/error.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/kernel/support.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

double steadyNow()
{
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

std::unique_ptr<SocketCan> opened(const SocketCan::Options& options)
{
    auto bus = SocketCan::open(options);
    if (!bus) throw std::runtime_error(bus.error().text);
    return *std::move(bus);
}
std::unique_ptr<SocketCan> onto(const std::string& interface)
{
    return opened({.interface = interface, .transmit = true});
}

CanFrame command(std::uint32_t id = 0x100)
{
    return {.id = id, .length = 8, .data = {1, 2, 3}};
}

/// Returns all frames until none arrive for `quiet`.
std::vector<BusFrame> all(SocketCan& bus, std::chrono::milliseconds quiet = 100ms)
{
    std::array<BusFrame, 64> some;
    std::vector<BusFrame> frames;
    for (;;) {
        const auto count = bus.receive(some, quiet);
        if (!count) throw std::runtime_error(count.error().text);
        if (*count == 0) return frames;
        frames.insert(frames.end(), some.begin(),
                      some.begin() + static_cast<std::ptrdiff_t>(*count));
    }
}

/// Sends many frames at once while the kernel's thread delivers them; it queues at most 1000.
bool sendMany(const Peer& peer, int frames)
{
    for (int i = 0; i < frames; ++i, std::this_thread::yield())
        if (!peer.send(0x100)) return false;
    return true;
}

/// Receives until the bus is in this state; false after a long timeout.
bool reaches(SocketCan& bus, BusState state)
{
    std::array<BusFrame, 64> some;
    for (const auto end = Clock::now() + 20s; Clock::now() < end;) {
        if (bus.state() == state) return true;
        if (!bus.receive(some, 10ms)) return false;
    }
    return false;
}

/// Sets vcan0 up or down like `ip link set`, but without a process, which is slow in a guest.
void setVcan(bool up)
{
    const PosixFd any(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    ifreq request{};
    std::strcpy(request.ifr_name, "vcan0");
    bool done = ::ioctl(any.get(), SIOCGIFFLAGS, &request) == 0;
    const int flags = up ? request.ifr_flags | IFF_UP : request.ifr_flags & ~IFF_UP;
    request.ifr_flags = static_cast<short>(flags);
    done = done && ::ioctl(any.get(), SIOCSIFFLAGS, &request) == 0;
    if (!done) throw std::runtime_error("vcan0 cannot be set up or down");
}

/// Restores the interface, whatever the previous test did to it.
struct OnVcan : testing::Test {
    OnVcan()
    {
        shell("ip link show vcan0 >/dev/null 2>&1 || ip link add dev vcan0 type vcan; ip link set "
              "vcan0 up; "
              "tc qdisc del dev vcan0 root 2>/dev/null; true");
    }
};

TEST_F(OnVcan, ownFramesComeBackAsEchoesAndOthersDoNot)
{
    const auto bus = onto("vcan0");
    const Peer peer("vcan0");
    ASSERT_TRUE(bus->send(command()));
    ASSERT_TRUE(peer.send(0x200));
    const auto frames = all(*bus);
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].frame, command());
    EXPECT_TRUE(frames[0].echo && frames[0].local);
    EXPECT_TRUE(!frames[1].echo && frames[1].local);
    EXPECT_EQ(bus->counters().confirmed, 1u);
    EXPECT_EQ(peer.count(0.1), 1) << "the peer hears the frame, but not its own";
}

TEST_F(OnVcan, everyKindOfFrameArrivesUnchanged)
{
    shell("ip link set vcan0 down && ip link set vcan0 mtu 72 && ip link set vcan0 up");
    const auto bus = onto("vcan0");
    const Peer peer("vcan0");
    ASSERT_TRUE(peer.send(0x123, 0));
    ASSERT_TRUE(peer.send(0x123 | CAN_EFF_FLAG, 3, 0x030201));
    ASSERT_TRUE(peer.send(0x7ff | CAN_RTR_FLAG, 4));
    ASSERT_TRUE(peer.sendFd(0x321, 64));
    ASSERT_TRUE(peer.send(CAN_ERR_ACK | CAN_ERR_FLAG));
    const auto frames = all(*bus);
    ASSERT_EQ(frames.size(), 5u);
    EXPECT_EQ(frames[0].frame, (CanFrame{.id = 0x123}));
    EXPECT_EQ(frames[1].frame,
              (CanFrame{.id = 0x123, .extended = true, .length = 3, .data = {1, 2, 3}}));
    EXPECT_EQ(frames[2].frame, (CanFrame{.id = 0x7ff, .remote = true, .length = 4}));
    EXPECT_EQ(frames[3].frame, (CanFrame{.id = 0x321, .fd = true, .length = 64}));
    EXPECT_EQ(frames[4].frame, (CanFrame{.id = CAN_ERR_ACK, .error = true, .length = 8}));
    EXPECT_EQ(bus->counters().received, 5u);
    shell("ip link set vcan0 down && ip link set vcan0 mtu 16 && ip link set vcan0 up");
}

TEST_F(OnVcan, aFrameThatWaitedHasTheTimeOfItsArrival)
{
    const auto bus = onto("vcan0");
    const Peer peer("vcan0");
    (void)all(*bus, 1ms);
    const double before = steadyNow();
    ASSERT_TRUE(peer.send(0x100));
    const double after = steadyNow();
    std::this_thread::sleep_for(300ms);
    const auto frames = all(*bus);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_GT(frames[0].time, before - 0.01);
    EXPECT_LT(frames[0].time, after + 0.01);
    EXPECT_GT(frames[0].wallTime, 1.7e9);
}

TEST_F(OnVcan, anErrorFrameOfThisComputerIsAForgery)
{
    const auto bus = onto("vcan0");
    ASSERT_TRUE(Peer("vcan0").send(CAN_ERR_BUSOFF | CAN_ERR_FLAG))
        << "and its socket is closed at once";
    EXPECT_EQ(all(*bus).size(), 1u);
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(bus->counters().forgedErrors, 1u);
}

// Frames over a pair of interfaces have no local sender, like those of a controller or another node.
TEST(SocketCanOnAPair, theControllersErrorsAreUsed)
{
    shell("ip link add vxcan0 type vxcan peer name vxcan1 && ip link set vxcan0 up && ip link set "
          "vxcan1 up");
    const auto bus = onto("vxcan0");
    const Peer node("vxcan1");
    ASSERT_TRUE(node.send(0x100));
    const auto frames = all(*bus);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_FALSE(frames[0].local);
    ASSERT_TRUE(
        node.send(CAN_ERR_CRTL | CAN_ERR_FLAG, 8, std::uint64_t{CAN_ERR_CRTL_TX_PASSIVE} << 8));
    EXPECT_TRUE(reaches(*bus, BusState::ErrorPassive));
    ASSERT_TRUE(node.send(CAN_ERR_BUSOFF | CAN_ERR_FLAG));
    EXPECT_TRUE(reaches(*bus, BusState::BusOff));
    EXPECT_FALSE(bus->send(command()));
    ASSERT_TRUE(node.send(CAN_ERR_RESTARTED | CAN_ERR_FLAG));
    EXPECT_TRUE(reaches(*bus, BusState::Up));
    EXPECT_EQ(bus->counters().forgedErrors, 0u);
    shell("ip link del vxcan0");
}

// Tests of the interface.

TEST_F(OnVcan, aHundredTimesDownAndUpOnTheSameSocket)
{
    const auto bus = onto("vcan0");
    const std::size_t descriptors = openDescriptors();
    for (int i = 0; i < 100; ++i) {
        setVcan(false);
        ASSERT_TRUE(reaches(*bus, BusState::Down)) << i;
        ASSERT_FALSE(bus->send(command()));
        setVcan(true);
        ASSERT_TRUE(reaches(*bus, BusState::Up)) << i;
        (void)all(*bus, 1ms);
        ASSERT_TRUE(bus->send(command())) << i;
        ASSERT_EQ(all(*bus, 20ms).size(), 1u) << i;
    }
    EXPECT_EQ(openDescriptors(), descriptors);
    EXPECT_EQ(bus->counters().reopened, 0u);
    EXPECT_EQ(bus->counters().confirmed, 100u);
}

TEST_F(OnVcan, twentyTimesDeletedAndMadeAgain)
{
    const auto bus = onto("vcan0");
    const std::size_t descriptors = openDescriptors();
    for (int i = 0; i < 20; ++i) {
        shell("ip link del vcan0");
        // Every other time the sender notices first.
        EXPECT_TRUE(i % 2 == 0 || !bus->send(command()));
        ASSERT_TRUE(reaches(*bus, BusState::Absent)) << i;
        EXPECT_EQ(bus->send(command()).error().text, describe(BusState::Absent, "vcan0").english());
        shell("ip link add dev vcan0 type vcan && ip link set vcan0 up");
        ASSERT_TRUE(reaches(*bus, BusState::Up)) << i;
        (void)all(*bus, 1ms);
        ASSERT_TRUE(bus->send(command()));
        ASSERT_EQ(all(*bus, 20ms).size(), 1u) << i;
    }
    EXPECT_EQ(openDescriptors(), descriptors);
    EXPECT_EQ(bus->counters().reopened, 20u);
}

TEST_F(OnVcan, aQuicklyReplacedInterfaceIsDetected)
{
    const auto bus = onto("vcan0");
    shell("ip link del vcan0; ip link add dev vcan0 type vcan && ip link set vcan0 up");
    std::size_t heard = 0;
    for (const auto end = Clock::now() + 20s; heard == 0 && Clock::now() < end;) {
        ASSERT_TRUE(Peer("vcan0").send(0x100));
        heard = all(*bus, 50ms).size();
    }
    EXPECT_GT(heard, 0u);
    EXPECT_EQ(bus->counters().reopened, 1u);
}

TEST_F(OnVcan, anInterfaceThatTookOverTheNameIsUsed)
{
    const auto bus = onto("vcan0");
    shell("ip link add dev vcan8 type vcan; ip link set vcan0 down; ip link set vcan0 name vcan9; "
          "ip link set vcan8 name vcan0; ip link set vcan0 up");
    std::size_t heard = 0;
    for (const auto end = Clock::now() + 5s; heard == 0 && Clock::now() < end;) {
        ASSERT_TRUE(Peer("vcan0").send(0x100));
        heard = all(*bus, 50ms).size();
    }
    EXPECT_GT(heard, 0u);
    shell("ip link del vcan9");
}

TEST_F(OnVcan, anInterfaceThatIsDownAtFirstIsWaitedFor)
{
    setVcan(false);
    const auto bus = onto("vcan0");
    EXPECT_EQ(bus->state(), BusState::Down);
    EXPECT_EQ(bus->send(command()).error().text, describe(BusState::Down, "vcan0").english());
    setVcan(true);
    EXPECT_TRUE(reaches(*bus, BusState::Up));
}

TEST(SocketCanByName, namesWhatIsNoCanInterface)
{
    EXPECT_EQ(onto("can-not-there")->state(), BusState::Absent);
    const auto loopback = SocketCan::open({.interface = "lo"});
    ASSERT_FALSE(loopback);
    EXPECT_NE(loopback.error().text.find("no CAN interface"), std::string::npos);
    EXPECT_FALSE(SocketCan::open({.interface = "vcan0;reboot"}));
}

TEST_F(OnVcan, whatIsDownOrAbsentCostsNoTime)
{
    setVcan(false);
    const auto bus = onto("vcan0");
    const auto absent = onto("can-not-there");
    // Counts this thread's waits: a busy loop waits less often, a poll more often.
    const auto waits = [] {
        rusage usage{};
        ::getrusage(RUSAGE_THREAD, &usage);
        return usage.ru_nvcsw;
    };
    const auto before = waits();
    std::array<BusFrame, 1> one;
    for (int i = 0; i < 50; ++i) {
        EXPECT_TRUE(bus->receive(one, 20ms));
        EXPECT_TRUE(absent->receive(one, 20ms));
    }
    EXPECT_GE(waits() - before, 100);
    EXPECT_LE(waits() - before, 200);
}

// Tests of queue limits.

TEST_F(OnVcan, everyDroppedFrameIsCountedEvenIfNoneFollows)
{
    const auto bus = opened({.interface = "vcan0", .receiveBuffer = 20'000});
    const Peer peer("vcan0");
    constexpr int kSent = 3'000;
    ASSERT_TRUE(sendMany(peer, kSent));
    const std::size_t read = all(*bus).size();
    EXPECT_LT(read, 1'000u) << "the test wants an overflow";
    EXPECT_EQ(read + bus->counters().dropped, std::size_t{kSent})
        << "and nothing was sent after it";
    ASSERT_TRUE(peer.send(0x100));
    EXPECT_EQ(all(*bus).size(), 1u);
    EXPECT_EQ(read + bus->counters().dropped, std::size_t{kSent});
}

TEST_F(OnVcan, theBufferAskedForHoldsOverASecondOfAFullBus)
{
    const auto bus = onto("vcan0");
    EXPECT_EQ(bus->warning(), "");
    const Peer peer("vcan0");
    ASSERT_TRUE(sendMany(peer, 9'100));  // in a second: 9009 frames of 8 bytes at 1 Mbit/s
    EXPECT_EQ(all(*bus).size(), 9'100u);
    EXPECT_EQ(bus->counters().dropped, 0u);
}

TEST_F(OnVcan, withoutThePrivilegeThereIsAWarning)
{
    const pid_t child = ::fork();
    if (child == 0) {
        if (::setuid(65'534) != 0) ::_exit(2);
        const auto bus = SocketCan::open({.interface = "vcan0"});
        const std::string warning = bus ? (*bus)->warning() : bus.error().text;
        std::puts(warning.c_str());
        std::fflush(stdout);
        ::_exit(warning.find("rmem_max=4194304") == std::string::npos ? 1 : 0);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

// A stalled bus: the queue passes the first frame and then almost nothing.

TEST_F(OnVcan, twoSecondsOfCommandsOnAStalledBusReplayTwo)
{
    const auto bus = onto("vcan0");
    const Peer robot("vcan0");
    stall("vcan0", 3'200);
    int refused = 0;
    for (int i = 0; i < 100; ++i) {
        refused += bus->send(command()) ? 0 : 1;
        (void)all(*bus, 20ms);
        EXPECT_TRUE(i < 10 || bus->state() == BusState::Stalled) << i;
    }
    EXPECT_EQ(robot.count(0.05), 1) << "before the queue filled";
    EXPECT_GE(refused, 97);
    EXPECT_EQ(bus->counters().notSent, static_cast<std::uint64_t>(refused));

    letGo("vcan0");
    EXPECT_LE(robot.count(0.3), 2 + 1) << "two commands and the push";
    EXPECT_TRUE(reaches(*bus, BusState::Up));
    ASSERT_TRUE(bus->send(command()));
    EXPECT_EQ(robot.count(0.1), 1);
    EXPECT_EQ(bus->counters().confirmed, bus->counters().sent - 1) << "the last echo is unread";
}

TEST_F(OnVcan, setDownAndUpAgainAStalledBusReplaysNothing)
{
    const auto bus = onto("vcan0");
    stall("vcan0", 3'200);
    for (int i = 0; i < 10; ++i) {
        (void)bus->send(command());
        (void)all(*bus, 20ms);
    }
    ASSERT_EQ(bus->state(), BusState::Stalled);
    const Peer robot("vcan0");
    shell("ip link set vcan0 down; tc qdisc del dev vcan0 root; ip link set vcan0 up");
    EXPECT_TRUE(reaches(*bus, BusState::Up));
    EXPECT_EQ(robot.count(0.2), 0);
    ASSERT_TRUE(bus->send(command()));
    EXPECT_EQ(all(*bus).size(), 1u);
}

TEST_F(OnVcan, aFullQueueIsReportedWithoutWaiting)
{
    const auto bus = opened({.interface = "vcan0", .transmit = true, .maxUnconfirmed = 0});
    const Peer robot("vcan0");
    stall("vcan0", 64);  // room for four frames
    int sent = 0, full = 0;
    for (int i = 0; i < 12; ++i) {
        const Status status = bus->send(command());
        if (status)
            ++sent;
        else if (status.error().code == ENOBUFS)
            ++full;
    }
    EXPECT_EQ(sent, 5) << "one left, four wait";
    EXPECT_EQ(full, 7);
    EXPECT_EQ(robot.count(0.05), 1);
}

// Tests with other programs.

TEST_F(OnVcan, candumpReadsWhatWeSend)
{
    const TemporaryDirectory directory;
    const std::string log = directory.file("dump.log");
    shell("candump -L -n 3 vcan0 >" + log + " & sleep 0.5");
    const auto bus = onto("vcan0");
    for (const CanFrame& frame :
         {CanFrame{.id = 0x123, .length = 3, .data = {0xde, 0xad, 0xbe}},
          CanFrame{.id = 0x1234567, .extended = true}, CanFrame{.id = 0x42, .remote = true}}) {
        ASSERT_TRUE(bus->send(frame));
        (void)all(*bus, 20ms);
    }
    std::string text;
    for (const auto end = Clock::now() + 10s;
         Clock::now() < end && std::ranges::count(text, '\n') < 3;) {
        std::this_thread::sleep_for(50ms);
        text = contentOf(log);
    }
    EXPECT_NE(text.find(" vcan0 123#DEADBE\n"), std::string::npos) << text;
    EXPECT_NE(text.find(" vcan0 01234567#\n"), std::string::npos) << text;
    EXPECT_NE(text.find(" vcan0 042#R\n"), std::string::npos) << text;
}

TEST_F(OnVcan, weReadWhatCansendSends)
{
    const auto bus = onto("vcan0");
    shell("cansend vcan0 123#DEADBE && cansend vcan0 01234567# && cansend vcan0 042#R");
    const auto frames = all(*bus);
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].frame, (CanFrame{.id = 0x123, .length = 3, .data = {0xde, 0xad, 0xbe}}));
    EXPECT_EQ(frames[1].frame, (CanFrame{.id = 0x1234567, .extended = true}));
    EXPECT_EQ(frames[2].frame, (CanFrame{.id = 0x42, .remote = true}));
}

}  // namespace
}  // namespace terratact
