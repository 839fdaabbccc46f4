// Tests the list of a folder's recordings.
#include "app/recording/session_listing.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/recording/review_notes.h"
#include "core/log/session_writer.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct SessionListing : testing::Test {
    TemporaryDirectory directory;
    std::string folder = std::filesystem::path(directory.file("x")).parent_path().string();

    std::string make(const char* name)
    {
        auto writer = someSession(directory.file(name), 1000);
        EXPECT_TRUE(writer);
        EXPECT_TRUE(writer->seal());
        return directory.file(name);
    }
};

TEST_F(SessionListing, newestNamesComeFirstAndTheRestIsCounted)
{
    const std::string a = make("a.tts"), b = make("b.tts"), c = make("c.tts");
    directory.write("d.csv", "no session");
    std::filesystem::create_symlink(a, directory.file("e.tts"));
    const auto all = sessionFilesIn(folder);
    ASSERT_TRUE(all);
    EXPECT_EQ(all->paths, (std::vector<std::string>{c, b, a}));
    EXPECT_EQ(all->leftOut, 0U);
    const auto some = sessionFilesIn(folder, 2);
    ASSERT_TRUE(some);
    EXPECT_EQ(some->paths, (std::vector<std::string>{c, b}));
    EXPECT_EQ(some->leftOut, 1U);
}

TEST_F(SessionListing, aFolderThatCannotBeReadIsNamed)
{
    const auto none = sessionFilesIn(folder + "/nowhere");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().text.find(folder + "/nowhere: the folder cannot be read"), 0U)
        << none.error().text;
}

TEST_F(SessionListing, withoutAFolderNamesWhatHelps)
{
    const auto none = sessionFilesIn("");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().text, "there is no home folder that may hold recordings: name a folder, "
                                 "or set HOME or XDG_STATE_HOME");
}

TEST_F(SessionListing, aRecordingHasItsSizeAndTheNotesOfReviews)
{
    const std::string path = make("a.tts");
    const auto before = std::filesystem::last_write_time(path);
    ASSERT_TRUE(writeNotes(path, {{1.0, "the rubble at the door"}, {2.0, "turned here"}}));
    const ListedSession listed = listSession(path);
    ASSERT_TRUE(listed.summary) << listed.trouble.english();
    EXPECT_EQ(listed.bytes, static_cast<std::int64_t>(std::filesystem::file_size(path)));
    EXPECT_EQ(listed.wallTime(), someStart().wallTime);
    EXPECT_NEAR(listed.seconds(), 0.999, 1e-9);
    EXPECT_EQ(listed.reviewNotes,
              (std::vector<std::string>{"the rubble at the door", "turned here"}));
    EXPECT_EQ(listed.notes(), 2);
    EXPECT_EQ(std::filesystem::last_write_time(path), before);
}

TEST_F(SessionListing, aStrangersFileHasItsReasonAndItsDate)
{
    const std::string path = directory.write("a.tts", std::string(200, 'x'));
    directory.write("a.tts.notes.csv", "not,notes\n");
    const ListedSession listed = listSession(path);
    EXPECT_FALSE(listed.summary);
    EXPECT_EQ(listed.trouble.english(), "is not an SQLite file");
    EXPECT_TRUE(listed.reviewNotes.empty());
    EXPECT_GT(listed.wallTime(), 0);
    EXPECT_EQ(listed.seconds(), 0.0);
}

}  // namespace
}  // namespace terratact
