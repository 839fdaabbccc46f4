// State of the last estimate after it was left, as the console showed it.
// app/console/bus_link_test.cpp tests with a console that a ghost lies where the console drew it.
#include "core/log/review_ghost.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using At = RobotSessionTimes;

const ReviewGhost::ViewState kNone{}, kTelemetryGap{{}, NoGhost::TelemetryGap};

struct GhostOf : testing::Test {
    void record(const std::vector<std::variant<EventRow, ModelRow>>& more)
    {
        const std::string path = directory.file(std::to_string(++recorded) + ".tts");
        auto writer = robotSession(path, 4.0);
        ASSERT_TRUE(writer) << writer.error().text;
        for (const auto& row : more)
            std::visit([&](const auto& r) { ASSERT_TRUE(writer->add(r)); }, row);
        ASSERT_TRUE(writer->seal());
        auto opened = SessionReader::open(path);
        ASSERT_TRUE(opened) << opened.error().text;
        reader.emplace(std::move(*opened));
    }
    EventRow event(double time, EventKind kind, const char* subject = "")
    {
        return {.id = ++id, .time = sessionTimeOf(time), .kind = kind, .subject = subject};
    }
    static ModelRow model(double time)
    {
        return {
            .id = 2, .time = sessionTimeOf(time), .name = "mine.ttm", .hash = std::string(64, 'd')};
    }
    /// Creates a new object each time, so that nothing depends on earlier requests.
    ReviewGhost::ViewState at(double time)
    {
        ReviewMoments moments(*reader, absolem());
        return ReviewGhost(*reader, absolem()).at(moments.at(sessionTimeOf(time)));
    }

    TemporaryDirectory directory;
    std::optional<SessionReader> reader;
    std::int64_t id = 100;
    int recorded = 0;
};

constexpr double kProbed = At::kAgain + 0.02, kStood = At::kForgotten - 0.2,
                 kLeft = At::kForgotten + 0.1, kLater = At::kForgotten + 0.4;

TEST_F(GhostOf, anEstimateIsFollowedOnceItIsLeft)
{
    record({});
    EXPECT_EQ(at(At::kScene - 0.05), kNone) << "there was no estimate yet";
    EXPECT_EQ(at(At::kPresenting + 0.1), kNone) << "it stands";
    EXPECT_TRUE(at(kLeft).ghost);
    EXPECT_TRUE(at(kLater).ghost);
}

TEST_F(GhostOf, bothSidesAreFollowedWhereBothWereEstimated)
{
    record({});
    EXPECT_TRUE(at(kLeft).onePlane);
    EXPECT_FALSE(at(kLeft).right);
    auto opened = SessionReader::open(TERRATACT_SOURCE_DIR "/resources/sessions/two_tracks.tts");
    ASSERT_TRUE(opened) << opened.error().text;
    reader.emplace(std::move(*opened));
    const auto forgotten =
        std::ranges::find(reader->events(), EventKind::Forgotten, &EventRow::kind);
    ASSERT_NE(forgotten, reader->events().end());
    const ReviewGhost::ViewState left = at(secondsOf(forgotten->time) + 0.3);
    EXPECT_FALSE(left.onePlane);
    ASSERT_TRUE(left.ghost && left.right);
    EXPECT_NE(*left.ghost, *left.right);
}

TEST_F(GhostOf, aDiscardedEstimateHasNoGhost)
{
    record({event(kStood, EventKind::Decision, "abort")});
    EXPECT_EQ(at(kLeft), kNone) << "forgotten with the estimate itself";
    record({event(kLeft + 0.1, EventKind::Decision, "abort")});
    EXPECT_TRUE(at(kLeft).ghost);
    EXPECT_EQ(at(kLater), kNone) << "forgotten later";
    record({event(kProbed, EventKind::Decision, "abort")});
    EXPECT_TRUE(at(kLater).ghost) << "that ended the probe alone";
}

TEST_F(GhostOf, anotherModelEndsTheGhost)
{
    record({model(kStood)});
    EXPECT_EQ(at(kLeft), kNone);
    record({model(kLeft + 0.1)});
    EXPECT_TRUE(at(kLeft).ghost);
    EXPECT_EQ(at(kLater), kNone);
    record({model(kProbed)});
    EXPECT_TRUE(at(kLater).ghost) << "the exploration went on";
}

TEST_F(GhostOf, aSilenceEndsTheGhost)
{
    for (const double time : {At::kMarker, kStood}) {
        record({event(time, EventKind::TelemetryGap)});
        EXPECT_EQ(at(kLeft), kTelemetryGap) << "since the scene: " << time;
    }
    record({event(kLeft + 0.1, EventKind::TelemetryGap)});
    EXPECT_TRUE(at(kLeft).ghost);
    EXPECT_EQ(at(kLater), kTelemetryGap);
}

TEST_F(GhostOf, theNextExplorationEndsTheGhost)
{
    record({event(kLeft + 0.1, EventKind::Phase, "pressing")});
    EXPECT_TRUE(at(kLeft).ghost);
    EXPECT_EQ(at(kLater), kNone);
}

TEST_F(GhostOf, aMomentIsTheSameForAnyOrderOfRequests)
{
    record({event(kLeft + 0.1, EventKind::TelemetryGap)});
    ReviewMoments moments(*reader, absolem());
    ReviewGhost ghosts(*reader, absolem());
    for (const double time : {kLater, kLeft, kStood, kLeft, 0.1, kLeft + 0.05, kLeft, kLater})
        EXPECT_EQ(ghosts.at(moments.at(sessionTimeOf(time))), at(time)) << time;
}

}  // namespace
}  // namespace terratact
