#include "drivers/socketcan.h"

#include <gtest/gtest.h>

#include <linux/can.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <deque>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace terratact {
namespace {

using namespace std::chrono_literals;

CanFrame frameOfId(std::uint32_t id)
{
    return {.id = id, .length = 2, .data = {1, 2}};
}

// Fake kernel under the test's control, with a clock that only waiting advances.
struct Kernel {
    double now = 100.0, wall = 5000.0;  // [s]
    bool present = true, up = true;
    int noSocket = 0;                   // errno of opening
    int readError = 0, writeError = 0;  // errno, until cleared; a read's is reported once
    std::uint64_t drops = 0;
    std::size_t buffer = 8u << 20;
    std::deque<BusFrame> queue;
    std::vector<CanFrame> written;
    int opened = 0, closed = 0, reads = 0, naps = 0;

    void pass(double seconds)
    {
        now += seconds;
        wall += seconds;
    }
    void put(const CanFrame& frame, bool local = false)
    {
        queue.push_back({.frame = frame, .wallTime = wall, .echo = false, .local = local});
    }
    void echo(const CanFrame& frame)
    {
        queue.push_back({.frame = frame, .wallTime = wall, .echo = true, .local = true});
    }
};

class FakeSocket final : public CanSocket {
public:
    explicit FakeSocket(Kernel& kernel) : kernel_(kernel), incarnation_(++kernel.opened) {}
    ~FakeSocket() override { ++kernel_.closed; }

    Result<Reading> read(std::span<BusFrame> frames, double patience) override
    {
        ++kernel_.reads;
        if (const int code = std::exchange(kernel_.readError, 0)) return Error{"trouble", code};
        if (kernel_.queue.empty()) kernel_.pass(patience);
        Reading reading;
        for (; reading.frames < frames.size() && !kernel_.queue.empty(); ++reading.frames) {
            frames[reading.frames] = kernel_.queue.front();
            kernel_.queue.pop_front();
        }
        reading.emptied = reading.frames < frames.size();
        return reading;
    }
    Status write(const CanFrame& frame) override
    {
        if (kernel_.writeError) return Error{"trouble", kernel_.writeError};
        kernel_.written.push_back(frame);
        return Done{};
    }
    Link link() const override
    {
        if (!kernel_.present || incarnation_ != kernel_.opened) return Link::Gone;
        return kernel_.up ? Link::Up : Link::Down;
    }
    std::uint64_t drops() const override { return kernel_.drops; }
    std::size_t receiveBuffer() const override { return kernel_.buffer; }

private:
    Kernel& kernel_;
    int incarnation_;
};

SocketCan::System systemOf(Kernel& kernel)
{
    return {.openSocket = [&kernel]() -> Result<std::unique_ptr<CanSocket>> {
                if (kernel.noSocket) return Error{"can0: trouble", kernel.noSocket};
                if (!kernel.present) return Error{"can0: absent", ENODEV};
                return std::unique_ptr<CanSocket>(std::make_unique<FakeSocket>(kernel));
            },
            .steadyTime = [&kernel] { return kernel.now; },
            .wallTime = [&kernel] { return kernel.wall; },
            .sleep =
                [&kernel](double seconds) {
                    kernel.pass(seconds);
                    ++kernel.naps;
                }};
}

std::unique_ptr<SocketCan> opened(Kernel& kernel, SocketCan::Options options = {.interface = "can0",
                                                                                .transmit = true})
{
    options.interface = "can0";
    auto bus = SocketCan::open(options, systemOf(kernel));
    if (!bus) throw std::runtime_error(bus.error().text);
    return *std::move(bus);
}

struct OnABus : testing::Test {
    Kernel kernel;
    std::unique_ptr<SocketCan> bus = opened(kernel);
    std::array<BusFrame, 8> frames{};

