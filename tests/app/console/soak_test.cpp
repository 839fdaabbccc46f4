// Measures the cost of the whole console: on a full bus with estimates and recording, with telemetry alone, at start.
// TERRATACT_SOAK_SECONDS sets the duration. Only then do the promised limits apply, on an idle machine with two cores.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QApplication>
#include <QEventLoop>
#include <QTimer>
#include <atomic>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "app/console/pages/diagnostics_page.h"
#include "app/pages/plots_page.h"
#include "app/recording/session_recorder.h"
#include "app/runtime/big_blocks.h"
#include "app/runtime/resources.h"
#include "app/runtime/steady_now.h"
#include "tests/support/benches/arming.h"
#include "tests/support/benches/loop_beat.h"
#include "tests/support/benches/robot_on_bench.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kFramesPerSecond = 9000;
constexpr double kHangGuard = 120.0;  // [s]
constexpr double kOneEstimate =
    2.0;  // [s] on both cores per request, unless a newer one replaces it

/// Runs the event loop like the program, which wakes for every event. QTest::qWait() sleeps 10 ms between polls.
void runFor(std::chrono::milliseconds time)
{
    QEventLoop loop;
    QTimer::singleShot(time, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Sends frames of other nodes in its own thread, as many as fill a bus of 1 Mbit/s.
class OtherNodes {
public:
    explicit OtherNodes(MemoryBus& bus)
        : thread_([&bus](const std::stop_token& stop) {
              const Clock::time_point began = Clock::now();
              for (long sent = 0; !stop.stop_requested();) {
                  const double seconds =
                      std::chrono::duration<double>(Clock::now() - began).count();
                  for (; static_cast<double>(sent) < seconds * kFramesPerSecond; ++sent)
                      bus.put({.id = 0x100 + static_cast<std::uint32_t>(sent % 200),
                               .length = 8,
                               .data = {static_cast<std::uint8_t>(sent)}});
                  std::this_thread::sleep_for(1ms);  // the load is a rate of the real clock
              }
          })
    {
    }

private:
    std::jthread thread_;
};

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Method method()
{
    const std::string wanted = qEnvironmentVariable("TERRATACT_SOAK_METHOD").toStdString();
    return methodFromName(wanted).value_or(Method::Pafac);
}

QualityPreset preset()
{
    const std::string wanted = qEnvironmentVariable("TERRATACT_SOAK_QUALITY").toStdString();
    return qualityPresetFromName(wanted).value_or(QualityPreset::Balanced);
}

double mostMemory()  // [MB]
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
}

/// Runs the shipped model repeatedly at the console's quality (or TERRATACT_SOAK_METHOD and _QUALITY), sampling on all
/// cores.
struct Busy {
    std::atomic<double> seconds = 0.0;
    std::atomic<int> estimates = 0;

    ModelLoader loader(const RobotModel& robot)
    {
        return [this, load = modelFileLoader(resourcePath("models/default.ttm"), robot)] {
            Result<LoadedModel> model = load();
            if (!model) return model;
            const Estimator estimate = model->estimate;
            model->estimate = [this, estimate](EstimateRequest request, const Watch& watch) {
                request.settings.method = method();
                request.settings = withPreset(request.settings, preset());
                const double began = steadyNow();
                struct Count {
                    Busy& busy;
                    double began;
                    ~Count() { busy.seconds = busy.seconds + steadyNow() - began; }
                } const count{*this, began};
                TwoTrackEstimate last = estimate(request, watch);
                for (++estimates; steadyNow() - began < kOneEstimate; ++estimates) {
                    if (watch.cancelled()) throw Cancelled{};
                    last = estimate(request, watch);
                }
                return last;
            };
            return model;
        };
    }
};

/// Returns the age of the process [s], with a resolution of 0.01 s.
double processAge()
{
    std::ifstream file("/proc/self/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::istringstream fields(text.substr(text.rfind(')') + 2));  // from the third field on
    std::string began;
    for (int field = 3; field <= 22; ++field) fields >> began;
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec)
         - std::stod(began) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double wantedSeconds()
{
    return qEnvironmentVariable("TERRATACT_SOAK_SECONDS").toDouble();
}

/// Times and counts of the robot's telemetry lines.
struct Lines {
    std::atomic<double> pressed = 0.0;  ///< time when the newest scene was complete
    std::atomic<bool> isPressing =
        false;                      ///< true from the press command until the scene is complete
    std::atomic<int> pressing = 0;  ///< lines during that time
};

class TimedSource final : public MeasurementSource {
public:
    TimedSource(std::unique_ptr<MeasurementSource> source, Lines& lines)
        : source_(std::move(source)), lines_(lines)
    {
    }
    std::string name() const override { return source_->name(); }
    Result<std::optional<Sample>> next(std::chrono::milliseconds patience) override
    {
        auto sample = source_->next(patience);
        if (!sample || !*sample) return sample;
        const RobotActivity activity = (*sample)->measurement.activity;
        if (activity == RobotActivity::Pressed && before_ != RobotActivity::Pressed)
            lines_.pressed = steadyNow();
        if (activity == RobotActivity::Pressed) lines_.isPressing = false;
        if (lines_.isPressing) ++lines_.pressing;
        before_ = activity;
        return sample;
    }
    Status send(const Command& command) override
    {
        if (std::holds_alternative<PressCommand>(command)) {
            lines_.isPressing = true;
            ++lines_.pressing;  // the newest earlier line is previewed, too
        }
        return source_->send(command);
    }

private:
    std::unique_ptr<MeasurementSource> source_;
    Lines& lines_;
    RobotActivity before_ = RobotActivity::Halted;
};

/// Calls back as soon as all changes of a window are painted.
class Painted final : public QObject {
public:
    Painted(QWidget& window, std::function<void()> then) : then_(std::move(then))
    {
        window.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* window, QEvent* event) override
    {
        if (event->type() != QEvent::UpdateRequest) return QObject::eventFilter(window, event);
        window->event(event);  // paints; later changes wait for the next paint
        then_();
        return true;
    }

private:
    std::function<void()> then_;
};

struct Soak : testing::Test, RobotOnBench {
    void open() { open(busy.loader(model)); }
    void open(ModelLoader loader)
    {
        giveBackBigBlocks();
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()));
        isRealTime = wantedSeconds() > 0.0;
        startRobot();
        recorder = std::make_shared<SessionRecorder>(
            SessionRecorder::Options{.folder = directory.file("sessions"), .start = {}});
        MainWindow::Options options =
            linked({.mode = CanSource::Mode::Transmit,
                    .bitrate = 1e6,
                    .received = [to = recorder](auto frames) { to->add(frames); }});
        options.source = std::make_unique<TimedSource>(std::move(options.source), lines);
        options.model = std::move(loader);
        options.recorder = recorder;
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1440, 900);
        gui::showActive(*window);
    }
    bool arms() { return terratact::arms(*window); }
    /// Starts the next exploration as soon as the last one has ended.
    void keepExploring()
    {
        Exploration& exploration = window->exploration();
        const AtemPhase phase = exploration.state().phase;
        if (phase == AtemPhase::Idle)
            exploration.request();
        else if (!exploring(phase) || phase == AtemPhase::ProposingProbe)
            exploration.abort();
    }

    /// Drives a little, which lifts the flippers and leads to a new scene.
    void driveOn()
    {
        window->exploration().abort();
        runFor(100ms);
        QTest::keyPress(window.get(), Qt::Key_W);
        runFor(300ms);
        QTest::keyRelease(window.get(), Qt::Key_W);
        runFor(200ms);
    }

    void keepsUp(const std::function<void(int count)>& choosePage, double mostMegabytes);

    TemporaryDirectory directory;
    Busy busy;
    Lines lines;
    std::shared_ptr<SessionRecorder> recorder;
    std::unique_ptr<MainWindow> window;
};

