// Tests how messages are put together, and what an exception says.
#include "core/base/message.h"

#include <gtest/gtest.h>

namespace terratact {
namespace {

std::vector<Message> numbers(int count)
{
    std::vector<Message> all;
    for (int i = 1; i <= count; ++i) all.push_back(Message::verbatim(std::to_string(i)));
    return all;
}

TEST(Message, listsAnyNumberOfParts)
{
    EXPECT_TRUE(Message::listed({}, ", ").empty());
    EXPECT_EQ(Message::listed(numbers(1), ", "), Message::verbatim("1"));
    EXPECT_EQ(Message::listed(numbers(3), "; ").english(), "1; 2; 3");
    EXPECT_EQ(Message::listed(numbers(9), ",").english(), "1,2,3,4,5,6,7,8,9");
    const Message many = Message::listed(numbers(20), ",");
    EXPECT_EQ(many.english(), "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20");
    EXPECT_EQ(many.arguments.size(), 9U) << "a message has places %1 to %9";
}

TEST(Message, isFollowedByACommand)
{
    const Message down(TR_NOOP("core", "%1 is down"), "can0");
    EXPECT_EQ(Message::followedBy(down, "ip link").english(), "can0 is down (ip link)");
}

TEST(Message, ofAnExceptionKeepsItsParts)
{
    const Message reason(TR_NOOP("core", "%1 is down"), "can0");
    EXPECT_EQ(messageOf(Failure(reason)), reason);
    EXPECT_EQ(messageOf(RefusedInput(reason)), reason);
    EXPECT_EQ(messageOf(std::runtime_error("other")), Message::verbatim("other"));
    EXPECT_STREQ(RefusedInput(reason).what(), "can0 is down");
}

}  // namespace
}  // namespace terratact
