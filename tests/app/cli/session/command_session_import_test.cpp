// Tests sessions made of logs of CAN frames.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/cli/session/session_commands.h"
#include "core/log/session_reader.h"
#include "tests/support/sessions/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, aLogOfTimeDifferencesHasAnEvent)
{
    std::string text = " (000.000000)  can0  500   [1]  00\n";
    for (int i = 0; i < 12; ++i)
        text += fmt::format(" (000.05{:04})  can0  500   [1]  00\n", i % 3 * 100);
    const std::string out = directory.file("a.tts");
    const Status done = importLog({.log = directory.write("a.log", text),
                                   .out = out,
                                   .interface = {},
                                   .robot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml"});
    ASSERT_TRUE(done) << done.error().text;
    const auto reader = SessionReader::open(out);
    ASSERT_TRUE(reader) << reader.error().text;
    const auto gap = std::ranges::find(reader->events(), EventKind::Gap, &EventRow::kind);
    ASSERT_NE(gap, reader->events().end());
    EXPECT_EQ(gap->subject, "clock");
    EXPECT_EQ(gap->text, "9 of 12 times are no later than the one before, from 0 on: is this a log "
                         "of candump -td, whose times are wrong here? Record with candump -L");
}

TEST_F(SessionFiles, microsecondsOfALogStayAsTheyWere)
{
    const std::string out = directory.file("a.tts");
    const Status done =
        importLog({.log = directory.write("a.log", "(1700000000.123457) can0 500#\n"
                                                   "(1700000001.223456) can0 500#\n"),
                   .out = out,
                   .interface = {},
                   .robot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml"});
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_NE(exported(out, "a.csv", ExportKind::Frames).find("\n1700000001.223456000,"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
