// Tests the ticks of the window: a frozen window, and floods of frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/console/main_window.h"
#include "app/runtime/steady_now.h"
#include "core/wire/frame_layout.h"
#include "tests/support/benches/bus_console_bench.h"
#include "tests/support/gui.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

/// Frames on the bus while the window was frozen; times are those of the bus [s].
struct Freeze {
    double began = 0.0, ended = 0.0;
    std::vector<BusFrame> frames{};
    std::vector<double> timesOf(FrameKind kind) const
    {
        std::vector<double> times;
        for (const BusFrame& heard : frames)
            if (kindOfId(heard.frame.id) == kind && heard.time > began && heard.time <= ended)
                times.push_back(heard.time);
        return times;
    }
};

/// An end of a bus that records the thread serving it.
class ServedBus final : public CanBus {
public:
    ServedBus(std::unique_ptr<CanBus> bus, std::shared_ptr<std::atomic<pid_t>> thread)
        : bus_(std::move(bus)), thread_(std::move(thread))
    {
    }
    std::string name() const override { return bus_->name(); }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override
    {
        *thread_ = ::gettid();
        return bus_->receive(frames, patience);
    }
    Status send(const CanFrame& frame) override { return bus_->send(frame); }
    BusState state() const override { return bus_->state(); }
    BusCounters counters() const override { return bus_->counters(); }

private:
    std::unique_ptr<CanBus> bus_;
    std::shared_ptr<std::atomic<pid_t>> thread_;
};

/// Returns how long [s] a thread of this process waited for a processor, by the kernel's accounting; 0 if unknown.
double keptWaiting(pid_t thread)
{
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    double ran = 0.0, waited = 0.0;
    return file >> ran >> waited ? 1e-9 * waited : 0.0;
}

