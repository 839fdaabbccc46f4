// Tests the plotted signals of a session against its frames, and the time a zoom takes.
#include "app/plotting/session_signals.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "core/log/review_moment.h"
#include "core/wire/telemetry_listener.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

bool becomesIdle(const SessionSignals& signals, std::chrono::seconds patience = 30s)
{
    const auto until = std::chrono::steady_clock::now() + patience;
    while (!signals.isIdle()) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::yield();  // until the reading thread reports
    }
    return true;
}

struct PlottedSession : testing::Test {
    void record(double seconds, double rate = 0.0)
    {
        auto writer = robotSession(path, seconds, rate);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }

    TemporaryDirectory directory;
    std::string path = directory.file("plots.tts");
};

TEST_F(PlottedSession, holdsEveryValueOfItsFrames)
{
    record(6.0);
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader);
    SeriesSummary pitch, way;
    TelemetryListener listener(absolem());
    for (std::size_t i = 0; i < reader->batches().size(); ++i)
        for (const FrameRow& row : reader->frames(i)) {
            const auto line = listener.receive(row.frame, secondsOf(row.time));
            if (line) pitch.add(line->pitch);
            const JudgedFrame& judged = listener.judged();
            if (judged.kind == FrameKind::Odometry && judged.isSound())
                way.add(judged.content.values[0]);
        }
    ASSERT_GT(pitch.count, 100U);
    ASSERT_GT(way.count, 100U);
    SessionSignals signals(path, absolem(), 0.0, 6.0);
    const std::string odometry =
        "bus:Odometry." + std::string(layoutOf(FrameKind::Odometry).payload[0].name);
    signals.choose(
        {"telemetry:pitch", odometry, frameRateKey(), "estimate:sd_max.left", "estimate:p_step"});
    ASSERT_TRUE(becomesIdle(signals));
    EXPECT_TRUE(signals.trouble().empty());
    EXPECT_EQ(signals.share(), 1.0);
    const PlotSpan whole{.from = 0.0, .to = 6.0, .columns = 500, .cursor = 3.0};
    const SeriesView shown = signals.view("telemetry:pitch", whole);
    EXPECT_EQ(shown.visible.count, pitch.count);
    EXPECT_NEAR(shown.visible.mean, pitch.mean, 1e-9);
    EXPECT_EQ(signals.view(odometry, whole).visible.count, way.count);
    EXPECT_GT(signals.view(frameRateKey(), whole).visible.mean, 100.0);
    const SeriesView sd = signals.view("estimate:sd_max.left", whole);
    EXPECT_EQ(sd.visible.count, 2U) << "two estimates";
    EXPECT_NEAR(*sd.atCursor, 0.09, 1e-6);
    EXPECT_EQ(signals.view("estimate:p_step", whole).visible.count, 2U)
        << "from the recorded draws";
}

TEST_F(PlottedSession, aZoomReadsItsSpanAgain)
{
    record(6.0);
    SessionSignals signals(path, absolem(), 0.0, 6.0);
    signals.choose({"bus:Attitude.Pitch"});
    ASSERT_TRUE(becomesIdle(signals));
    const PlotSpan span{.from = 3.0, .to = 3.1, .columns = 1000, .cursor = 3.05};
    (void)signals.view("bus:Attitude.Pitch", span);
    ASSERT_TRUE(becomesIdle(signals));
    const SeriesView fine = signals.view("bus:Attitude.Pitch", span);
    EXPECT_TRUE(signals.isIdle()) << "it is read: nothing is wanted again";
    ASSERT_GE(fine.columns.size(), 2U);
    for (const SeriesColumn& column : fine.columns) EXPECT_EQ(column.summary.count, 1U);
    EXPECT_TRUE(fine.atCursor);
}

