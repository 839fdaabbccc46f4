#include "drivers/stop_line.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string>
#include <utility>

namespace terratact {
namespace {

std::string someName()
{
    return "terratact-stop-line-test-" + std::to_string(::getpid());
}

TEST(StopLine, isReceivedAndAnswered)
{
    auto line = StopLine::listen(someName());
    ASSERT_TRUE(line) << line.error().text;
    auto caller = StopCaller::open(), another = StopCaller::open();
    ASSERT_TRUE(caller && another);
    EXPECT_FALSE(line->consume()) << "nobody has pressed";
    ASSERT_TRUE(caller->press(someName()));
    EXPECT_FALSE(caller->isTaken()) << "nobody has looked";
    EXPECT_TRUE(line->consume());
    EXPECT_FALSE(line->consume()) << "once";
    EXPECT_FALSE(another->isTaken());
    EXPECT_TRUE(caller->isTaken());
    EXPECT_FALSE(caller->isTaken());
    ASSERT_TRUE(caller->press(someName()));
    ASSERT_TRUE(line->consume());
    ASSERT_TRUE(caller->press(someName()));
    EXPECT_FALSE(caller->isTaken()) << "that answer was to the press before";
}

TEST(StopLine, missingListenerIsAnError)
{
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller);
    auto listens = StopLine::listen(someName());
    ASSERT_TRUE(listens);
    auto line = std::make_unique<StopLine>(std::move(*listens));
    EXPECT_FALSE(StopLine::listen(someName())) << "the name is taken";
    EXPECT_TRUE(caller->press(someName()));
    line.reset();
    const Status sent = caller->press(someName());
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, ECONNREFUSED);
    EXPECT_TRUE(StopLine::listen(someName())) << "a later console may have it";
    EXPECT_FALSE(StopLine::listen(""));
    EXPECT_FALSE(StopLine::listen(std::string(101, 'x')));
}

}  // namespace
}  // namespace terratact
