// Tests the tables and figures of an evaluation.
#include "app/figures/report/findings_report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/support/refusal.h"
#include "tests/support/some_findings.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(FindingsReport, writesTheFilesThatItNames)
{
    const TemporaryDirectory directory;
    testing::internal::CaptureStdout();
    const Status done = reportFindings(someFindings({1, 1}), directory.file(""));
    const std::string printed = testing::internal::GetCapturedStdout();
    ASSERT_TRUE(done) << done.error().text;
    const auto names = reportFiles();
    const std::set<std::string> may(names.begin(), names.end());
    const std::set<std::string> written = directory.entries();
    for (const std::string& name : written) {
        EXPECT_TRUE(may.contains(name)) << name;
        EXPECT_GT(std::filesystem::file_size(directory.file(name)), 40U) << name;
    }
    for (const char* name : {"errors.csv", "scores.csv", "fig9.png", "pit.svg"})
        EXPECT_TRUE(written.contains(name)) << name;
    for (const char* label : {"local", "flat"})
        EXPECT_NE(printed.find(label), std::string::npos) << printed;
}

TEST(FindingsReport, needsTheFindingsOfAllScenes)
{
    const TemporaryDirectory directory;
    EXPECT_THROW((void)reportFindings(someFindings({1, 2}), directory.file("")),
                 std::invalid_argument);
    EXPECT_TRUE(directory.entries().empty());
}

TEST(FindingsReport, namesTheFileThatCannotBeWritten)
{
    const TemporaryDirectory directory;
    const std::string nowhere = directory.file("none");
    EXPECT_TRUE(
        refused(reportFindings(someFindings({1, 1}), nowhere), nowhere + "/errors.csv", {}));
}

TEST(FindingsReport, aRunIsPrintedWithItsTimePerScene)
{
    testing::internal::CaptureStdout();
    printRun({"local", 10, 9, 2, 1, 1, 0.5});
    const std::string printed = testing::internal::GetCapturedStdout();
    EXPECT_NE(printed.find("10 scenes, 9 converged"), std::string::npos) << printed;
    EXPECT_NE(printed.find("50 ms per scene"), std::string::npos) << printed;
}

}  // namespace
}  // namespace terratact