    std::size_t receive(std::chrono::milliseconds patience = 0ms)
    {
        const auto count = bus->receive(frames, patience);
        EXPECT_TRUE(count) << count.error().text;
        return count ? *count : 0;
    }
    std::string refusal(std::uint32_t id = 9)
    {
        const Status sent = bus->send(frameOfId(id));
        return sent ? std::string() : sent.error().text;
    }
};

// Names and options.

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

TEST(SocketCan, optionsWithoutSenseThrow)
{
    Kernel kernel;
    EXPECT_THROW(
        (void)SocketCan::open({.interface = "can0", .stalledAfter = 0.0}, systemOf(kernel)),
        std::invalid_argument);
    EXPECT_THROW((void)SocketCan::open({.interface = "can0", .receiveBuffer = 0}, systemOf(kernel)),
                 std::invalid_argument);
}

TEST(SocketCan, onlyReceivesUnlessToldOtherwise)
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

// The window.

TEST_F(OnABus, aThirdUnconfirmedFrameIsRefused)
{
    EXPECT_EQ(refusal(1), "");
    EXPECT_EQ(refusal(2), "");
    EXPECT_NE(refusal(3), "");
    EXPECT_EQ(kernel.written.size(), 2u);
    kernel.echo(frameOfId(1));
    EXPECT_EQ(receive(), 1u);
    EXPECT_TRUE(frames[0].echo);
    EXPECT_EQ(refusal(4), "");
    const BusCounters counters = bus->counters();
    EXPECT_EQ(counters.sent, 3u);
    EXPECT_EQ(counters.confirmed, 1u);
    EXPECT_EQ(counters.notSent, 1u);
}

TEST_F(OnABus, theEchoOfALaterFrameConfirmsThoseBefore)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.echo(frameOfId(2));
    (void)receive();
    EXPECT_EQ(refusal(3), "");
    EXPECT_EQ(refusal(4), "");
}

TEST_F(OnABus, somebodyElsesCopyConfirmsNothing)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.put(frameOfId(1));
    kernel.put(frameOfId(1), true);
    kernel.echo(frameOfId(7));  // an echo from an earlier socket
    (void)receive();
    EXPECT_NE(refusal(3), "");
}

TEST_F(OnABus, bytesBehindTheEndDoNotHideAnEcho)
{
    ASSERT_TRUE(bus->send({.id = 1, .length = 1, .data = {5, 6, 7}}));
    kernel.echo({.id = 1, .length = 1, .data = {5}});
    (void)receive();
    EXPECT_EQ(bus->counters().confirmed, 1u);
}

TEST_F(OnABus, busWithoutEchoesStallsAfter60Ms)
{
    ASSERT_EQ(refusal(1), "");
    kernel.pass(0.059);
    EXPECT_EQ(bus->state(), BusState::Up);
    kernel.pass(0.002);
    EXPECT_EQ(bus->state(), BusState::Stalled);
    EXPECT_NE(refusal(2).find("acknowledges"), std::string::npos) << "though the window has room";
    kernel.echo(frameOfId(1));
    (void)receive();
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(refusal(3), "");
}

TEST_F(OnABus, twoSecondsOfCommandsOnAStalledBusLeaveTwoFrames)
{
    for (int i = 0; i < 100; ++i) {
        (void)bus->send(frameOfId(0x100));
        (void)receive(20ms);
    }
    EXPECT_EQ(kernel.written.size(), 2u);
    EXPECT_EQ(bus->counters().notSent, 98u);
    EXPECT_EQ(bus->state(), BusState::Stalled);
}

TEST(SocketCan, withoutAWindowABurstLeavesAndAStallStillStopsIt)
{
    Kernel kernel;
    const auto bus = opened(kernel, {.transmit = true, .maxUnconfirmed = 0});
    for (std::uint32_t id = 0; id < 12; ++id) ASSERT_TRUE(bus->send(frameOfId(id)));
    kernel.pass(0.1);
    EXPECT_EQ(bus->state(), BusState::Stalled);
    EXPECT_FALSE(bus->send(frameOfId(12)));
}

TEST_F(OnABus, anEchoThatWasDroppedDoesNotCloseTheWindowForEver)
{
    ASSERT_EQ(refusal(1), "");
    ASSERT_EQ(refusal(2), "");
    kernel.drops = 5;
    (void)receive(300ms);
    EXPECT_EQ(bus->state(), BusState::Up);
    EXPECT_EQ(refusal(3), "");
    EXPECT_EQ(bus->counters().dropped, 5u);
}

// What the kernel answers.

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

// What the controller says.

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

// Time.

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
        EXPECT_TRUE(describe(state, "can7").english().starts_with("can7 "))
            << describe(state, "can7").english();
    EXPECT_NE(
        describe(BusState::Absent, "vcan0").english().find("sudo ip link add dev vcan0 type vcan"),
        std::string::npos);
    EXPECT_NE(describe(BusState::Down, "vcan0").english().find("sudo ip link set vcan0 up"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
