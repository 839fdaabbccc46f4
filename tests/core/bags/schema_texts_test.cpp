// Tests which message definitions of a recording are kept.
#include "core/bags/schema_texts.h"

#include <gtest/gtest.h>

#include <string>

namespace terratact {
namespace {

TEST(SchemaTexts, keepEqualTextsOfATypeOnce)
{
    SchemaTexts texts;
    const auto kept = texts.keep("p/T", "bool a\n");
    ASSERT_TRUE(kept);
    EXPECT_EQ(**kept, "bool a\n");
    EXPECT_EQ(*texts.keep("p/T", "bool a\n"), *kept);
    EXPECT_NE(*texts.keep("p/T", "bool b\n"), *kept);
    EXPECT_NE(*texts.keep("p/U", "bool a\n"), *kept);
}

TEST(SchemaTexts, leaveOutATextWhoseEncodingIsNotRead)
{
    SchemaTexts texts;
    EXPECT_EQ(**texts.keep("p/T", "bool a\n", "ros2msg"), "bool a\n");
    const std::string tooLong(MessageSchema::kMaxText + 1, ' ');
    const auto kept = texts.keep("p/T", tooLong, "ros2idl");
    ASSERT_TRUE(kept);
    EXPECT_EQ(**kept, "");
}

TEST(SchemaTexts, refuseATextThatIsTooLarge)
{
    SchemaTexts texts;
    EXPECT_TRUE(texts.keep("p/T", std::string(MessageSchema::kMaxText, ' ')));
    const auto kept = texts.keep("p/T", std::string(MessageSchema::kMaxText + 1, ' '));
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().text,
              "the definition of p/T has 1048577 bytes, more than 1048576; it is left out");
}

TEST(SchemaTexts, haveABoundedSizeTogether)
{
    SchemaTexts texts;
    std::string text(MessageSchema::kMaxText, ' ');
    for (std::size_t bytes = 0; bytes < SchemaTexts::kMaxBytes; bytes += text.size()) {
        ++text[0];
        ASSERT_TRUE(texts.keep("p/T", text));
    }
    EXPECT_TRUE(texts.keep("p/T", text)) << "it is kept already";
    const auto kept = texts.keep("p/U", " ");
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().text, "the definition of p/U is left out: with it, all definitions have "
                                 "more than 4194304 bytes");
}

}  // namespace
}  // namespace terratact