QString spread(const char* what, const NewestValues& values)
{
    return QStringLiteral("%1: p50 %2 ms, p99 %3 ms, max %4 ms of %5\n")
        .arg(QLatin1String(what))
        .arg(values.quantile(0.5) * 1e3, 0, 'f', 2)
        .arg(values.quantile(0.99) * 1e3, 0, 'f', 2)
        .arg(values.most() * 1e3, 0, 'f', 2)
        .arg(values.count());
}

/// Fills the bus, explores and records; chooses a page eight times.
void Soak::keepsUp(const std::function<void(int count)>& choosePage, double mostMegabytes)
{
    const double wanted = wantedSeconds();
    const double seconds = wanted > 0.0 ? wanted : 3.0;
    open();
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    const OtherNodes others(bus);
    ASSERT_TRUE(arms());

    window->restartMeter();
    LoopBeat beat;
    const double began = steadyNow(), cpu = cpuSeconds(), estimating = busy.seconds;
    const std::uint64_t received = window->link()->view().frames.received;
    double nextPage = began;
    const auto isGoingOn = [&] {
        const double lasted = steadyNow() - began;
        const bool hasEstimated = busy.seconds > estimating;  // a busy machine presses late
        return lasted < seconds || (!hasEstimated && lasted < kHangGuard);
    };
    for (int page = 0; isGoingOn();) {
        runFor(50ms);
        keepExploring();
        if (steadyNow() < nextPage) continue;
        choosePage(page++);
        nextPage += seconds / 8.0;
    }
    const double elapsed = steadyNow() - began;
    beat.stop();
    const CanView view = window->link()->view();
    const double rate = static_cast<double>(view.frames.received - received) / elapsed;
    const LoopMeter& meter = window->meter();
    const double megabytes = residentMemory() / 1e6;
    std::printf("%s", qUtf8Printable(spread("an event waits", meter.lateness())
                                     + spread("a frame takes", meter.frames())
                                     + spread("telemetry to screen", meter.latencies())));
    std::printf("the loop's own time between two beats: p99 %.2f ms, max %.2f ms\n", beat.own(0.99),
                beat.own(1.0));
    std::printf("%.0f s: %.0f frames/s, %llu dropped, %zu waiting at most; %.0f %% of a core, with "
                "robot and "
                "other nodes; estimating %.0f %% of the time, %d estimates; %.0f MB resident, at "
                "most %.0f MB\n",
                elapsed, rate, static_cast<unsigned long long>(view.frames.dropped),
                window->link()->waiting().most, 100.0 * (cpuSeconds() - cpu) / elapsed,
                100.0 * (busy.seconds - estimating) / elapsed, busy.estimates.load(), megabytes,
                mostMemory());
    const RecordingState recorded = recorder->state();
    std::printf("recorded: %lld frames, %lld dropped, %.1f MB\n",
                static_cast<long long>(recorded.frames), static_cast<long long>(recorded.missing),
                static_cast<double>(recorded.bytes) / 1e6);
    EXPECT_EQ(recorded.trouble.english(), "");
    EXPECT_EQ(recorded.missing, 0);
    EXPECT_GT(static_cast<double>(recorded.frames), 0.9 * rate * elapsed - kFramesPerSecond);

    EXPECT_GT(rate, 0.5 * kFramesPerSecond);
    EXPECT_GT(busy.seconds, estimating) << "nothing was estimated";
    EXPECT_LT(static_cast<double>(meter.frames().count()) / elapsed, 30.0) << "25 Hz and estimates";
    EXPECT_LT(megabytes, mostMegabytes);
    EXPECT_LT(beat.own(0.99), 16.0) << "of the window's own thread, however busy the machine";
    EXPECT_LT(beat.own(1.0), 100.0);
    EXPECT_LT(meter.lateness().most(), 5.0) << "hangs";
    if (!(wanted > 0.0)) return;
    EXPECT_LE(meter.lateness().quantile(0.99), 0.016);
    EXPECT_LE(meter.lateness().most(), 0.100);
}

