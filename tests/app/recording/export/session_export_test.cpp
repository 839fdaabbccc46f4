// Tests which rows of a session are exported, and that a failed export leaves no file.
#include "app/recording/export/session_export.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/refusal.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct Exporting : testing::Test {
    TemporaryDirectory directory;
    std::string path = directory.file("a.tts");
    SessionReader session = [this] {
        auto writer = someSession(path, 1000);  // 1 ms apart
        EXPECT_TRUE(writer && writer->seal());
        return *SessionReader::open(path);
    }();
};

TEST_F(Exporting, formatsHaveNamesAndEndings)
{
    EXPECT_EQ(exportFormatOf("/a/b.log"), ExportFormat::Candump);
    EXPECT_EQ(exportFormatOf("b.mcap"), ExportFormat::Mcap);
    EXPECT_FALSE(exportFormatOf("b.txt"));
    EXPECT_EQ(exportFormatFromName("asc"), ExportFormat::Asc);
    EXPECT_FALSE(exportFormatFromName(".asc"));
    EXPECT_EQ(exportKindFromName("events"), ExportKind::Events);
}

TEST_F(Exporting, onlyTheChosenTimeIsWritten)
{
    const std::string to = directory.file("a.log");
    const auto counts =
        writeExport(session, to, ExportFormat::Candump, {.what = {}, .from = 0.1, .to = 0.2});
    ASSERT_TRUE(counts) << counts.error().text;
    EXPECT_EQ(counts->frames, 101U) << "both ends belong to it";
    const std::string text = contentOf(to);
    EXPECT_TRUE(text.starts_with("(1793000000.100000)")) << text.substr(0, 40);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 101);
}

TEST_F(Exporting, aTableOfEventsHasNoFrames)
{
    const auto counts = writeExport(session, directory.file("a.csv"), ExportFormat::Csv,
                                    {.what = ExportKind::Events});
    ASSERT_TRUE(counts);
    EXPECT_EQ(counts->frames, 0U);
    EXPECT_EQ(counts->others, session.events().size());
}

TEST_F(Exporting, failuresLeaveNoFile)
{
    const std::string log = directory.file("a.log");
    EXPECT_FALSE(writeExport(session, log, ExportFormat::Candump, {.what = ExportKind::Estimates}))
        << "a log has frames only";
    EXPECT_FALSE(writeExport(session, log, ExportFormat::Candump, {.what = {}, .from = 100.0}))
        << "nothing was recorded then";
    int asked = 0;
    EXPECT_FALSE(
        writeExport(session, log, ExportFormat::Candump, {}, [&](double) { return ++asked < 3; }));
    EXPECT_EQ(asked, 3) << "it was cancelled";
    EXPECT_EQ(directory.entries(), std::set<std::string>{"a.tts"});
}

}  // namespace
}  // namespace terratact
