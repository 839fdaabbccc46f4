// Tests the command that lists a folder's recordings.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/cli/session/session_commands.h"
#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, listHasALineForEachAndOneForABrokenFile)
{
    const std::string path = session("b.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(ModelRow{.id = 1, .name = "a.ttm", .hash = std::string(64, 'c')}));
        ASSERT_TRUE(writer.add(someScene(1, 1'000'000)));
        ASSERT_TRUE(writer.add(someEstimate(1, 2'000'000)));
    });
    directory.write("a.tts", std::string(200, 'x'));
    testing::internal::CaptureStdout();
    const Status listed = listSessions(std::filesystem::path(path).parent_path().string());
    const std::string text = testing::internal::GetCapturedStdout();
    ASSERT_TRUE(listed) << listed.error().text;
    EXPECT_NE(text.find("Absolem  b.tts\na.tts: is not an SQLite file\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("  sealed  "), std::string::npos) << text;
    EXPECT_NE(text.find("      0        0            1       0  "), std::string::npos) << text;
    EXPECT_FALSE(listSessions(directory.file("nowhere")));
}

}  // namespace
}  // namespace terratact