TEST_F(Soak, keepsUpWithAFullBusWhileItEstimatesAndRecords)
{
    keepsUp([this](int count) { window->rail()->choose(count % window->rail()->pages()); }, 150.0);
}

TEST_F(Soak, plotsKeepUpWithAFullBus)
{
    keepsUp([this](int) { window->rail()->choose(window->rail()->pageOf(kPlotsKey)); }, 200.0);
}

TEST_F(Soak, costsLittleWhileNothingIsEstimated)
{
    const double wanted = wantedSeconds();
    const double seconds = wanted > 0.0 ? wanted : 2.0;
    open();
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    ASSERT_TRUE(arms());
    const double began = steadyNow(), cpu = cpuSeconds();
    const int frames = static_cast<int>(window->meter().frames().count());
    runFor(std::chrono::milliseconds(static_cast<int>(1e3 * seconds)));
    const double elapsed = steadyNow() - began;
    const double share = (cpuSeconds() - cpu) / elapsed;
    std::printf("%.0f s of telemetry at 20 Hz, armed, recording: %.1f %% of a core, with the "
                "robot; %.0f MB resident\n",
                elapsed, 100.0 * share, residentMemory() / 1e6);
    EXPECT_GT(static_cast<int>(window->meter().frames().count()), frames) << "nothing was drawn";
    EXPECT_EQ(busy.estimates.load(), 0);
    EXPECT_LT(residentMemory() / 1e6, 150.0);
    constexpr double kAnyMachine = 0.30;  // limit for a slow or busy machine in a short run
    EXPECT_LT(share, wanted > 0.0 ? 0.10 : kAnyMachine);
}

