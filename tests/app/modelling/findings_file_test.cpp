// Tests that findings survive their file, and that altered files are refused.
#include "app/modelling/findings_file.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <stdexcept>

#include "app/modelling/findings.h"
#include "tests/support/refusal.h"
#include "tests/support/some_findings.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct FindingsFile : testing::Test {
    const TemporaryDirectory dir;
    const std::string path = dir.file("part.tte");
    const Findings findings = someFindings({2, 3});

    FindingsFile()
    {
        if (!writeFindings(path, findings)) throw std::runtime_error("no findings");
    }
    testing::AssertionResult refusesAfter(const std::string& sql,
                                          std::initializer_list<std::string_view> words)
    {
        const std::string changed = dir.write("changed.tte", contentOf(path));
        sqlite3* file = nullptr;
        sqlite3_open(changed.c_str(), &file);
        const int code = sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr);
        sqlite3_close(file);
        if (code != SQLITE_OK) return testing::AssertionFailure() << sql;
        return refused(readFindings(changed), changed, words);
    }
};

TEST_F(FindingsFile, everyNumberSurvivesARoundTrip)
{
    const auto read = readFindings(path);
    ASSERT_TRUE(read) << read.error().text;
    expectSame(*read, findings);
    ASSERT_EQ(read->runs.size(), 2U);
    EXPECT_EQ(read->runs[1].label, "flat");
    EXPECT_EQ(read->runs[1].converged, findings.runs[1].converged);
    EXPECT_EQ(read->runs[1].endedBySweeps, 2U);
    EXPECT_EQ(read->runs[1].endedByTime, 1U);
    EXPECT_EQ(read->runs[1].seconds, 0.5);
    EXPECT_EQ(read->probes[0].rule, "sd");
}

TEST_F(FindingsFile, isDistinguishedFromOtherFiles)
{
    EXPECT_TRUE(isFindingsFile(path));
    EXPECT_FALSE(isFindingsFile(dir.file("none.tte")));
    EXPECT_FALSE(isFindingsFile(dir.write("short.tte", "SQLite format 3")));
    EXPECT_TRUE(refusesAfter("PRAGMA application_id = 7", {"another application"}));
    EXPECT_TRUE(refusesAfter("PRAGMA user_version = 9", {"version 9", "reads version 3"}));
    EXPECT_TRUE(refusesAfter("CREATE TABLE zebra(x)", {"tables"}));
}

TEST_F(FindingsFile, isRefusedAfterModification)
{
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET error_m = 0.5 WHERE position = 1", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE meta SET value = 'x' WHERE key = 'command'", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET seed = '1'", {"altered"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET seed = '1x'", {"seed is not a number"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM part", {"which part"}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET number = 3", {}));
    EXPECT_TRUE(refusesAfter("UPDATE part SET number = 4", {"out of range in its table part"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM scene WHERE position = 0", {"not numbered from 0"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM scene WHERE position = 2", {"scenes of its part"}));
    EXPECT_TRUE(
        refusesAfter("UPDATE bin_error SET scene = 9 WHERE position = 1", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET run = 2 WHERE position = 1", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE bin_error SET error_m = 9e999", {"out of range"}));
    EXPECT_TRUE(refusesAfter("UPDATE method SET name = 'guess'", {"unknown method", "'guess'"}));
    EXPECT_TRUE(refusesAfter("DELETE FROM method_run", {"lacks a method"}));
}

}  // namespace
}  // namespace terratact
