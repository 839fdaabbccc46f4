#include "core/store/file_group.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(FileGroup, putsEveryFileInPlaceAtCommit)
{
    const TemporaryDirectory dir;
    dir.write("a.csv", "old");
    FileGroup files;
    ASSERT_TRUE(files.add(dir.file("a.csv"), "new"));
    ASSERT_TRUE(files.writer()(dir.file("b.csv"), "more"));
    EXPECT_EQ(contentOf(dir.file("a.csv")), "old");
    EXPECT_EQ(dir.entries().count("b.csv"), 0U);
    ASSERT_TRUE(files.commit());
    EXPECT_EQ(contentOf(dir.file("a.csv")), "new");
    EXPECT_EQ(contentOf(dir.file("b.csv")), "more");
    EXPECT_EQ(dir.entries().size(), 2U);
}

TEST(FileGroup, changesNothingIfOneFileCannotBeWritten)
{
    const TemporaryDirectory dir;
    dir.write("a.csv", "old");
    {
        FileGroup files;
        ASSERT_TRUE(files.add(dir.file("a.csv"), "new"));
        EXPECT_FALSE(files.add(dir.file("none/b.csv"), "more"));
    }
    EXPECT_EQ(contentOf(dir.file("a.csv")), "old");
    EXPECT_EQ(dir.entries().size(), 1U);
}

}  // namespace
}  // namespace terratact
