// Tests the ticks of the window: a frozen window, and floods of frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
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

/// A frame that an end sent, and the time [s] by which that was decided.
struct Sent {
    FrameKind kind{};
    double time = 0.0;
};

/// An end of a bus that keeps what it sends.
class KeptBus final : public CanBus {
public:
    KeptBus(std::unique_ptr<CanBus> bus, const PatientClock& clock)
        : bus_(std::move(bus)), clock_(clock)
    {
    }
    std::string name() const override { return bus_->name(); }
    Result<std::size_t> receive(std::span<BusFrame> frames,
                                std::chrono::milliseconds patience) override
    {
        return bus_->receive(frames, patience);
    }
    Status send(const CanFrame& frame) override
    {
        const std::scoped_lock lock(mutex_);
        if (const auto kind = kindOfId(frame.id)) sent_.push_back({*kind, clock_.lastRead()});
        return bus_->send(frame);
    }
    BusState state() const override { return bus_->state(); }
    BusCounters counters() const override { return bus_->counters(); }
    /// Returns the times of these frames after a time.
    std::vector<double> timesOf(FrameKind kind, double after) const
    {
        const std::scoped_lock lock(mutex_);
        std::vector<double> times;
        for (const Sent& sent : sent_)
            if (sent.kind == kind && sent.time > after) times.push_back(sent.time);
        return times;
    }

private:
    std::unique_ptr<CanBus> bus_;
    const PatientClock& clock_;
    mutable std::mutex mutex_;  // guards the member below
    std::vector<Sent> sent_;
};

TEST_F(BusConsole, frozenWindowStopsTheDrive)
{
    constexpr double kLimit = 0.1;  // [s]
    const auto recorder = bus.join("recorder", 0);
    startQuickRobot();
    auto end = std::make_unique<KeptBus>(bus.join("can0"), clock);
    const KeptBus& kept = *end;
    window = console(std::move(end), CanSource::Mode::Transmit,
                     [] { return Result<LoadedModel>(madeUp()); });
    gui::showActive(*window);
    ASSERT_TRUE(drives());
    (void)framesOf(*recorder);
    const double began = clock.now();
    clock.leave();
    std::this_thread::sleep_for(1s);  // this is the freeze: the window's thread does nothing
    const std::vector<double> driven = kept.timesOf(FrameKind::Drive, began);
    const std::vector<double> beats = kept.timesOf(FrameKind::ConsoleHeartbeat, began);
    const std::vector<double> disarmings = kept.timesOf(FrameKind::Arm, began);
    ASSERT_FALSE(driven.empty());
    for (const std::vector<double>& times : {driven, beats})
        for (const double at : times) EXPECT_LE(at, began + kLimit);
    EXPECT_LE(static_cast<double>(driven.size()), kLimit / ConsoleLink::kDrivePeriod + 2.0);
    ASSERT_EQ(disarmings.size(), 1U) << "while the window stood still";
    EXPECT_GT(disarmings.front(), driven.back());
    bool isDisarmed = false;
    for (const BusFrame& heard : framesOf(*recorder)) {
        const auto kind = kindOfId(heard.frame.id);
        EXPECT_FALSE(isDisarmed && kind == FrameKind::Drive) << "on the bus, behind the disarming";
        isDisarmed = isDisarmed || kind == FrameKind::Arm;
    }
    EXPECT_TRUE(isDisarmed);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
    QTest::keyRelease(window.get(), Qt::Key_W);
    EXPECT_EQ(arming(), ArmingPhase::Disarmed);
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
        std::this_thread::sleep_for(1ms);  // no event reports it, and the event loop must not run
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
