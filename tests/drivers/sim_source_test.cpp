#include "drivers/sim_source.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <thread>

#include "core/sim/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

SimulatedRobot robotOnFlatGround()
{
    SimulatedRobot::Options options;
    options.startX = 2.0;
    return {absolem(), flatTerrain(8.0), options};
}

Sample nextOf(SimSource& source)
{
    for (;;) {
        auto next = source.next(1s);
        if (!next) throw std::runtime_error(next.error().text);
        if (*next) return **next;
    }
}

TEST(SimSource, saysWhatItIs)
{
    const SimSource source(robotOnFlatGround());
    EXPECT_EQ(source.name(), "SIMULATED ROBOT");
}

TEST(SimSource, deliversTwentyLinesASecond)
{
    SimSource source(robotOnFlatGround());
    (void)nextOf(source);
    const Clock::time_point begin = Clock::now();
    double last = 0.0;
    for (int i = 0; i < 10; ++i) {
        const Sample sample = nextOf(source);
        EXPECT_GT(sample.measurement.time, last);
        last = sample.measurement.time;
        ASSERT_TRUE(sample.truth);
    }
    EXPECT_GE(Clock::now() - begin, 9 * SimSource::kPeriod) << "never faster than the period";
}

TEST(SimSource, aTimeoutIsAnEmptyAnswer)
{
    SimSource source(robotOnFlatGround());
    (void)nextOf(source);
    const auto next = source.next(1ms);
    ASSERT_TRUE(next);
    EXPECT_FALSE(next->has_value());
}

TEST(SimSource, passesSimulatedTimeFasterWhenAsked)
{
    SimSource source(robotOnFlatGround(), 20.0);
    const double before = nextOf(source).measurement.time;
    EXPECT_NEAR(nextOf(source).measurement.time - before, 1.0, 0.96)
        << "a second per line, less on a busy machine";
    EXPECT_GT(nextOf(source).measurement.time, before);
}

TEST(SimSource, obeysFromTheNextLineOn)
{
    SimSource source(robotOnFlatGround());
    EXPECT_EQ(nextOf(source).measurement.activity, RobotActivity::Halted);
    ASSERT_TRUE(source.send(DriveCommand{.speed = 0.2}));
    EXPECT_EQ(nextOf(source).measurement.activity, RobotActivity::Driving);
    ASSERT_TRUE(source.send(StopCommand{}));
    EXPECT_EQ(nextOf(source).measurement.activity, RobotActivity::Stopped);
    ASSERT_TRUE(source.send(DriveCommand{.speed = 0.2}));
    EXPECT_EQ(nextOf(source).measurement.refusal, Refusal::StopLatched);
}

TEST(SimSource, takesCommandsWhileAnotherThreadReads)
{
    SimSource source(robotOnFlatGround(), 5.0);
    std::jthread reader([&source](const std::stop_token& stop) {
        while (!stop.stop_requested()) (void)source.next(10ms);
    });
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(source.send(DriveCommand{.speed = i % 2 == 0 ? 0.1 : -0.1}));
        ASSERT_TRUE(source.send(HaltCommand{}));
    }
    reader.request_stop();
    reader.join();
    EXPECT_EQ(nextOf(source).measurement.activity, RobotActivity::Halted);
}

TEST(SimSource, refusesASpeedThatIsNone)
{
    for (const double speed : {0.0, -1.0, 1001.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(SimSource(robotOnFlatGround(), speed), std::invalid_argument) << speed;
}

}  // namespace
}  // namespace terratact
