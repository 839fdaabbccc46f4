// Tests the mission report: what it holds of a session, and its two formats.
#include "app/figures/report/mission_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "app/figures/report/document_pages.h"
#include "app/figures/report/mission_log.h"
#include "core/log/session_strip.h"
#include "core/log/session_writer.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/recorded_drive.h"
#include "tests/support/sessions/robot_session.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Row = std::vector<std::string>;

/// Returns the rows whose column holds the text.
std::vector<Row> rowsWith(const DocumentPart& part, std::size_t column, const std::string& text)
{
    std::vector<Row> rows;
    std::ranges::copy_if(part.table.rows, std::back_inserter(rows), [&](const Row& row) {
        return row.at(column).find(text) != std::string::npos;
    });
    return rows;
}

const DocumentPart& partOf(const ReportDocument& document, std::string_view heading)
{
    const auto at = std::ranges::find(document.parts, heading, &DocumentPart::heading);
    EXPECT_NE(at, document.parts.end()) << heading;
    return at == document.parts.end() ? document.parts.front() : *at;
}

std::string factOf(const DocumentPart& part, const std::string& what)
{
    for (const auto& [name, text] : part.facts)
        if (name == what) return text;
    return {};
}

struct MissionReport : Drive {};

TEST_F(MissionReport, hasEveryDecisionWithItsNumbersInTheOrderOfTime)
{
    const auto report = missionReportOf(reader);
    ASSERT_TRUE(report) << report.error().text;
    const DocumentPart& log = partOf(*report, "Decisions and their numbers");
    EXPECT_EQ(rowsWith(log, 2, "estimate ").size(),
              reader.estimates().size() + reader.proposals().size());
    ASSERT_EQ(rowsWith(log, 2, "probe proposed").size(), reader.proposals().size());
    EXPECT_NE(rowsWith(log, 2, "probe proposed")[0][3].find("threshold"), std::string::npos);
    ASSERT_FALSE(rowsWith(log, 2, "operator: approve").empty());
    EXPECT_NE(rowsWith(log, 2, "operator: approve")[0][3].find("on the screen"), std::string::npos);
    EXPECT_FALSE(rowsWith(log, 3, "error against the truth").empty());
    EXPECT_TRUE(std::ranges::is_sorted(log.table.rows, {}, [](const Row& row) { return row[0]; }));
}

TEST_F(MissionReport, countsEveryRowThatDoesNotFit)
{
    const auto whole = missionDecisions(reader, *readRobotModel(kRobot));
    ASSERT_TRUE(whole) << whole.error().text;
    const std::size_t all = whole->table.rows.size();
    ASSERT_GT(reader.estimates().size(), 1U) << "an estimate must be left out";
    for (const std::size_t most : {std::size_t{1}, all - 1}) {
        const auto part = missionDecisions(reader, *readRobotModel(kRobot), {}, most);
        ASSERT_TRUE(part) << part.error().text;
        ASSERT_EQ(part->table.rows.size(), most + 1);
        EXPECT_EQ(part->table.rows.back().back(),
                  "… and " + std::to_string(all - most) + " more in the session");
    }
    const auto exact = missionDecisions(reader, *readRobotModel(kRobot), {}, all);
    ASSERT_TRUE(exact) << exact.error().text;
    EXPECT_EQ(exact->table.rows, whole->table.rows);
}

TEST_F(MissionReport, saysHowManySettingsDoNotFit)
{
    const std::size_t all = missionSettings(reader).table.rows.size();
    ASSERT_GE(all, 1U);
    const DocumentPart part = missionSettings(reader, all - 1);
    ASSERT_EQ(part.table.rows.size(), all);
    EXPECT_EQ(part.table.rows.back().back(), "… and 1 more in the session");
}

TEST_F(MissionReport, hasTheSealTheHashesAndTheGround)
{
    const auto report = missionReportOf(reader);
    ASSERT_TRUE(report) << report.error().text;
    const DocumentPart& hashes = partOf(*report, "Hashes");
    EXPECT_EQ(factOf(hashes, "last link"), reader.verify().chain);
    EXPECT_EQ(factOf(hashes, "robot file"), reader.start().robotHash);
    EXPECT_NE(factOf(hashes, "model").find(reader.models()[0].hash), std::string::npos);
    EXPECT_FALSE(partOf(*report, "Strip of felt ground").pictures.empty());
    EXPECT_NE(partOf(*report, "Active settings").table.rows.at(0).at(2).find("step limit 0.1 m"),
              std::string::npos);
}

