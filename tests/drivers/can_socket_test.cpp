#include "drivers/can_socket.h"

#include <gtest/gtest.h>

#include <linux/can.h>
#include <pthread.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <initializer_list>
#include <thread>

namespace terratact {
namespace {

template <class Frame>
Frame rawFrame(canid_t id, std::uint8_t length, std::initializer_list<std::uint8_t> data)
{
    Frame frame{};
    frame.can_id = id;
    frame.len = length;
    std::copy(data.begin(), data.end(), frame.data);
    return frame;
}
can_frame classic(canid_t id, std::uint8_t length, std::initializer_list<std::uint8_t> data = {})
{
    return rawFrame<can_frame>(id, length, data);
}
canfd_frame flexible(canid_t id, std::uint8_t length, std::initializer_list<std::uint8_t> data = {})
{
    return rawFrame<canfd_frame>(id, length, data);
}

// One end of a pair of ordinary sockets acts as the kernel's CAN socket; the other end is the bus.
struct SocketPair : testing::Test {
    SocketPair()
    {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()) != 0)
            throw std::runtime_error("no socketpair");
        bus = PosixFd(ends[0]);
        socket = canSocketOn(PosixFd(ends[1]), "lo");
    }
    template <class Frame>
    void put(const Frame& frame, std::size_t bytes = sizeof(Frame)) const
    {
        ASSERT_EQ(::send(bus.get(), &frame, bytes, 0), static_cast<ssize_t>(bytes));
    }
    CanSocket::Reading read(double patience = 0.0)
    {
        const auto reading = socket->read(frames, patience);
        EXPECT_TRUE(reading) << reading.error().text;
        return reading ? *reading : CanSocket::Reading{};
    }

    PosixFd bus;
    std::unique_ptr<CanSocket> socket;
    std::array<BusFrame, 100> frames{};
};

TEST_F(SocketPair, everyKindOfFrameArrivesUnchanged)
{
    put(classic(0x123, 2, {0xde, 0xad, 0xbe}));
    put(classic(0x123 | CAN_EFF_FLAG, 0));
    put(classic(0x7ff | CAN_RTR_FLAG, 4));
    put(classic(0x40 | CAN_ERR_FLAG, 8));
    put(flexible(0x321, 64, {1, 2, 3, 4, 5, 6, 7, 8, 9}));
    const auto reading = read();
    ASSERT_EQ(reading.frames, 5u);
    EXPECT_TRUE(reading.emptied);
    EXPECT_EQ(frames[0].frame, (CanFrame{.id = 0x123, .length = 2, .data = {0xde, 0xad}}));
    EXPECT_EQ(frames[1].frame, (CanFrame{.id = 0x123, .extended = true}));
    EXPECT_EQ(frames[2].frame, (CanFrame{.id = 0x7ff, .remote = true, .length = 4}));
    EXPECT_EQ(frames[3].frame, (CanFrame{.id = 0x40, .error = true, .length = 8}));
    EXPECT_EQ(
        frames[4].frame,
        (CanFrame{.id = 0x321, .fd = true, .length = 64, .data = {1, 2, 3, 4, 5, 6, 7, 8, 9}}));
}

TEST_F(SocketPair, whatIsNoFrameIsCountedAndSkipped)
{
    const can_frame good = classic(1, 1, {7});
    put(good, sizeof good - 1);    // one byte short
    put(std::array<char, 100>{});  // longer than any frame
    put(classic(1, 9));            // more bytes than there are
    put(flexible(1, 65));
    put(good);
    const auto reading = read();
    EXPECT_EQ(reading.malformed, 4u);
    ASSERT_EQ(reading.frames, 1u);
    EXPECT_EQ(frames[0].frame.data[0], 7);
}

TEST_F(SocketPair, readsLongQueuesInTheOrderSent)
{
    for (canid_t id = 0; id < 90; ++id) put(classic(id, 0));
    canid_t next = 0;
    bool emptied = false;
    while (!emptied) {
        const auto reading = read();
        for (std::size_t i = 0; i < reading.frames; ++i) EXPECT_EQ(frames[i].frame.id, next++);
        emptied = reading.emptied;
    }
    EXPECT_EQ(next, 90u);
}

TEST_F(SocketPair, nothingToReadIsNotAnError)
{
    const auto reading = read(0.01);
    EXPECT_EQ(reading.frames, 0u);
    EXPECT_TRUE(reading.emptied);
}

TEST_F(SocketPair, aSignalOnlyEndsTheWait)
{
    struct sigaction action {};
    action.sa_handler = [](int) {};
    ASSERT_EQ(::sigaction(SIGUSR1, &action, nullptr), 0);  // no SA_RESTART
    const pthread_t reader = ::pthread_self();
    std::jthread sender([reader](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            ::pthread_kill(reader, SIGUSR1);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    EXPECT_EQ(read(60.0).frames, 0u) << "long before the patience ends, and without an Error";
}

TEST_F(SocketPair, whatIsWrittenIsTheKernelsLayout)
{
    ASSERT_TRUE(socket->write({.id = 0x123, .length = 3, .data = {1, 2, 3, 4}}));
    ASSERT_TRUE(socket->write({.id = 0x12345, .extended = true, .remote = true}));
    can_frame frame{};
    ASSERT_EQ(::recv(bus.get(), &frame, sizeof frame, 0), static_cast<ssize_t>(CAN_MTU));
    EXPECT_EQ(frame.can_id, 0x123u);
    EXPECT_EQ(frame.len, 3);
    EXPECT_EQ(frame.data[2], 3);
    EXPECT_EQ(frame.data[3], 0) << "what lies behind the end is not sent";
    ASSERT_EQ(::recv(bus.get(), &frame, sizeof frame, 0), static_cast<ssize_t>(CAN_MTU));
    EXPECT_EQ(frame.can_id, 0x12345u | CAN_EFF_FLAG | CAN_RTR_FLAG);
}

TEST_F(SocketPair, aFullQueueIsAnErrorAndNoWait)
{
    Status written = Done{};
    for (int i = 0; i < 1'000'000 && written; ++i) written = socket->write({.id = 1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, EAGAIN);
}

TEST_F(SocketPair, closedOtherEndIsAnErrorWithoutASignal)
{
    bus.reset();
    const Status written = socket->write({.id = 1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, EPIPE);
}

TEST(OpenCanSocket, reportsAMissingInterfaceOrMissingCan)
{
    const auto socket = openCanSocket("terratact-none", 4096);
    ASSERT_FALSE(socket);
    EXPECT_NE(socket.error().code, 0);
    EXPECT_TRUE(socket.error().text.starts_with("terratact-none")) << socket.error().text;
}

TEST(PosixFd, closesWhatItOwnsOnceAndMovesIt)
{
    std::array<int, 2> ends{};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    PosixFd one(ends[0]), other(ends[1]);
    PosixFd moved(std::move(one));
    EXPECT_FALSE(one);  // NOLINT(bugprone-use-after-move): the test is about the moved-from object
    EXPECT_EQ(moved.get(), ends[0]);
    moved = std::move(other);
    EXPECT_EQ(moved.get(), ends[1]);
    char byte = 0;
    EXPECT_EQ(::recv(moved.get(), &byte, 1, 0), 0) << "the first end was closed: end of file";
    moved.reset();
    EXPECT_FALSE(moved);
}

}  // namespace
}  // namespace terratact
