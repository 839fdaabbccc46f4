#include "drivers/stop_line.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
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

/// Runs `work` in a child process of the user nobody; returns its result, or -1 without the right to do so.
int asNobody(int (*work)())
{
    constexpr uid_t kNobody = 65534;
    const pid_t child = ::fork();
    if (child == 0) ::_exit(::setuid(kNobody) == 0 ? work() : 255);
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status) == 255 ? -1 : WEXITSTATUS(status);
}

std::string listenerName;

TEST(StopLine, ofAnotherUserIsNotHeard)
{
    listenerName = someName();
    auto line = StopLine::listen(listenerName);
    ASSERT_TRUE(line) << line.error().text;
    const int sent = asNobody([] {
        auto caller = StopCaller::open();
        return caller && caller->press(listenerName) ? 0 : 1;
    });
    if (sent < 0) GTEST_SKIP() << "only root may act as another user";
    ASSERT_EQ(sent, 0) << "it was sent";
    EXPECT_FALSE(line->consume());
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller && caller->press(listenerName));
    EXPECT_TRUE(line->consume()) << "the same user is heard";
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