TEST_F(MissionReport, statesHowManyBandsHeldByTouch)
{
    const auto report = missionReportOf(reader);
    ASSERT_TRUE(report) << report.error().text;
    const DocumentPart& part = partOf(*report, "Strip of felt ground");
    SessionStrip followed(reader, *readRobotModel(kRobot));
    followed.goTo(reader.end());
    const StripLedger ledger = followed.strip().ledger();
    ASSERT_GT(ledger.all().n, 0U);
    for (const auto& [by, words] :
         {std::pair{ScoredBy::Contact, "contacts"}, std::pair{ScoredBy::Probe, "probes"},
          std::pair{ScoredBy::Pass, "passes"}}) {
        const StripScore& score = ledger.of(by);
        const std::string held = std::to_string(score.in80) + " of " + std::to_string(score.n);
        EXPECT_EQ(factOf(part, std::string("80 % bands held at later ") + words),
                  score.n > 0 ? held : std::string());
    }
}

TEST_F(MissionReport, isWrittenAsPagesAndAsOneHtmlFile)
{
    const auto report = missionReportOf(reader);
    ASSERT_TRUE(report) << report.error().text;
    const std::string pdf = directory.file("m.pdf"), again = directory.file("n.pdf");
    ASSERT_TRUE(writeDocument(pdf, *report));
    ASSERT_TRUE(writeDocument(again, *report));
    EXPECT_EQ(contentOf(pdf), contentOf(again));
    const std::string html = directory.file("m.html");
    ASSERT_TRUE(writeDocument(html, *report));
    EXPECT_NE(contentOf(html).find("<svg"), std::string::npos);
    EXPECT_NE(contentOf(html).find("<col style=\"width:57.5%\">"), std::string::npos)
        << "a browser must not crush the narrow columns";
    EXPECT_TRUE(refused(writeDocument(directory.file("m.svg"), *report), directory.file("m.svg"),
                        {".pdf or .html"}));
}

TEST_F(MissionReport, endsWhenItIsCancelledAndLeavesNothing)
{
    EXPECT_TRUE(refused(missionReportOf(reader, [](double) { return false; }), reader.path(),
                        {"ended before"}));
    EXPECT_TRUE(refused(missionReportOf(reader, [](double share) { return share < 0.4; }),
                        reader.path(), {"ended before"}));
}

/// A session with alarms and texts that try to be HTML.
struct HostileSession {
    HostileSession()
    {
        auto writer = robotSession(path, 1.0, 100.0);
        EXPECT_TRUE(writer) << writer.error().text;
        const auto alarm = [&](double time, double number, const std::string& id) {
            EventRow row{.time = sessionTimeOf(time), .kind = EventKind::Alarm, .subject = id};
            row.text = "<script>alert(1)</script>";
            row.number = number;
            row.id = 1000 + static_cast<std::int64_t>(10.0 * time);
            EXPECT_TRUE(writer->add(row));
        };
        alarm(2.0, 3.0, "link");
        alarm(2.5, 2.0, "link");
        alarm(3.0, 0.0, "link");
        alarm(4.0, 3.0, "link");
        EXPECT_TRUE(writer->seal());
    }
    TemporaryDirectory directory;
    std::string path = directory.file("hostile.tts");
};

TEST(MissionAlarms, eachRaiseIsARowWithItsTimes)
{
    HostileSession session;
    const auto reader = SessionReader::open(session.path);
    ASSERT_TRUE(reader) << reader.error().text;
    const DocumentPart alarms = missionAlarms(*reader);
    const auto rows = rowsWith(alarms, 0, "link");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(Row(rows[0].begin() + 1, rows[0].begin() + 4),
              (Row{"2.000 s", "2.500 s", "3.000 s"}));
    EXPECT_EQ(Row(rows[1].begin() + 1, rows[1].begin() + 4), (Row{"4.000 s", "no", "no"}));
}

TEST(MissionAlarms, textsOfTheFileAreNoHtml)
{
    HostileSession session;
    auto reader = SessionReader::open(session.path);
    ASSERT_TRUE(reader) << reader.error().text;
    const auto report = missionReportOf(*reader);
    ASSERT_TRUE(report) << report.error().text;
    const std::string html = session.directory.file("m.html");
    ASSERT_TRUE(writeDocument(html, *report));
    EXPECT_EQ(contentOf(html).find("<script"), std::string::npos);
    EXPECT_NE(contentOf(html).find("&lt;script&gt;"), std::string::npos);
}

TEST(DocumentPages, aLongTableIsContinuedAndNothingIsLost)
{
    DocumentPart part{.heading = "Rows", .note = {}, .facts = {}, .pictures = {}, .table = {}};
    part.table.heading = {"a", "b"};
    part.table.shares = {1.0, 9.0};
    part.table.rows.assign(200, {"1", std::string(400, 'x')});
    TemporaryDirectory directory;
    const std::string path = directory.file("long.pdf");
    const ReportDocument document{.title = "T", .summary = "S", .parts = {part}};
    std::size_t pages = 0;
    ASSERT_TRUE(writePages(path, kPaperWidth, kPaperHeight, "T", [&](Canvas& canvas) {
        auto laid = pagesOf(canvas, document);
        pages = laid.size();
        return laid;
    }));
    EXPECT_GE(pages, 10U);
}

}  // namespace
}  // namespace terratact