TEST_F(Soak, showsAnEstimateSoonAndEveryLivePreview)
{
    const double wanted = wantedSeconds();
    const double seconds = wanted > 0.0 ? wanted : 6.0;
    open(modelFileLoader(resourcePath("models/default.ttm"), model));
    if (qEnvironmentVariableIsSet("TERRATACT_SOAK_METHOD"))
        window->preferences().change([](Preferences& p) {
            p.method = method();
            p.preset = preset();
        });
    const Estimation& estimation = window->exploration().estimation();
    NewestValues waits(1000);
    int estimates = 0;  // previews while the flippers move; no two lines give the same estimate
    double scene = 0.0, shown = -1.0;  // time of the newest scene, and of the newest painted scene
    std::optional<TwoTrackEstimate> last;
    QObject::connect(&estimation, &Estimation::captured, window.get(),
                     [&] { scene = lines.pressed; });
    const Painted painted(*window, [&] {
        if (window->showsEstimate() && shown < scene) {
            waits.add(steadyNow() - scene);
            shown = scene;
        }
        const auto& drawn = window->terrain()->estimate();
        const bool isLive = drawn && !window->showsEstimate();
        if (isLive && (!last || last->side[0].mean != drawn->side[0].mean)) ++estimates;
        last = drawn;
    });
    ASSERT_TRUE(gui::eventually([&] { return window->exploration().linkAlive(); }));
    ASSERT_TRUE(arms());

    const double began = steadyNow();
    while (steadyNow() - began < seconds) {
        runFor(20ms);
        const AtemPhase phase = window->exploration().state().phase;
        if (exploring(phase) && phase != AtemPhase::ProposingProbe) continue;
        runFor(100ms);
        ASSERT_TRUE(arms());
        driveOn();
        window->exploration().request();
    }
    std::printf("%s", qUtf8Printable(spread("scene to screen", waits)));
    std::printf("%d estimates painted of %d lines of telemetry at 20 Hz while flippers moved\n",
                estimates, lines.pressing.load());
    EXPECT_GT(waits.count(), 0U);
    EXPECT_GT(estimates, 0);
    EXPECT_LT(waits.most(), 10.0) << "hangs";
    if (!(wanted > 0.0)) return;
    EXPECT_LE(waits.quantile(0.9), 0.050);
    EXPECT_GE(estimates, 0.95 * lines.pressing);
}

TEST_F(Soak, windowIsVisibleSoonAfterProcessStart)
{
    open();
    const double shown =
        processAge();  // showActive() returns after the window is exposed and painted
    std::printf("a window %.2f s after the process began\n", shown);
    EXPECT_TRUE(window->isVisible());
    EXPECT_LT(shown, wantedSeconds() > 0.0 ? 0.5 : 60.0);
}

}  // namespace
}  // namespace terratact
