#include "core/store/file_write.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <utility>

#include "core/store/file_read.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Names = std::set<std::string>;

TEST(WriteFileAtomically, putsTheContentAndNothingElseThere)
{
    const TemporaryDirectory dir;
    const std::string content("a\0b\r\n", 5);
    ASSERT_TRUE(writeFileAtomically(dir.file("out.csv"), content));
    EXPECT_EQ(contentOf(dir.file("out.csv")), content);
    EXPECT_EQ(dir.entries(), Names{"out.csv"});
}

TEST(WriteFileAtomically, replacesAFileAndKeepsItsPermissions)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("out.csv", "old");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    ASSERT_TRUE(writeFileAtomically(path, "new"));
    EXPECT_EQ(contentOf(path), "new");
    struct stat now {};
    ASSERT_EQ(::stat(path.c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 07777U, 0640U);
}

TEST(WriteFileAtomically, followsASymbolicLink)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("real.csv", "old");
    std::filesystem::create_symlink(path, dir.file("link.csv"));
    ASSERT_TRUE(writeFileAtomically(dir.file("link.csv"), "new"));
    EXPECT_TRUE(std::filesystem::is_symlink(dir.file("link.csv")));
    EXPECT_EQ(contentOf(path), "new");
}

TEST(WriteFileAtomically, writesBesideALeftoverOfAnInterruptedOne)
{
    const TemporaryDirectory dir;
    dir.write("out.csv.tmp0", "torn");
    ASSERT_TRUE(writeFileAtomically(dir.file("out.csv"), "whole"));
    EXPECT_EQ(contentOf(dir.file("out.csv")), "whole");
    EXPECT_EQ(contentOf(dir.file("out.csv.tmp0")), "torn");
}

TEST(WriteFileAtomically, refusesWhatIsNotAFile)
{
    const TemporaryDirectory dir;
    const std::string inside = dir.file("none/out.csv");
    EXPECT_TRUE(refused(writeFileAtomically(inside, "x"), inside, {"No such file or directory"}));
    const std::string directory = dir.file("");
    EXPECT_TRUE(refused(writeFileAtomically(directory, "x"), directory, {"Is a directory"}));
    const std::string pipe = dir.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(refused(writeFileAtomically(pipe, "x"), pipe, {"not a regular file"}));
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    EXPECT_EQ(dir.entries(), Names{"pipe"});
}

TEST(WriteFileAtomically, leavesTheOldFileWhenTheDiskIsFull)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("out.csv", "old");
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit tight {
        4096, before.rlim_max
    };
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const Status status = writeFileAtomically(path, std::string(10000, 'x'));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_TRUE(refused(status, path, {"cannot be written"}));
    EXPECT_EQ(status.error().code, EFBIG);
    EXPECT_EQ(contentOf(path), "old");
    EXPECT_EQ(dir.entries(), Names{"out.csv"});
}

TEST(NewFile, isNotSeenBeforeCommitAndGoneWithoutIt)
{
    const TemporaryDirectory dir;
    {
        Result<NewFile> file = NewFile::begin(dir.file("out.csv"));
        ASSERT_TRUE(file);
        EXPECT_EQ(dir.entries().count("out.csv"), 0U);
        EXPECT_EQ(dir.entries().size(), 1U);
        const NewFile moved = *std::move(file);
        EXPECT_EQ(dir.entries().size(), 1U);
    }
    EXPECT_EQ(dir.entries(), Names{});
}

TEST(ReadFile, returnsEveryByteOrAnError)
{
    const TemporaryDirectory dir;
    const std::string content(100000, '\0');
    const std::string path = dir.write("in", content);
    EXPECT_EQ(*readFile(path, content.size()), content);
    EXPECT_TRUE(refused(readFile(path, content.size() - 1), path, {"larger than the 99999 bytes"}));
    const std::string none = dir.file("none");
    EXPECT_TRUE(refused(readFile(none, 1), none, {"cannot be opened", "No such file"}));
    EXPECT_EQ(readFile(none, 1).error().code, ENOENT);
    EXPECT_TRUE(refused(readFile(dir.file(""), 1), dir.file(""), {"Is a directory"}));
}

}  // namespace
}  // namespace terratact
