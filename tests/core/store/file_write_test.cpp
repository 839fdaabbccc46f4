#include "core/store/file_write.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>

#include "core/store/file_group.h"
#include "core/store/file_read.h"
#include "core/store/unfinished_files.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Names = std::set<std::string>;

TEST(UnfinishedFiles, areRemovedAndFinishedOnesStay)
{
    const TemporaryDirectory dir;
    auto done = NewFile::begin(dir.file("done")), open = NewFile::begin(dir.file("open"));
    ASSERT_TRUE(done && open);
    ASSERT_TRUE(done->commit());
    removeUnfinished();
    EXPECT_EQ(dir.entries(), Names{"done"});
    const std::string name = dir.write("again", "x");
    for (int i = 0; i < 99; ++i) {
        noteUnfinished(name);
        forgetUnfinished(name);
    }
    removeUnfinished();
    EXPECT_EQ(dir.entries(), (Names{"again", "done"})) << "and the slots are free again";
    noteUnfinished(name);
    removeUnfinished();
    forgetUnfinished(name);
    EXPECT_EQ(dir.entries(), Names{"done"});
    noteUnfinished(std::string(5000, 'x'));
}

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

TEST(WriteFileAtomically, writesThroughNoSymbolicLink)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("real.csv", "old"), link = dir.file("link.csv");
    for (const std::string& target : {path, dir.file("none.csv"), std::string("/dev/null")}) {
        std::filesystem::remove(link);
        std::filesystem::create_symlink(target, link);
        EXPECT_TRUE(refused(writeFileAtomically(link, "new"), link,
                            {"it is a symbolic link to " + target, "name the file itself"}));
        EXPECT_EQ(std::filesystem::read_symlink(link), target);
    }
    EXPECT_EQ(dir.entries(), (Names{"link.csv", "real.csv"}));
    // Everybody may write to this folder of the kernel's.
    const std::string shared = "/dev/shm/terratact-link-" + std::to_string(::getpid());
    std::filesystem::create_symlink(path, shared);
    EXPECT_TRUE(refused(writeFileAtomically(shared, "new"), shared, {"it is a symbolic link"}));
    std::filesystem::remove(shared);
    EXPECT_EQ(contentOf(path), "old");
}

TEST(WriteFileAtomically, takesOnlyExactNamesOfTheKernelForOpenFiles)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("real.csv", "old"), link = dir.file("link.csv");
    std::filesystem::create_symlink(path, link);
    for (const std::string detour : {"/proc/self/fd/../root", "/dev/fd/../root"})
        EXPECT_TRUE(refused(writeFileAtomically(detour + link, "new"), detour + link,
                            {"it is a symbolic link to " + path}));
    EXPECT_EQ(contentOf(path), "old");
    const int open = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    for (const std::string folder : {"/proc/self/fd/", "/dev/fd/"})
        EXPECT_TRUE(checkLinks(folder + std::to_string(open)));
    EXPECT_TRUE(writeFileAtomically("/proc/self/fd/" + std::to_string(open), "new"));
    EXPECT_EQ(contentOf(path), "new");
    ::close(open);
}

TEST(WriteFileAtomically, writesInAFolderThatIsItsUsersOwnLink)
{
    const TemporaryDirectory dir;
    ASSERT_TRUE(makeDirectory(dir.file("disk")));
    const std::string link = dir.file("link");
    std::filesystem::create_directory_symlink(dir.file("disk"), link);
    EXPECT_TRUE(writeFileAtomically(link + "/out.csv", "new"));
    EXPECT_EQ(contentOf(dir.file("disk/out.csv")), "new");
    EXPECT_TRUE(makeDirectory(link + "/below/"));
    constexpr uid_t kNobody = 65534;
    if (::lchown(link.c_str(), kNobody, kNobody) != 0) GTEST_SKIP() << "only root gives files away";
    EXPECT_TRUE(refused(writeFileAtomically(link + "/other.csv", "x"), link,
                        {"a symbolic link of another user"}));
    const std::string run = link + "/run";
    EXPECT_TRUE(refused(makeDirectory(run), run, {"a symbolic link of another user"}));
    EXPECT_FALSE(std::filesystem::exists(dir.file("disk/run")));
}

