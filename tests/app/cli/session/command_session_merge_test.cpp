// Tests which sessions are refused as one drive.
#include <gtest/gtest.h>

#include "app/cli/session/session_commands.h"
#include "tests/support/refusal.h"
#include "tests/support/sessions/session_files.h"
#include "tests/support/sessions/sessions.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, sessionsOfDifferentMonthsAreNotOneDrive)
{
    const auto oneFrame = [](SessionWriter& writer) { ASSERT_TRUE(writer.add(someFrame(0))); };
    const std::string now = session("now.tts", oneFrame);
    const std::string ages =
        session("ages.tts", oneFrame, (std::int64_t{1} << 62U) - someStart().wallTime);
    const std::string out = directory.file("whole.tts");
    EXPECT_TRUE(
        refused(mergeSessions({.files = {now, ages}, .out = out}), ages, {"a month apart"}));
    EXPECT_FALSE(directory.entries().contains("whole.tts"));
}

}  // namespace
}  // namespace terratact
