// Tests the report of a scene: its content and its page.
#include "app/figures/session_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/recorded_drive.h"
#include "tests/support/refusal.h"
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

}  // namespace
}  // namespace terratact
