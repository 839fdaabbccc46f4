// Tests which rows the next file of a recording begins with.
#include "app/recording/recording_context.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

struct NextFile : testing::Test {
    RecordingContext context;
    SessionTime time = 0;

    void event(EventKind kind, const std::string& subject, std::optional<double> number = {},
               const std::string& text = {})
    {
        context.add(EventRow{
            .time = ++time, .kind = kind, .subject = subject, .text = text, .number = number});
    }
    /// Returns the subjects of the events.
    std::vector<std::string> subjects() const
    {
        std::vector<std::string> all;
        for (const SessionRow& row : context.rows())
            if (const auto* event = std::get_if<EventRow>(&row)) all.push_back(event->subject);
        return all;
    }
    using Subjects = std::vector<std::string>;
};

TEST_F(NextFile, hasTheNewestSceneWithItsModel)
{
    context.add(ModelRow{.id = 1, .name = "old.ttm"});
    context.add(ModelRow{.id = 2, .name = "new.ttm"});
    context.add(someScene(1, 10));
    context.add(someEstimate(1, 11));
    context.add(someScene(2, 20));
    context.add(someEstimate(2, 21));
    const auto rows = context.rows();
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(std::get<ModelRow>(rows[0]).name, "new.ttm");
    EXPECT_EQ(std::get<SceneRow>(rows[1]).id, 2);
    EXPECT_EQ(std::get<EstimateRow>(rows[2]).id, 2);
}

TEST_F(NextFile, hasTheAnswerToAProposalOfItsScene)
{
    context.add(someScene(1, 10));
    context.add(someProposal(11));
    context.add(someDecision(12));
    event(EventKind::Decision, "drive");
    EXPECT_EQ(subjects(), Subjects{"approve"}) << "other decisions are done";
    context.add(someScene(2, 20));
    EXPECT_TRUE(subjects().empty());
}

TEST_F(NextFile, hasTheNewestStateOfEachKind)
{
    event(EventKind::Phase, "pressing");
    event(EventKind::Link, "up");
    event(EventKind::Phase, "ready");
    event(EventKind::Marker, "operator");
    EXPECT_EQ(subjects(), (Subjects{"up", "ready"}));
}

TEST_F(NextFile, hasAlarmsThatAreActiveOnly)
{
    event(EventKind::Alarm, "load", 3.0);
    event(EventKind::Alarm, "link", 3.0);
    event(EventKind::Alarm, "link", 0.0);
    EXPECT_EQ(subjects(), Subjects{"load"});
}

TEST_F(NextFile, hasAnOverrideUntilItEnds)
{
    event(EventKind::Override, "", {}, "roll 9");
    EXPECT_EQ(context.rows().size(), 1U);
    event(EventKind::Override, "", {}, "");
    EXPECT_TRUE(context.rows().empty());
}

TEST_F(NextFile, aNewSceneEndsAGapOfTelemetry)
{
    event(EventKind::TelemetryGap, "gap");
    EXPECT_EQ(subjects(), Subjects{"gap"});
    context.add(someScene(1, 10));
    EXPECT_TRUE(subjects().empty());
}

TEST_F(NextFile, eventsReferToNoRowOfTheFileBefore)
{
    context.add(EventRow{
        .time = 1, .kind = EventKind::Phase, .subject = "ready", .estimate = 7, .proposal = 8});
    const auto rows = context.rows();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(std::get<EventRow>(rows[0]).estimate, 0);
    EXPECT_EQ(std::get<EventRow>(rows[0]).proposal, 0);
}

}  // namespace
}  // namespace terratact
