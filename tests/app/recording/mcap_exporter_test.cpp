// Tests MCAP exports of a session.
#include <gtest/gtest.h>

#include "tests/support/session_files.h"

namespace terratact {
namespace {

TEST_F(SessionFiles, escapesTextsOfAForeignFile)
{
    const std::string path = session("words.tts", [](SessionWriter& writer) {
        ASSERT_TRUE(writer.add(EventRow{.id = 1,
                                        .kind = EventKind::Marker,
                                        .text = "a, \"b\"\nc\xFF\x01",
                                        .shown = "</script>"}));
    });
    EXPECT_NE(exported(path, "a.mcap")
                  .find(R"("text":"a, \"b\"\u000ac)"
                        "\xEF\xBF\xBD"
                        R"(\u0001")"),
              std::string::npos);
}

}  // namespace
}  // namespace terratact
