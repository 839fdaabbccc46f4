// Tests the file of notes beside a session.
#include "app/recording/review_notes.h"

#include <gtest/gtest.h>

#include "core/store/file_write.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(ReviewNotes, comeBackAsTheyWereWritten)
{
    TemporaryDirectory directory;
    const std::string session = directory.file("a.tts");
    const std::vector<ReviewNote> notes{{0.0, "plain"},      {1.25, "a, \"step\", or so"},
                                        {2.5, "\"quoted\""}, {3.0, "two\nlines\r\nand a third"},
                                        {4.0, ","},          {5.0, "\""},
                                        {6.0, ""},           {7.0, "schod, který „uhýbá“"},
                                        {8.0, "=1+1"},       {9.0, "-0.5"},
                                        {10.0, "'@home"}};
    ASSERT_TRUE(writeNotes(session, notes));
    const auto read = readNotes(session);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(*read, notes);
    EXPECT_NE(contentOf(notesPath(session)).find("8,'=1+1\n9,-0.5\n"), std::string::npos);

    const auto errorOf = [&](const std::string& text) {
        EXPECT_TRUE(writeFileAtomically(notesPath(session), text));
        const auto bad = readNotes(session);
        return bad ? std::string() : bad.error().text;
    };
    EXPECT_NE(errorOf("t_s,note\n1,\"two\nlines\"\n2,\"open\n").find("line 4: a quote"),
              std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,\"a\"b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nsoon,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\nnan,x\n").find("line 2: t_s"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1,a,b\n").find("line 2"), std::string::npos);
    EXPECT_NE(errorOf("t_s,note\n1").find("line 2: is torn"), std::string::npos);
    EXPECT_NE(errorOf("t,what\n").find("line 1: is no file of notes"), std::string::npos);
    EXPECT_NE(errorOf("").find("is empty"), std::string::npos);
    EXPECT_EQ(errorOf("t_s,note\r\n1,of another program\r\n"), "");
}

}  // namespace
}  // namespace terratact
