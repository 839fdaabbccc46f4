// Tests that text output is written completely or not at all.
#include "app/runtime/text_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <set>
#include <string>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(TextOutput, leavesTheOldFileUntilItIsCommitted)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("a.csv", "old");
    {
        auto output = TextOutput::begin(path);
        ASSERT_TRUE(output);
        output->stream() << "half";
        output->stream().flush();
        EXPECT_EQ(contentOf(path), "old");
    }
    EXPECT_EQ(contentOf(path), "old") << "it was not committed";
    EXPECT_EQ(directory.entries(), std::set<std::string>{"a.csv"});
    ASSERT_TRUE(writeText(path, "new"));
    EXPECT_EQ(contentOf(path), "new");
}

TEST(TextOutput, leavesTheRenamingToItsGroup)
{
    const TemporaryDirectory directory;
    const std::string path = directory.write("a.csv", "old");
    FileGroup files;
    auto output = TextOutput::begin(path);
    ASSERT_TRUE(output);
    output->stream() << "new";
    ASSERT_TRUE(output->addTo(files));
    EXPECT_EQ(contentOf(path), "old");
    ASSERT_TRUE(files.commit());
    EXPECT_EQ(contentOf(path), "new");
    EXPECT_EQ(directory.entries(), std::set<std::string>{"a.csv"});
    auto full = TextOutput::begin("/dev/full");
    ASSERT_TRUE(full);
    full->stream() << "x";
    EXPECT_TRUE(refused(full->addTo(files), "/dev/full", {"cannot be written"}));
}

TEST(TextOutput, namesTheFileThatCannotBeWritten)
{
    const TemporaryDirectory directory;
    const std::string nowhere = directory.file("none/a.csv");
    EXPECT_TRUE(refused(writeText(nowhere, "x"), nowhere, {}));
    EXPECT_TRUE(refused(writeText("/dev/full", "x"), "/dev/full", {"cannot be written"}));
}

TEST(TextOutput, writesIntoAPipeInsteadOfReplacingIt)
{
    const TemporaryDirectory directory;
    const std::string pipe = directory.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    EXPECT_TRUE(isStream(pipe));
    ASSERT_TRUE(writeText(pipe, "through"));
    std::array<char, 16> read{};
    EXPECT_EQ(::read(reader, read.data(), read.size()), 7);
    EXPECT_EQ(std::string(read.data()), "through");
    ::close(reader);
    EXPECT_TRUE(isStream(pipe)) << "it is still a pipe";
    EXPECT_FALSE(isStream(directory.write("file", "")));
}

TEST(TextOutput, messagesLeaveStandardOutputToData)
{
    for (const char* name : {"-", "/dev/stdout", "/dev/fd/1"}) {
        EXPECT_TRUE(isStandardOutput(name)) << name;
        EXPECT_EQ(messagesBeside(name), stderr) << name;
    }
    EXPECT_FALSE(isStandardOutput("./-"));
    EXPECT_EQ(messagesBeside("a.csv"), stdout);
}

}  // namespace
}  // namespace terratact
