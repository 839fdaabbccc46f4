// Tests console and robot as separate processes on a CAN bus of a real kernel.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/link/can_source.h"
#include "app/link/panel_reader.h"
#include "app/link/robot_service.h"
#include "app/runtime/steady_now.h"
#include "core/atem/probe/arm_choice.h"
#include "core/infer/estimator.h"
#include "core/learn/model/file/model_file.h"
#include "core/sim/ground/terrain_shapes.h"
#include "drivers/socketcan.h"
#include "tests/kernel/support.h"
#include "tests/support/absolem.h"
#include "tests/support/devices/gpio_sim.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

constexpr const char* kBus = "vcan0";
constexpr double kWayToTheStep =
    0.65;  // [m] distance at which the simulated robot's flippers touch the step

/// Returns the repetitions of slow steps: TERRATACT_REPEATS=100 for the long run.
int repeats(int few)
{
    const char* const text = std::getenv("TERRATACT_REPEATS");
    return text ? std::atoi(text) : few;
}

/// A process that is ended with this object.
class Process {
public:
    explicit Process(const std::function<void()>& run) : pid_(::fork())
    {
        if (pid_ != 0) return;
        run();
        ::_exit(0);
    }
    explicit Process(std::vector<std::string> command) : pid_(::fork())
    {
        if (pid_ != 0) return;
        std::vector<char*> arguments;
        for (std::string& word : command) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    ~Process() { end(SIGKILL); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void end(int signal)
    {
        if (pid_ <= 0) return;
        ::kill(pid_, signal);
        ::waitpid(pid_, nullptr, 0);
        pid_ = 0;
    }

private:
    pid_t pid_;
};

std::unique_ptr<SocketCan> openBus(bool transmit)
{
    auto bus = SocketCan::open({.interface = kBus, .transmit = transmit});
    if (!bus) throw std::runtime_error(bus.error().text);
    return *std::move(bus);
}

/// A console without a window: its source, the reading thread, and a present operator.
class Console {
public:
    Console()
        : source(openBus(true), absolem(), {.mode = CanSource::Mode::Transmit}),
          reader_([this](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  const auto next = source.next(20ms);
                  if (!next || !*next) continue;
                  const std::scoped_lock lock(mutex_);
                  latest_ = (*next)->measurement;
              }
          })
    {
    }

    template <class Condition>
    bool eventually(Condition condition, double seconds = 30.0)
    {
        for (const double end = steadyNow() + seconds; steadyNow() < end;) {
            source.operatorAlive();
            if (condition()) return true;
            std::this_thread::sleep_for(5ms);
        }
        return false;
    }
    std::optional<Measurement> latest() const
    {
        const std::scoped_lock lock(mutex_);
        return latest_;
    }
    bool does(RobotActivity activity)
    {
        return eventually([&] {
            const auto now = latest();
            return now && now->activity == activity;
        });
    }
    bool arms()
    {
        if (!eventually([&] { return !whyNotArming(source.view()); })) return false;
        const double began = steadyNow();
        (void)eventually(
            [&] { return steadyNow() - began > 0.5; });  // waits for the robot's ten heartbeats
        source.wantArming();
        if (!is(ArmingPhase::Confirming)) return false;
        source.confirmArming();
        return is(ArmingPhase::Armed);
    }
    bool is(ArmingPhase phase)
    {
        return eventually([&] { return source.view().link.arming.phase == phase; }, 5.0);
    }

    CanSource source;

private:
    mutable std::mutex mutex_;
    std::optional<Measurement> latest_;
    std::jthread reader_;
};

/// A receive-only bus end: collects every frame until a condition is true.
class Listener {
public:
    Listener() : bus_(openBus(false)) {}

