// Tests moving in a reviewed session: playback, steps, loops, following.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "app/pages/plots_page.h"
#include "app/review/review_window.h"
#include "tests/support/benches/review_bench.h"
#include "tests/support/gui.h"
#include "tests/support/sessions/robot_session.h"

namespace terratact {
namespace {

using namespace gui;
using At = RobotSessionTimes;

TEST(ReviewPlayer, playsByDataTimeAndSkipsNothingAfterAPause)
{
    ReviewPlayer player;
    player.setRange(0.0, 100.0);
    player.play(false);
    player.advance(0.1);
    EXPECT_NEAR(player.position(), 0.1, 1e-12);
    player.setSpeed(50.0);
    player.advance(0.1);
    EXPECT_NEAR(player.position(), 5.1, 1e-12);
    player.advance(3600.0);  // the machine was suspended
    EXPECT_NEAR(player.position(), 5.1 + 50.0 * ReviewPlayer::kMaxStepTime, 1e-9);
    player.pause();
    const double stood = player.position();
    player.advance(1.0);
    EXPECT_EQ(player.position(), stood);
    player.setSpeed(1e9);
    EXPECT_EQ(player.speed(), ReviewPlayer::kFastest);
    player.setSpeed(0.0);
    EXPECT_EQ(player.speed(), ReviewPlayer::kSlowest);
}

TEST(ReviewPlayer, playsBackwardsLoopsAndStopsAtTheEnds)
{
    ReviewPlayer player;
    player.setRange(0.0, 1.0);
    player.seek(0.5);
    player.play(true);
    player.advance(0.2);
    EXPECT_NEAR(player.position(), 0.3, 1e-12);
    player.advance(0.2);
    player.advance(0.2);
    EXPECT_EQ(player.position(), 0.0);
    EXPECT_FALSE(player.playing());
    player.setA(0.8);
    player.setB(0.6);
    player.setLoop(true);
    player.seek(0.7);
    player.play(false);
    for (int n = 0; n < 20; ++n) {
        player.advance(0.05);
        EXPECT_GE(player.position(), 0.6);
        EXPECT_LE(player.position(), 0.8);
    }
    EXPECT_TRUE(player.playing());
    player.setLoop(false);
    player.setFollowing(true);
    for (int n = 0; n < 20; ++n) player.advance(0.1);
    EXPECT_EQ(player.position(), 1.0);
    EXPECT_TRUE(player.playing()) << "waits for more";
}

TEST_F(ReviewOf, aSessionThatIsStillRecordedIsFollowed)
{
    auto writer = robotSession(path.toStdString(), 2.0);
    ASSERT_TRUE(writer) << writer.error().text;
    open();
    const double before = window->player().end();
    press(Qt::Key_T);
    EXPECT_TRUE(window->player().following());
    EXPECT_EQ(now(), before);
    ASSERT_TRUE(writer->add(EventRow{
        .id = 100, .time = sessionTimeOf(7.0), .kind = EventKind::Marker, .text = "later"}));
    ASSERT_TRUE(writer->commit());
    window->poll(0.6);
    EXPECT_NEAR(window->player().end(), 7.0, 1e-6);
    EXPECT_NEAR(now(), 7.0, 1e-6);
    EXPECT_TRUE(window->stateLabel()->text().contains("BEING RECORDED"));
    EXPECT_EQ(window->events()->table()->model()->rowCount(),
              static_cast<int>(window->session().events().size()));
}

/// Measures the cost of playback: TERRATACT_REVIEW_SECONDS=3600 app.review --gtest_filter=*Costs*
/// TERRATACT_REVIEW_PLOTS=1: on the page Plots.
TEST_F(ReviewOf, playbackCostsLittle)
{
    const char* given = std::getenv("TERRATACT_REVIEW_SECONDS");
    const double seconds = given ? std::atof(given) : 10.0;
    {
        auto writer = robotSession(path.toStdString(), seconds, 850.0);
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE(writer->seal());
    }
    open();
    ASSERT_TRUE(eventually([&] { return window->surveyed(); }, 120000));
    const auto used = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        const auto of = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        };
        return std::pair(of(usage.ru_utime) + of(usage.ru_stime), usage.ru_maxrss / 1024);
    };
    if (std::getenv("TERRATACT_REVIEW_PLOTS")) {
        press(kPlotsKey);
        QTest::qWait(100);
        ASSERT_TRUE(eventually([&] { return window->plotted().isIdle(); }, 120000));
    }
    const double from = seconds / 2.0, before = used().first;
    window->goTo(from);
    press(Qt::Key_L);
    QElapsedTimer watch;
    watch.start();
    QTest::qWait(given ? 20000 : 1000);
    const double elapsed = 1e-3 * static_cast<double>(watch.elapsed());
    const auto [after, megabytes] = used();
    std::printf("%lld frames: playback of %.2f s at 1x took %.1f %% of a core, %ld MB at most\n",
                static_cast<long long>(window->session().frameCount()), now() - from,
                100.0 * (after - before) / elapsed, megabytes);
    EXPECT_GT(now(), from + 0.1);
    EXPECT_LE(now(), from + elapsed + 0.1);
}

}  // namespace
}  // namespace terratact