TEST_F(PlottedSession, laterChoicesAreReadFromTheBeginning)
{
    record(3.0);
    SessionSignals signals(path, absolem(), 0.0, 3.0);
    EXPECT_EQ(signals.share(), 0.0) << "nothing is read before it is chosen";
    signals.choose({});
    ASSERT_TRUE(becomesIdle(signals));
    const PlotSpan whole{.from = 0.0, .to = 3.0, .columns = 100, .cursor = 1.0};
    signals.choose({"telemetry:pitch"});
    ASSERT_TRUE(becomesIdle(signals));
    const auto pitches = signals.view("telemetry:pitch", whole).visible.count;
    signals.choose({"telemetry:roll", "telemetry:pitch"});
    ASSERT_TRUE(becomesIdle(signals));
    EXPECT_EQ(signals.view("telemetry:roll", whole).visible.count, pitches);
    EXPECT_EQ(signals.view("telemetry:pitch", whole).visible.count, pitches) << "added once";
}

TEST_F(PlottedSession, payloadComesWithADescription)
{
    record(2.0, 300.0);
    auto book = std::make_shared<DbcBook>();
    ASSERT_TRUE(book->add(
        directory.write("x.dbc", "BO_ 1792 Filler: 8 P\n SG_ A : 0|8@1+ (1,0) [0|0] \"V\" C\n")));
    SessionSignals signals(path, absolem(), 0.0, 2.0);
    signals.choose({"payload:700 Filler.A"});
    ASSERT_TRUE(becomesIdle(signals));
    const PlotSpan whole{.from = 0.0, .to = 2.0, .columns = 100, .cursor = 1.0};
    EXPECT_EQ(signals.view("payload:700 Filler.A", whole).visible.count, 0U);
    signals.describe(book);
    ASSERT_TRUE(becomesIdle(signals));
    const auto all = signals.catalogue();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const PlotSignal& s) {
        return s.key() == "payload:700 Filler.A" && s.unit == "V";
    }));
    EXPECT_GT(signals.view("payload:700 Filler.A", whole).visible.count, 0U);
}

TEST_F(PlottedSession, aFileThatIsNoSessionIsTrouble)
{
    SessionSignals signals(directory.write("no.tts", "no session"), absolem(), 0.0, 1.0);
    signals.choose({});
    ASSERT_TRUE(becomesIdle(signals));
    EXPECT_NE(signals.trouble().english().find("no.tts"), std::string::npos);
}

/// Measures an hour at 1 kHz by a command: TERRATACT_PLOT_SECONDS=3600 app.plotting --gtest_filter=*zoom*
TEST_F(PlottedSession, zoomOfALongSessionIsFast)
{
    const char* const given = std::getenv("TERRATACT_PLOT_SECONDS");
    const double seconds = given ? std::atof(given) : 20.0;
    record(seconds, 1000.0);
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point began) {
        return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
    };
    SessionSignals signals(path, absolem(), 0.0, seconds);
    const std::vector<std::string> keys{"telemetry:pitch", "bus:Attitude.Roll", "telemetry:force1",
                                        frameRateKey()};
    auto began = Clock::now();
    signals.choose(keys);
    ASSERT_TRUE(becomesIdle(signals, 600s));
    const double whole = since(began);
    double worst = 0.0, worstView = 0.0;
    for (double width = seconds; width > 0.1; width /= 2.0) {
        const double from = 0.4 * (seconds - width);
        const PlotSpan span{.from = from, .to = from + width, .columns = 1000, .cursor = from};
        began = Clock::now();
        for (const std::string& key : keys) (void)signals.view(key, span);
        worstView = std::max(worstView, since(began));
        ASSERT_TRUE(becomesIdle(signals));
        for (const std::string& key : keys)
            EXPECT_FALSE(signals.view(key, span).columns.empty()) << key << " " << width;
        const double took = since(began);
        if (given) std::printf("%10.2f s: %6.1f ms\n", width, took);
        worst = std::max(worst, took);
    }
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    std::printf("%.0f s: 4 signals read in %.0f ms, shown in at most %.2f ms, a zoom in at most "
                "%.1f ms, %ld MB more\n",
                seconds, whole, worstView, worst, (after.ru_maxrss - before.ru_maxrss) / 1024);
    if (given) {
        EXPECT_LT(worst, 100.0);
    }
}

}  // namespace
}  // namespace terratact
