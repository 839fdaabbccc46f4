// Tests a full bus of 1 Mbit/s, 9,009 frames of eight bytes a second, while estimates are computed.
#include "drivers/socketcan.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "tests/kernel/support.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kRate = 9'009;  // [1/s]
constexpr int kMaxTurns = 10;

/// Returns TERRATACT_FULL_BUS_SECONDS, or 8.
std::uint64_t seconds()
{
    const char* given = std::getenv("TERRATACT_FULL_BUS_SECONDS");
    return given ? std::strtoull(given, nullptr, 10) : 8;
}

/// Starts a process that sends frames numbered from `first` at even intervals, except for scheduling delays.
pid_t startSender(std::uint64_t first, std::uint64_t frames)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    const Peer peer("vcan0");
    const auto begin = Clock::now();
    for (std::uint64_t i = 0; i < frames; ++i) {
        if (i % 9 == 0)
            std::this_thread::sleep_until(begin
                                          + std::chrono::nanoseconds(i * 1'000'000'000 / kRate));
        while (!peer.send(0x100, 8, first + i)) {
        }
    }
    ::_exit(0);
}

/// Starts a process with explorations on the simulated robot, two estimates each, one after another.
pid_t startEstimates(const std::string& directory)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    const std::string loop = std::string("while '") + TERRATACT_CLI + "' demo --out '" + directory
                           + "'; do echo >>'" + directory + "/done'; done";
    ::execl("/bin/sh", "sh", "-c", loop.c_str(), nullptr);
    ::_exit(127);
}

TEST(FullBus, noFrameIsLostWhileEstimatesAreComputed)
{
    auto opened = SocketCan::open({.interface = "vcan0"});
    ASSERT_TRUE(opened) << opened.error().text;
    SocketCan& bus = **opened;
    EXPECT_EQ(bus.warning(), "");

    const TemporaryDirectory directory;
    const pid_t estimates = startEstimates(directory.file(""));
    std::this_thread::sleep_for(1s);
    const auto begin = Clock::now();

    // Runs until an exploration was completed beside the full bus, however slow the guest is.
    std::uint64_t next = 0, frames = 0;
    std::size_t explorations = 0;
    for (int turn = 0; turn < kMaxTurns && (turn == 0 || explorations == 0); ++turn) {
        const pid_t sender = startSender(frames, seconds() * kRate);
        frames += seconds() * kRate;
        std::array<BusFrame, 64> some;
        for (auto heard = Clock::now(); next < frames && Clock::now() - heard < 10s;) {
            const auto count = bus.receive(some, 20ms);
            ASSERT_TRUE(count) << count.error().text;
            for (std::size_t i = 0; i < *count; ++i, ++next) {
                std::uint64_t number = 0;
                std::memcpy(&number, some[i].frame.data.data(), sizeof number);
                ASSERT_EQ(number, next) << "lost, doubled or out of order";
            }
            if (*count > 0) heard = Clock::now();
        }
        ::waitpid(sender, nullptr, 0);
        explorations = contentOf(directory.file("done")).size();
    }
    const double took = std::chrono::duration<double>(Clock::now() - begin).count();
    ::kill(estimates, SIGTERM);
    ::waitpid(estimates, nullptr, 0);

    std::printf("%llu frames in %.2f s, %.0f a second; lost %llu; %zu explorations beside\n",
                static_cast<unsigned long long>(next), took, static_cast<double>(next) / took,
                static_cast<unsigned long long>(bus.counters().dropped), explorations);
    EXPECT_EQ(next, frames);
    EXPECT_EQ(bus.counters().dropped, 0u);
    EXPECT_EQ(bus.counters().received, frames);
    EXPECT_GE(explorations, 1u);
}

}  // namespace
}  // namespace terratact
