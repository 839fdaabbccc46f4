#include "drivers/log_replay.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/wire/can_codec.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

struct Replaying : testing::Test {
    TemporaryDirectory folder;
    double now = 5000.0;  ///< on a clock that only sleeping advances
    int sleeps = 0;
    std::array<BusFrame, 4> frames;

    std::string path() const { return folder.file("demo.log"); }
    Result<std::unique_ptr<LogReplay>> open(std::string_view content,
                                            const LogReplay::Options& options = {})
    {
        folder.write("demo.log", content);
        return LogReplay::open(path(), options,
                               {[this] { return now; },
                                [this](double seconds) {
                                    ASSERT_GT(seconds, 0.0);
                                    now += seconds;
                                    ++sleeps;
                                }});
    }
    std::size_t receive(CanBus& bus, std::chrono::milliseconds patience)
    {
        const auto count = bus.receive(frames, patience);
        if (!count) throw std::runtime_error(count.error().text);
        return *count;
    }
};

constexpr std::string_view kThree = "(1000.0) can0 044#01 R\n"
                                    "(1000.0) can0 045#02 T\n"
                                    "(1000.5) can0 20000004#0000000000000000\n";

TEST_F(Replaying, keepsTheTimingOfTheLog)
{
    const auto bus = open(kThree);
    ASSERT_TRUE(bus) << bus.error().text;
    EXPECT_EQ((*bus)->name(), "REPLAY demo.log");
    now += 7.0;  // the replay does not start before the first receive()
    ASSERT_EQ(receive(**bus, 100ms), 2U);
    EXPECT_EQ(now, 5007.0);
    EXPECT_EQ(frames[0].frame.id, 0x44U);
    EXPECT_EQ(frames[0].time, 5007.0);
    EXPECT_EQ(frames[0].wallTime, 1000.0);
    EXPECT_FALSE(frames[0].local);
    EXPECT_TRUE(frames[1].local);
    EXPECT_FALSE(frames[1].echo);
    ASSERT_EQ(receive(**bus, 100ms), 0U);
    EXPECT_NEAR(now, 5007.1, 1e-9);
    ASSERT_EQ(receive(**bus, 1000ms), 1U);
    EXPECT_NEAR(now, 5007.5, 1e-9) << "it does not wait longer than until the frame is due";
    EXPECT_EQ(frames[0].time, 5007.5);
    EXPECT_TRUE(frames[0].frame.error);
}

TEST_F(Replaying, runsFasterOrSlower)
{
    const auto fast = open(kThree, {.speed = 10.0});
    receive(**fast, 0ms);
    ASSERT_EQ(receive(**fast, 1000ms), 1U);
    EXPECT_NEAR(now, 5000.05, 1e-9);
    now = 5000.0;
    const auto slow = open(kThree, {.speed = 0.5});
    receive(**slow, 0ms);
    ASSERT_EQ(receive(**slow, 2000ms), 1U);
    EXPECT_NEAR(now, 5001.0, 1e-9);
}

TEST_F(Replaying, deliversDueFramesInOrderUpToTheRoom)
{
    std::string log;
    for (int i = 0; i < 10; ++i) log += "(1000.0) can0 00" + std::to_string(i) + "#\n";
    const auto bus = open(log);
    std::uint32_t expected = 0;
    for (const std::size_t count : {4U, 4U, 2U}) {
        ASSERT_EQ(receive(**bus, 0ms), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(frames[i].frame.id, expected++);
    }
    EXPECT_EQ(sleeps, 0);
}

TEST_F(Replaying, endsAsABusThatWaits)
{
    const auto bus = open(kThree);
    EXPECT_EQ((*bus)->state(), BusState::Up);
    receive(**bus, 0ms);
    EXPECT_EQ((*bus)->state(), BusState::Up);
    receive(**bus, 1000ms);
    EXPECT_EQ((*bus)->state(), BusState::Ended);
    const double before = now;
    EXPECT_EQ(receive(**bus, 200ms), 0U);
    EXPECT_NEAR(now, before + 0.2, 1e-9) << "a loop around it must not spin";
    EXPECT_EQ((*bus)->counters().received, 3U);
    EXPECT_EQ((*bus)->counters().errorFrames, 1U);
}

TEST_F(Replaying, takesNoCommands)
{
    const auto bus = open(kThree);
    const Status sent = (*bus)->send(frameOf(Command{StopCommand{}}, 0, 1));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().text, "REPLAY demo.log: a replay takes no commands");
    EXPECT_EQ((*bus)->counters().notSent, 1U);
    EXPECT_EQ((*bus)->counters().sent, 0U);
}