TEST_F(BusConsole, frozenWindowStopsTheDrive)
{
    constexpr int kGoes = 4;
    constexpr double kLimit = 0.1;  // [s]
    operatorAge = GateLimits{}.operatorAge;
    const auto recorder = bus.join("recorder", 0);
    const auto sender = std::make_shared<std::atomic<pid_t>>(0);
    startQuickRobot();
    window = console(std::make_unique<ServedBus>(bus.join("can0"), sender),
                     CanSource::Mode::Transmit, [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    int judged = 0, strictly = 0;
    for (int go = 0; go < 40 && (judged < kGoes || 2 * strictly < judged) && !HasFailure(); ++go) {
        if (!drives()) continue;
        Freeze freeze;
        freeze.began = steadyNow();
        const double waited = keptWaiting(*sender);
        std::this_thread::sleep_for(1s);  // this is the freeze: the window's thread does nothing
        const double kept = keptWaiting(*sender) - waited;
        freeze.ended = steadyNow();
        freeze.frames = framesOf(*recorder);
        // On a busy machine a delay of 100 ms may have ended the drive before.
        const std::vector<double> drives = freeze.timesOf(FrameKind::Drive);
        if (drives.empty()) continue;
        ++judged;
        double last = 0.0;  // time of the last drive frame since the freeze began
        for (const FrameKind kind : {FrameKind::Drive, FrameKind::ConsoleHeartbeat})
            for (const double at : freeze.timesOf(kind)) last = std::max(last, at - freeze.began);
        // The sending thread may have waited for a processor between reading the clock and sending.
        EXPECT_LE(last, kLimit + kept);
        EXPECT_LE(static_cast<double>(drives.size()), kLimit / ConsoleLink::kDrivePeriod + 2.0);
        strictly += last <= kLimit;
        const std::vector<double> disarmings = freeze.timesOf(FrameKind::Arm);
        ASSERT_EQ(disarmings.size(), 1U) << "while the window stood still";
        EXPECT_GT(disarmings.front(), drives.back());
        EXPECT_TRUE(robotIs(RobotActivity::Halted));
        QTest::keyRelease(window.get(), Qt::Key_W);
        EXPECT_EQ(arming(), ArmingPhase::Disarmed);
    }
    EXPECT_GE(judged, kGoes) << "it hardly ever drove into a freeze";
    EXPECT_GE(2 * strictly, judged)
        << "later than " << kLimit << " s in most of " << judged << " goes";
}

/// Counts the wake-ups of the window's thread (queued calls), not the work of a call.
class Posts final : public QObject {
public:
    Posts() { qApp->installEventFilter(this); }
    /// Delivers the pending calls and returns their number.
    int consume()
    {
        count_ = 0;
        QCoreApplication::sendPostedEvents();
        return count_;
    }

protected:
    bool eventFilter(QObject* /*receiver*/, QEvent* event) override
    {
        if (event->type() == QEvent::MetaCall) ++count_;
        return false;
    }

private:
    int count_ = 0;
};

TEST_F(BusConsole, aFloodOfFramesIsNoFloodOfSignals)
{
    constexpr std::uint64_t kFlood = 20'000;
    open(CanSource::Mode::Listen);
    ASSERT_TRUE(eventually([&] { return !modelInUse(*window).isEmpty(); }));
    Posts posts;
    // The window's thread does nothing else while all frames are read.
    (void)posts.consume();
    const std::uint64_t before = window->link()->view().frames.received;
    for (std::uint64_t i = 0; i < kFlood; ++i)
        bus.put({.id = 0x100 + static_cast<std::uint32_t>(i % 200), .length = 8, .data = {}});
    for (const double end = steadyNow() + 60.0; steadyNow() < end;) {
        if (window->link()->view().frames.received >= before + kFlood) break;
        std::this_thread::sleep_for(1ms);  // no event tells it, and the event loop must stand still
    }
    ASSERT_GE(window->link()->view().frames.received, before + kFlood);
    EXPECT_LT(posts.consume(), 20) << "for " << kFlood << " frames";
}

TEST_F(BusConsole, aFloodOfTelemetryIsNoFloodOfSignalsNorOfPictures)
{
    constexpr int kFlood = 5000;
    constexpr double kPictures = 25.0;  // [Hz]
    /// A source of some thousand telemetry lines a second, all different, as many as requested.
    struct Burst final : MeasurementSource {
        std::atomic<int> left = 1;
        std::string name() const override { return "BURST"; }
        Result<std::optional<Sample>> next(std::chrono::milliseconds) override
        {
            std::this_thread::sleep_for(50us);  // the rate of the flood
            if (left.load() == 0) return std::optional<Sample>{};
            Sample sample;
            sample.measurement.pitch = 0.01 * (--left % 10);
            left.notify_all();
            return std::optional(sample);
        }
        Status send(const Command&) override { return Done{}; }
    };
    MainWindow::Options options;
    options.robot = model;
    auto source = std::make_unique<Burst>();
    std::atomic<int>& left = source->left;
    options.source = std::move(source);
    options.model = [] { return Result<LoadedModel>(madeUp()); };
    window = std::make_unique<MainWindow>(std::move(options));
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return !modelInUse(*window).isEmpty() && left == 0; }));
    Posts posts;
    (void)posts.consume();
    left = kFlood;
    for (int rest = left; rest > 0; rest = left) left.wait(rest);  // the event loop stands still
    EXPECT_LT(posts.consume(), 20) << "for " << kFlood << " lines";

    const double began = steadyNow();
    const auto pictures = window->meter().frames().count();
    const auto lines = window->acquisition().latest()->count;
    left = std::numeric_limits<int>::max();
    QTest::qWait(1000);  // pictures in a second of the real clock are limited
    left = 0;
    EXPECT_LE(static_cast<double>(window->meter().frames().count() - pictures),
              kPictures * (steadyNow() - began) + 2.0);
    EXPECT_GT(window->acquisition().latest()->count, lines + 100);
}

}  // namespace
}  // namespace terratact
