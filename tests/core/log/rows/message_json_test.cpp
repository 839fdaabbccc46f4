// Messages survive being stored, and no other text is taken for one.
#include "core/log/rows/message_json.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

TEST(MessageJson, isReadAsItWasWritten)
{
    const Message inner(TR_NOOP("core", "%1 is %2"), "a \"quoted\" \\ name\n", 0.25);
    const Message all[]{
        {},
        Message::verbatim("robot.toml"),
        TR_NOOP("core", "the robot is armed"),
        inner,
        Message::joined(Message::verbatim("robot.toml"),
                        {TR_NOOP("core", "line %1: %2"), 7, inner}),
    };
    for (const Message& message : all) {
        const auto read = messageFromJson(jsonOf(message));
        ASSERT_TRUE(read) << jsonOf(message);
        EXPECT_EQ(*read, message) << jsonOf(message);
    }
    EXPECT_EQ(all[4].english(), "robot.toml: line 7: a \"quoted\" \\ name\n is 0.25");
}

TEST(MessageJson, refusesWhatIsNotWritten)
{
    std::string deep;
    for (int i = 0; i < 9; ++i) deep += R"(["c","%1",)";
    for (const std::string& json :
         {std::string("word"), std::string("[]"), std::string(R"(["a"])"), std::string(R"("a" )"),
          std::string(R"(["a","b",1])"), std::string(R"("\n")"), std::string(R"("\u0041")"),
          std::string(R"(["a","b","1","2","3","4","5","6","7","8","9","10"])"),
          deep + "\"\"" + std::string(9, ']')})
        EXPECT_FALSE(messageFromJson(json)) << json;
}

TEST(Message, putsArgumentsInTheirPlaces)
{
    const Message message(TR_NOOP("core", "%2 before %1, 100 % of %3"), 1, std::string("two"));
    EXPECT_EQ(message.english(), "two before 1, 100 % of ");
    EXPECT_EQ(Message::verbatim("50 %1").english(), "50 %1");
    EXPECT_EQ(fixed(-0.126, 2), "-0.13");
}

}  // namespace
}  // namespace terratact