TEST_F(Replaying, neverRunsBackwardsAndNeverCatchesUpABackwardStep)
{
    const auto bus = open("(1000.0) can0 001#\n(900.0) can0 002#\n(901.0) can0 003#\n");
    ASSERT_EQ(receive(**bus, 0ms), 2U);
    EXPECT_EQ(frames[1].time, frames[0].time);
    ASSERT_EQ(receive(**bus, 2000ms), 1U);
    EXPECT_NEAR(frames[0].time, 5001.0, 1e-9);
}

TEST_F(Replaying, reportsClockStepsAndATruncatedEnd)
{
    const auto bus = open("(1000.0) can0 001#\n(900.0) can0 002#\n(901.0) can0 00");
    ASSERT_TRUE(bus) << bus.error().text;
    const auto& remarks = (*bus)->remarks();
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_TRUE(remarks[0].english().starts_with(path() + ": line 2: 100 s earlier"))
        << remarks[0].english();
    EXPECT_TRUE(remarks[1].english().starts_with(path() + ": line 3: is torn"))
        << remarks[1].english();
    EXPECT_EQ(receive(**bus, 0ms), 2U);
    EXPECT_EQ((*bus)->state(), BusState::Ended);
}

TEST_F(Replaying, shortensASilenceOfYearsWithANotice)
{
    const auto bus = open("(1000.0) can0 001#\n(1000.0) can1 001#\n(100001000.0) can0 002#\n"
                          "(100001050.0) can0 003#\n",
                          {.interface = "can0"});
    ASSERT_TRUE(bus) << bus.error().text;
    ASSERT_EQ((*bus)->remarks().size(), 1U);
    EXPECT_NE((*bus)->remarks()[0].english().find("line 3: follows 100000000 s of silence"),
              std::string::npos);
    EXPECT_FALSE((*bus)->wait());
    ASSERT_EQ(receive(**bus, 0ms), 1U);
    EXPECT_EQ((*bus)->wait(), LogReplay::kShortWait);
    ASSERT_EQ(receive(**bus, 10'000ms), 1U);
    EXPECT_NEAR(now, 5000.0 + LogReplay::kShortWait, 1e-9);
    EXPECT_EQ(frames[0].wallTime, 100001000.0);
    EXPECT_NEAR(*(*bus)->wait(), 50.0, 1e-9) << "a shorter silence is kept";
}

TEST_F(Replaying, takesALogThatIsAPipe)
{
    const std::string fifo = folder.file("fifo");
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(fifo) << kThree; });
    const auto bus = LogReplay::open(fifo, {});
    writer.join();
    ASSERT_TRUE(bus) << bus.error().text;
    EXPECT_EQ((*bus)->name(), "REPLAY fifo");
}

TEST_F(Replaying, frameTimeIsItsDueTimeEvenIfReadLate)
{
    const auto bus = open(kThree);
    receive(**bus, 0ms);
    now += 9.0;
    ASSERT_EQ(receive(**bus, 0ms), 1U);
    EXPECT_EQ(frames[0].time, 5000.5);
}

TEST_F(Replaying, needsTheInterfaceIfThereAreSeveral)
{
    const std::string log = "(1.0) can1 001#\n(1.1) can0 002#\n(1.5) can1 003#\n"
                            "DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 3)\n";
    EXPECT_TRUE(refused(open(log), path(), {"holds frames of can0, can1: name the one to replay"}));
    EXPECT_TRUE(
        refused(open(log, {.interface = "can2"}), path(), {"no frame of can2", "can0, can1"}));
    const auto bus = open(log, {.interface = "can1"});
    ASSERT_TRUE(bus);
    ASSERT_EQ(receive(**bus, 0ms), 1U);
    EXPECT_EQ(frames[0].frame.id, 1U);
    ASSERT_EQ(receive(**bus, 1000ms), 1U);
    EXPECT_EQ(frames[0].frame.id, 3U);
    EXPECT_NEAR(frames[0].time, 5000.5, 1e-9);
    EXPECT_EQ((*bus)->counters().dropped, 3U) << "the log does not say of what was lost";
}