TEST(WriteFileAtomically, writesNoTemporaryThroughALink)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("mine.txt", "old");
    std::filesystem::create_symlink(path, dir.file("out.csv.tmp0"));
    ASSERT_TRUE(writeFileAtomically(dir.file("out.csv"), "new"));
    Result<NewFile> file = NewFile::begin(dir.file("out.csv"));
    ASSERT_TRUE(file);
    std::filesystem::remove(file->temporaryPath());
    std::filesystem::create_symlink(path, file->temporaryPath());
    EXPECT_LT(file->openTemporary(), 0) << "somebody has exchanged it since";
    EXPECT_EQ(contentOf(path), "old");
}

/// Returns the permissions of a file written for `first`, and after its replacement for `again`. The umask is 022.
std::pair<mode_t, mode_t> modesOf(Access first, Access again)
{
    const TemporaryDirectory dir;
    const std::string path = dir.file("out.csv");
    const auto written = [&path](Access access) {
        EXPECT_TRUE(writeFileAtomically(path, "x", access));
        struct stat at {};
        EXPECT_EQ(::stat(path.c_str(), &at), 0);
        return at.st_mode & 07777U;
    };
    const mode_t before = ::umask(022);
    const mode_t one = written(first), two = written(again);
    ::umask(before);
    return {one, two};
}

TEST(WriteFileAtomically, aNewFileIsForItsOwnerUnlessPassedOn)
{
    using Modes = std::pair<mode_t, mode_t>;
    EXPECT_EQ(modesOf(Access::Owner, Access::Everybody), (Modes{0600, 0600}));
    EXPECT_EQ(modesOf(Access::Everybody, Access::Owner), (Modes{0644, 0644})) << "modes are kept";
    EXPECT_EQ(modesOf(Access::Everybody, Access::OwnerAlways), (Modes{0644, 0600}));
    const TemporaryDirectory dir;
    const mode_t before = ::umask(0);
    FileGroup files;
    const Status written = files.add(dir.file("a"), "x");
    const Status committed = files.commit();
    ::umask(before);
    ASSERT_TRUE(written && committed);
    struct stat at {};
    ASSERT_EQ(::stat(dir.file("a").c_str(), &at), 0);
    EXPECT_EQ(at.st_mode & 07777U, 0600U) << "without a word about it";
}

TEST(WriteFileAtomically, forItsOwnerHeedsNoUmask)
{
    const TemporaryDirectory dir;
    for (const mode_t mask : {0000U, 0022U, 0777U}) {
        const mode_t before = ::umask(mask);
        const std::string folder = dir.file("folder" + std::to_string(mask) + "/inner");
        const Status made = makeDirectory(folder, Access::Owner);
        const Status written = writeFileAtomically(folder + "/out.csv", "x", Access::Owner);
        ::umask(before);
        ASSERT_TRUE(made && written) << mask;
        struct stat at {};
        ASSERT_EQ(::stat(folder.c_str(), &at), 0);
        EXPECT_EQ(at.st_mode & 07777U, 0700U) << mask;
        ASSERT_EQ(::stat((folder + "/out.csv").c_str(), &at), 0);
        EXPECT_EQ(at.st_mode & 07777U, 0600U) << mask;
    }
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

TEST(WriteFileAtomically, leavesTheNameOfAJournalFree)
{
    const TemporaryDirectory dir;
    for (const char* const name : {"a.tts-wal", "a.tts-shm", "A.TTS-journal"})
        EXPECT_TRUE(refused(writeFileAtomically(dir.file(name), "x"), dir.file(name),
                            {"the name of a session's journal"}));
    EXPECT_TRUE(dir.entries().empty());
    EXPECT_TRUE(writeFileAtomically(dir.file("tts-wal"), "x"));
}

}  // namespace
}  // namespace terratact