    bool until(const std::function<bool(const BusFrame&)>& condition, double seconds)
    {
        for (const double end = steadyNow() + seconds; steadyNow() < end;) {
            const auto count = bus_->receive(frames_, 20ms);
            if (!count) throw std::runtime_error(count.error().text);
            bool holds = false;
            for (std::size_t i = 0; i < *count; ++i) holds = condition(frames_[i]) || holds;
            if (holds) return true;
        }
        return false;
    }
    bool untilRobotIs(RobotActivity activity, double seconds)
    {
        return until([&](const BusFrame& frame) { return activityOf(frame) == activity; }, seconds);
    }
    static std::optional<RobotActivity> activityOf(const BusFrame& frame)
    {
        const auto content = unpack(frame.frame);
        if (!std::holds_alternative<Unpacked>(content)) return std::nullopt;
        const auto status = statusOf(std::get<Unpacked>(content));
        return status ? std::optional(status->activity) : std::nullopt;
    }

private:
    std::unique_ptr<SocketCan> bus_;
    std::array<BusFrame, 64> frames_;
};

std::vector<std::string> robotCommand(std::vector<std::string> more = {})
{
    std::vector<std::string> command{TERRATACT_CLI, "robot", "--can", kBus};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

struct RobotLink : testing::Test {
    static void SetUpTestSuite()
    {
        if (!SocketCan::open({.interface = kBus})) return;
        available = true;
    }
    void SetUp() override
    {
        if (!available) GTEST_SKIP() << "this kernel has no CAN: run it with tests/kernel/run.sh";
    }
    static inline bool available = false;
};

TEST_F(RobotLink, carriesAWholeExplorationBetweenTwoProcesses)
{
    const auto stored = readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    ASSERT_TRUE(stored);
    const Models models(stored->data, absolem());
    const Settings settings;

    // Writes the bus's log to $TERRATACT_CANDUMP, for decoding.
    std::optional<Process> log;
    if (const char* const file = std::getenv("TERRATACT_CANDUMP"))
        log.emplace(std::vector<std::string>{"sh", "-c",
                                             std::string("exec candump -L ") + kBus + " >" + file});
    const Process robot(robotCommand({"--speed", "10"}));
    Console console;
    ASSERT_TRUE(console.arms());

    const auto travelled = [&] { return console.latest()->travelled.value(); };
    const double start = travelled();
    ASSERT_TRUE(console.source.send(DriveCommand{0.03}));
    ASSERT_TRUE(console.does(RobotActivity::Driving));
    // Drives to the demo's step by the robot's odometry, because a late tick shortens the drive.
    ASSERT_TRUE(console.eventually([&] { return travelled() - start > kWayToTheStep; }));
    ASSERT_TRUE(console.source.send(HaltCommand{}));
    ASSERT_TRUE(console.does(RobotActivity::Halted));

    ASSERT_TRUE(console.source.send(BeginAtemCommand{}));
    ASSERT_TRUE(console.eventually([&] { return console.source.view().link.robot->exploring; }));
    ASSERT_TRUE(console.source.send(PressCommand{18.0}));
    ASSERT_TRUE(console.does(RobotActivity::Pressed));

    const TerrainEstimate first =
        estimateTerrain(proprioception(*console.latest()), {}, absolem(), models, settings);
    const auto bin = chooseProbe(first, absolem());
    ASSERT_TRUE(bin) << "nothing uncertain in reach after " << travelled() - start << " m";
    console.source.approve({*bin});
    ASSERT_TRUE(console.source.send(ProbeCommand{*bin}));
    ASSERT_TRUE(console.does(RobotActivity::Probing));
    ASSERT_TRUE(console.eventually([&] { return console.latest()->arm.has_value(); }));
    const ArmReading reading = *console.latest()->arm;
    EXPECT_EQ(reading.bin, *bin);
    const TerrainEstimate second = estimateTerrain(
        proprioception(*console.latest()), std::array{reading}, absolem(), models, settings);
    const auto i = static_cast<std::size_t>(*bin);
    EXPECT_EQ(second.origin[i], Origin::Arm);
    EXPECT_LT(second.sd[i], first.sd[i]);

    ASSERT_TRUE(console.source.send(AbortAtemCommand{}));
    ASSERT_TRUE(console.eventually([&] { return !console.source.view().link.robot->exploring; }));
    console.source.disarm();
    EXPECT_TRUE(console.is(ArmingPhase::Disarmed));
    const CanView view = console.source.view();
    EXPECT_EQ(view.telemetry.of(FrameFault::WrongCrc), 0U);
    EXPECT_EQ(view.frames.dropped, 0U);
    std::printf("probe at bin %d: sd %.0f mm before, %.0f mm after; %llu frames heard, %llu sent\n",
                *bin, 1e3 * first.sd[i], 1e3 * second.sd[i],
                static_cast<unsigned long long>(view.frames.received),
                static_cast<unsigned long long>(view.frames.sent));
    if (log) log->end(SIGINT);
}

TEST_F(RobotLink, robotHaltsWithin300MillisecondsOfAKilledConsole)
{
    const int times = repeats(3);
    const Process robot(robotCommand({"--speed", "0.1"}));
    std::vector<double> halts;
    for (int i = 0; i < times; ++i) {
        Process console([] {
            Console commanding;
            if (!commanding.arms() || !commanding.source.send(DriveCommand{0.02})) return;
            (void)commanding.eventually([] { return false; }, 3600.0);
        });
        Listener listener;
        ASSERT_TRUE(listener.untilRobotIs(RobotActivity::Driving, 30.0)) << "run " << i;
        std::this_thread::sleep_for(std::chrono::milliseconds(100 + 37 * (i % 7)));
        const double killed = steadyNow();
        console.end(SIGKILL);
        std::optional<double> halted;
        ASSERT_TRUE(listener.until(
            [&](const BusFrame& frame) {
                if (!halted && frame.time > killed
                    && Listener::activityOf(frame) == RobotActivity::Halted)
                    halted = frame.time;
                return halted.has_value();
            },
            5.0));
        halts.push_back(*halted - killed);
    }
    const auto [best, worst] = std::minmax_element(halts.begin(), halts.end());
    std::printf("%d kills: the status said halted after %.0f to %.0f ms\n", times, 1e3 * *best,
                1e3 * *worst);
    // The watchdog acts 250 ms after the last drive, and the status follows within one period.
    EXPECT_LE(*worst, 0.35);
    EXPECT_LE(std::count_if(halts.begin(), halts.end(), [](double s) { return s > 0.3; }),
              times / 3);
}

TEST_F(RobotLink, stalledBusReplaysTwoFramesAndRobotAcceptsNone)
{
    const Process robot(robotCommand({"--speed", "0.1"}));
    Console console;
    ASSERT_TRUE(console.arms());
    ASSERT_TRUE(console.source.send(DriveCommand{0.02}));
    ASSERT_TRUE(console.does(RobotActivity::Driving));

    Listener listener;
    stall(kBus, 100'000);
    const double stalled = steadyNow();
    ASSERT_TRUE(
        console.eventually([&] { return console.source.view().bus == BusState::Stalled; }, 2.0));
    ASSERT_TRUE(console.is(ArmingPhase::Disarmed));
    while (steadyNow() - stalled < 2.0) {
        console.source.operatorAlive();
        (void)console.source.send(DriveCommand{0.02});
        std::this_thread::sleep_for(20ms);
    }
    (void)listener.until([](const BusFrame&) { return false; }, 0.2);  // drops earlier frames
    letGo(kBus);
    int drives = 0, commands = 0, driving = 0;
    (void)listener.until(
        [&](const BusFrame& frame) {
            commands += !frame.frame.error && frame.frame.id >= 16 && frame.frame.id <= 26;
            drives += frame.frame.id == 20;
            driving +=
                frame.time > stalled + 2.5 && Listener::activityOf(frame) == RobotActivity::Driving;
            return false;
        },
        2.0);
    shell("tc qdisc del dev vcan0 root");
    std::printf("after 2 s of a stalled bus: %d drives replayed, %d commands in all\n", drives,
                commands);
    EXPECT_LE(drives, 2);
    EXPECT_EQ(driving, 0) << "the robot took one of them";
    ASSERT_TRUE(console.does(RobotActivity::Halted));
    EXPECT_EQ(console.source.view().link.arming.phase, ArmingPhase::Disarmed);
}

std::string told(const PanelReport& panel, const CanView& link)
{
    std::ostringstream text;
    text << "panel " << (panel.state.present ? "present" : "absent") << ", stop "
         << panel.state.stop << ", edges " << panel.counters.edges[PanelContact::Stop] << ", lost "
         << panel.counters.lostEdges << ", trouble '" << panel.trouble.english() << "'; "
         << describe(link.bus, kBus).english() << "; sent " << link.frames.sent << ", confirmed "
         << link.frames.confirmed << ", not sent " << link.frames.notSent << ", dropped "
         << link.frames.dropped;
    return text.str();
}

TEST_F(RobotLink, stopOfThePanelReachesTheBus)
{
    if (!GpioSim::available()) GTEST_SKIP() << "this kernel has no gpio-sim";
    const std::vector<std::string> names{"ATEM", "APPROVE", "REFUSE",  "STOP",
                                         "LINK", "ARMED",   "PROBING", "BUZZER"};
    GpioSim chip("panel-stop", names);
    PanelConfig config;
    config.chipLabel = "panel-stop";
    for (std::size_t i = 0; i < kPanelContacts; ++i) config.inputs.values[i].line.name = names[i];
    for (std::size_t i = 0; i < kPanelOutputs; ++i)
        config.outputs[i].line.name = names[kPanelContacts + i];
    constexpr std::size_t kStop = 3;

    const Process robot(robotCommand());
    Console console;
    PanelReader panel(std::make_unique<OperatorPanel>(config, openGpioLines), console.source);
    // The request opens all contacts; then STOP is closed, its state at rest.
    ASSERT_TRUE(console.eventually([&] { return panel.latest().state.present; }))
        << panel.latest().trouble.english();
    chip.drive(kStop, false);
    ASSERT_TRUE(console.eventually([&] { return !panel.latest().state.stop; }))
        << panel.latest().trouble.english();
    Listener listener;
    const int times = repeats(20);
    for (int i = 0; i < times; ++i) {
        chip.drive(kStop, true);
        ASSERT_TRUE(listener.until([](const BusFrame& frame) { return frame.frame.id == 16; }, 2.0))
            << "press " << i << ": " << told(panel.latest(), console.source.view());
        // The command is sent before the reader reports it, so the test waits for the report before releasing.
        ASSERT_TRUE(console.eventually([&] { return panel.latest().state.stop; }, 2.0));
        chip.drive(kStop, false);
        ASSERT_TRUE(console.eventually([&] { return !panel.latest().state.stop; }, 2.0));
    }
    EXPECT_TRUE(console.does(RobotActivity::Stopped));
    std::vector<double> latencies = panel.stopLatencies();
    ASSERT_EQ(latencies.size(), static_cast<std::size_t>(std::min(times, 1000)));
    std::sort(latencies.begin(), latencies.end());
    const auto at = [&](double share) {
        return 1e3
             * latencies[static_cast<std::size_t>(share
                                                  * static_cast<double>(latencies.size() - 1))];
    };
    std::printf(
        "STOP edge to the return of write(), %zu presses: p50 %.2f ms, p99 %.2f ms, max %.2f ms\n",
        latencies.size(), at(0.5), at(0.99), at(1.0));
    EXPECT_LT(latencies.back(), 1.0) << "a hang";
}

struct Faulty : RobotLink, testing::WithParamInterface<const char*> {};
TEST_P(Faulty, everyRobotFaultIsSurvivedAndIdentified)
{
    const Process robot(robotCommand({"--speed", "10", "--fault", GetParam()}));
    Console console;
    const std::string fault = GetParam();
    if (fault == "silence@2") {
        ASSERT_TRUE(console.eventually(
            [&] { return console.source.view().link.state == LinkState::Good; }));
        EXPECT_TRUE(console.eventually(
            [&] { return console.source.view().link.state == LinkState::Lost; }));
        return;
    }
    if (fault == "dead-element") {
        ASSERT_TRUE(console.eventually([&] { return console.latest().has_value(); }));
        EXPECT_EQ(console.source.view().forces.left[3]->state, ElementState::Open);
        return;
    }
    ASSERT_TRUE(console.arms());
    EXPECT_TRUE(console.is(ArmingPhase::Disarmed)) << "it rebooted";
}
INSTANTIATE_TEST_SUITE_P(Robot, Faulty, testing::Values("silence@2", "dead-element", "reboot@4"));

}  // namespace
}  // namespace terratact