TEST_F(Replaying, refusesALogThatCannotBeReplayed)
{
    EXPECT_TRUE(refused(open(""), path(), {"holds no frame"}));
    EXPECT_TRUE(refused(open("(1.0) can0 001#\n(1.1) can0 1#\n"), path(), {"line 2"}));
    EXPECT_TRUE(refused(open(" can0  001   [0] \n"), path(), {"line 1", "candump -L"}));
    const auto none = LogReplay::open(folder.file("none.log"), {});
    EXPECT_TRUE(refused(none, folder.file("none.log"), {"No such file"}));
    const auto device = LogReplay::open("/dev/null", {});
    EXPECT_TRUE(refused(device, "/dev/null", {"holds no frame"}));
    const auto directory = LogReplay::open(folder.file(""), {});
    EXPECT_TRUE(refused(directory, folder.file(""), {"is a folder"}));
    for (const double speed : {0.0, -1.0, 1001.0, std::nan("")})
        EXPECT_THROW(static_cast<void>(open(kThree, {.speed = speed})), std::invalid_argument);
    const auto bus = open(kThree);
    EXPECT_THROW(static_cast<void>((*bus)->receive({}, 0ms)), std::invalid_argument);
}

TEST_F(Replaying, reportsALogThatChanges)
{
    std::string log;  // longer than what a file's buffer holds
    for (int i = 0; i < 5000; ++i) log += "(1000.0) can0 001#0102030405060708\n";
    const auto bus = open(log);
    ASSERT_TRUE(bus);
    folder.write("demo.log", std::string(log.size(), 'x') + "\n");
    for (;;) {
        const auto count = (*bus)->receive(frames, 0ms);
        if (count) {
            ASSERT_GT(*count, 0U) << "the end was reached";
            continue;
        }
        EXPECT_TRUE(refused(count, path(), {"line"}));
        break;
    }
}

TEST_F(Replaying, usesTheSystemClockByDefault)
{
    folder.write("demo.log", kThree);
    const auto bus = LogReplay::open(path(), {.speed = 1000.0});
    ASSERT_TRUE(bus);
    EXPECT_EQ(receive(**bus, 1ms), 2U);
    EXPECT_EQ(receive(**bus, 10'000ms), 1U) << "due after half a millisecond";
}

TEST_F(Replaying, pausesAndMissesNothing)
{
    const auto bus = open(kThree);
    ASSERT_TRUE(bus);
    receive(**bus, 0ms);
    (*bus)->setPaused(true);
    EXPECT_EQ(receive(**bus, 10s), 0U);
    EXPECT_TRUE((*bus)->progress().paused);
    (*bus)->setPaused(false);
    const double on = now;
    ASSERT_EQ(receive(**bus, 10s), 1U);
    EXPECT_NEAR(now, on + 0.5, 1e-9) << "as long as there was left";
}

TEST_F(Replaying, goesToATimeAlsoBackFromItsEnd)
{
    const auto bus = open(kThree);
    ASSERT_TRUE(bus);
    EXPECT_NEAR((*bus)->progress().length, 0.5, 1e-9);
    receive(**bus, 0ms);
    (*bus)->seek(0.3);
    ASSERT_EQ(receive(**bus, 0ms), 1U) << "at once, with the first frame from then on";
    EXPECT_EQ(frames[0].wallTime, 1000.5);
    EXPECT_EQ((*bus)->state(), BusState::Ended);
    (*bus)->seek(0.0);
    ASSERT_EQ(receive(**bus, 0ms), 2U);
    EXPECT_EQ(frames[0].frame.id, 0x44U);
    EXPECT_GE(frames[0].time, 5000.0) << "ages count on the clock";
    EXPECT_EQ((*bus)->state(), BusState::Up);
    (*bus)->seek(99.0);
    EXPECT_EQ(receive(**bus, 0ms), 0U);
    EXPECT_EQ((*bus)->state(), BusState::Ended);
}

TEST_F(Replaying, repeatsOnRequest)
{
    const auto bus = open(kThree);
    ASSERT_TRUE(bus);
    (*bus)->setRepeats(true);
    std::size_t count = 0;
    for (int i = 0; i < 40; ++i) count += receive(**bus, 100ms);
    EXPECT_GE(count, 9U);
    (*bus)->setRepeats(false);
    for (int i = 0; i < 40; ++i) receive(**bus, 100ms);
    EXPECT_EQ((*bus)->state(), BusState::Ended);
}

}  // namespace
}  // namespace terratact
