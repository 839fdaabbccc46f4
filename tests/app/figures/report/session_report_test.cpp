// Tests the report of a scene: its content and its page.
#include "app/figures/report/session_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/figures/report/payload_facts.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/recorded_drive.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Returns the largest of the numbers that follow `key` in the text.
double largest(const std::string& text, const std::string& key)
{
    double most = 0.0;
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1))
        most = std::max(most, std::strtod(text.c_str() + at + key.size(), nullptr));
    return most;
}

TEST_F(Drive, theReportHasWhatWasDecidedAndFitsItsPage)
{
    auto report = *reportOf(reader, 0);
    ASSERT_EQ(report.table.size(), 12U);
    const auto& head = report.table.front();
    EXPECT_EQ(std::ranges::count(head, "R-hat"), 0) << "a closed form has no chains";
    EXPECT_EQ(report.table.back().size(), head.size());
    ASSERT_EQ(report.figures.size(), 1U);
    ASSERT_TRUE(report.figures[0].previous);
    ASSERT_FALSE(report.events.empty());
    EXPECT_NE(report.events[0].find("approve"), std::string::npos);
    EXPECT_NE(report.events[0].find("on the screen"), std::string::npos);
    // Too many for the page; its last line counts the rest.
    report.events.assign(400, report.events[0]);
    const std::string path = directory.file("page.svg");
    ASSERT_TRUE(writeReport(path, report));
    const std::string page = contentOf(path);
    EXPECT_GT(largest(page, "y=\""), 1600.0) << "the page is not used";
    EXPECT_LT(largest(page, "\" y=\""), 1754.0 - 30.0);
    EXPECT_LT(largest(page, " x=\""), 1240.0 - 30.0);
    EXPECT_TRUE(refused(reportOf(reader, 9), reader.path(), {"no scene 9"}));
}

/// Adds frames of two sensors of one type to a session of a robot.
struct PayloadSession {
    PayloadSession()
    {
        auto writer = robotSession(path, 3.0, 300.0);
        EXPECT_TRUE(writer) << writer.error().text;
        EXPECT_TRUE(writer->seal());
        book = std::make_shared<DbcBook>();
        EXPECT_TRUE(book->add(directory.write(
            "x.dbc", "BO_ 1792 Gas: 8 P\n SG_ Oxygen : 0|8@1+ (1,0) [0|0] \"%\" C\n"
                     "BO_ 1793 Gas: 8 P\n SG_ Oxygen : 0|8@1+ (0.5,0) [0|0] \"%\" C\n")));
    }
    TemporaryDirectory directory;
    std::string path = directory.file("payload.tts");
    std::shared_ptr<DbcBook> book;
};

TEST(ReportOfPayload, hasTheNewestValuesBeforeTheScene)
{
    PayloadSession session;
    auto reader = SessionReader::open(session.path);
    ASSERT_TRUE(reader);
    EXPECT_TRUE(payloadFacts(*reader, nullptr, sessionTimeOf(1.6)).empty());
    const auto facts = payloadFacts(*reader, session.book, sessionTimeOf(1.6));
    ASSERT_EQ(facts.size(), 2U);
    EXPECT_EQ(facts[0].first, "payload");
    EXPECT_TRUE(facts[0].second.starts_with("700 Gas: Oxygen ")) << facts[0].second;
    EXPECT_TRUE(facts[0].second.ends_with(" %, 0.0 s before")) << facts[0].second;
    EXPECT_TRUE(facts[1].second.starts_with("701 Gas: Oxygen "));
    EXPECT_TRUE(payloadFacts(*reader, session.book, sessionTimeOf(-1.0)).empty());
    const auto late = payloadFacts(*reader, session.book, sessionTimeOf(8.0));
    ASSERT_EQ(late.size(), 2U);
    EXPECT_TRUE(late[0].second.ends_with(", 5.0 s before")) << late[0].second;
    EXPECT_TRUE(payloadFacts(*reader, session.book, sessionTimeOf(14.0)).empty());
}

}  // namespace
}  // namespace terratact
