#include "app/link/can_source.h"

#include <gtest/gtest.h>

#include <mutex>
#include <thread>

#include "app/link/robot_in_process.h"
#include "app/runtime/steady_now.h"
#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

SimulatedRobot robotBeforeAStep()
{
    SimulatedRobot::Options options;
    options.startX = 1.5;
    options.probeSeconds = 2.0;
    return SimulatedRobot(absolem(), stepTerrain(0.24, 3.0, 6.0), options);
}

/// A console's source and a simulated robot in their own threads, with a present operator.
struct Link : testing::Test {
    explicit Link(CanSource::Mode mode = CanSource::Mode::Transmit)
        : robot(bus, absolem(), robotBeforeAStep(), {.speed = 4.0}),
          source(bus.join("console"), absolem(),
                 {.mode = mode, .truth = [this] { return robot.truth(); }}),
          reader([this](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  const auto next = source.next(50ms);
                  if (next && *next) {
                      const std::scoped_lock lock(mutex);
                      latest = (*next)->measurement;
                      truth = (*next)->truth;
                  }
              }
          })
    {
    }

    template <class Condition>
    bool eventually(Condition condition, double seconds = 20.0)
    {
        for (const double end = steadyNow() + seconds; steadyNow() < end;) {
            if (operatorThere) source.operatorAlive();
            if (condition()) return true;
            std::this_thread::sleep_for(10ms);  // between two polls of the condition
        }
        return false;
    }
    bool does(RobotActivity activity)
    {
        return eventually([&] {
            const std::scoped_lock lock(mutex);
            return latest && latest->activity == activity;
        });
    }
    bool is(ArmingPhase phase)
    {
        return eventually([&] { return source.view().link.arming.phase == phase; });
    }
    void arm()
    {
        ASSERT_TRUE(eventually([&] { return !whyNotArming(source.view()); }))
            << whyNotArming(source.view())->english();
        // The robot also needs ten heartbeats first.
        ASSERT_TRUE(eventually([&, began = steadyNow()] { return steadyNow() - began > 0.5; }));
        source.wantArming();
        ASSERT_TRUE(is(ArmingPhase::Confirming));
        source.confirmArming();
        ASSERT_TRUE(is(ArmingPhase::Armed));
    }

    MemoryBus bus{steadyNow};
    RobotInProcess robot;
    CanSource source;
    std::mutex mutex;
    std::optional<Measurement> latest;
    std::optional<Heights> truth;
    bool operatorThere = true;
    std::jthread reader;
};

TEST_F(Link, carriesAWholeExplorationWithAProbe)
{
    arm();
    ASSERT_TRUE(source.send(BeginAtemCommand{}));
    ASSERT_TRUE(eventually([&] { return source.view().link.robot->exploring; }));
    ASSERT_TRUE(source.send(PressCommand{18.0}));
    ASSERT_TRUE(does(RobotActivity::Pressed));
    constexpr int kBin06 = 9;
    EXPECT_FALSE(source.send(ProbeCommand{kBin06})) << "nobody approved it";
    source.approve({kBin06});
    ASSERT_TRUE(source.send(ProbeCommand{kBin06}));
    ASSERT_TRUE(does(RobotActivity::Probing));
    ASSERT_TRUE(eventually([&] {
        const std::scoped_lock lock(mutex);
        return latest->arm && latest->arm->bin == kBin06;
    }));
    ASSERT_TRUE(source.send(AbortAtemCommand{}));
    EXPECT_TRUE(eventually([&] { return !source.view().link.robot->exploring; }));
}

TEST_F(Link, bringsTheTrueTerrainOfTheRobotsPose)
{
    const auto comes = [this](const Heights& heights) {
        return eventually([&] {
            const std::scoped_lock lock(mutex);
            return truth == heights;
        });
    };
    EXPECT_TRUE(comes(robotBeforeAStep().truth()));
    arm();
    ASSERT_TRUE(source.send(DriveCommand{0.2}));
    EXPECT_TRUE(eventually([&] {
        const std::scoped_lock lock(mutex);
        return truth->back() - truth->front() > 0.2;  // true height of the step ahead
    }));
    ASSERT_TRUE(source.send(HaltCommand{}));
    ASSERT_TRUE(does(RobotActivity::Halted));
    EXPECT_TRUE(comes(robot.truth().middle));
}

TEST(CanSourceTruth, isAbsentWithoutASimulatedRobot)
{
    MemoryBus bus{steadyNow};
    const RobotInProcess robot(bus, absolem(), robotBeforeAStep(), {});
    CanSource source(bus.join("console"), absolem(), {});
    const auto next = source.next(20s);
    ASSERT_TRUE(next && *next);
    EXPECT_FALSE((*next)->truth);
}

TEST_F(Link, deadManEndsADriveWhenTheOperatorIsAbsent)
{
    arm();
    ASSERT_TRUE(source.send(DriveCommand{0.2}));
    ASSERT_TRUE(does(RobotActivity::Driving));
    operatorThere = false;
    EXPECT_TRUE(does(RobotActivity::Halted));
    EXPECT_TRUE(is(ArmingPhase::Disarmed));
}

TEST_F(Link, stopsARobotThatIsNotArmed)
{
    ASSERT_TRUE(eventually([&] { return source.view().link.state == LinkState::Good; }));
    ASSERT_TRUE(source.send(StopCommand{}));
    EXPECT_TRUE(does(RobotActivity::Stopped));
    ASSERT_TRUE(eventually([&] { return source.view().link.goodFor > 0.0; }));
    ASSERT_TRUE(source.send(ReleaseStopCommand{}));
    EXPECT_TRUE(does(RobotActivity::Halted));
}

TEST_F(Link, sendsStopAsSoonAsTheBusIsBack)
{
    arm();
    bus.setState(BusState::Down, "console");
    EXPECT_FALSE(source.send(StopCommand{}));
    ASSERT_TRUE(is(ArmingPhase::Disarmed));
    bus.setState(BusState::Up, "console");
    EXPECT_TRUE(does(RobotActivity::Stopped));
}

TEST_F(Link, sendsStopWhateverWasCommandedAfterIt)
{
    arm();
    bus.setState(BusState::Down, "console");
    EXPECT_FALSE(source.send(StopCommand{}));
    EXPECT_FALSE(source.send(DriveCommand{0.1})) << "refused by the gate";
    EXPECT_FALSE(source.send(HaltCommand{})) << "a stop is more than that";
    bus.setState(BusState::Up, "console");
    EXPECT_TRUE(does(RobotActivity::Stopped));
}

TEST_F(Link, sendsDisarmAsSoonAsTheBusIsBack)
{
    arm();
    bus.setState(BusState::BusOff, "console");  // the console receives, but cannot send
    source.disarm();
    ASSERT_TRUE(is(ArmingPhase::Disarmed));
    bus.setState(BusState::Up, "console");  // before the robot's watchdog expires
    EXPECT_TRUE(eventually([&] { return !source.view().link.robot->armed; }, 5.0));
}

TEST_F(Link, showsThatTheBusIsDown)
{
    bus.setState(BusState::Down, "console");
    EXPECT_TRUE(eventually([&] { return source.view().bus == BusState::Down; }));
}

struct Listening : Link {
    Listening() : Link(CanSource::Mode::Listen) {}
};
TEST_F(Listening, sendsNothingAtAll)
{
    ASSERT_TRUE(eventually([&] {
        const std::scoped_lock lock(mutex);
        return latest.has_value();
    }));
    const Status sent = source.send(StopCommand{});
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().text, "console is receive-only: start the console with --transmit");
    source.disarm();
    EXPECT_EQ(source.view().frames.sent, 0U);
    EXPECT_TRUE(whyNotArming(source.view()));
}

}  // namespace
}  // namespace terratact
