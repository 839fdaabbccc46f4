#include "drivers/stop_line.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "drivers/posix_fd.h"
#include "tests/support/other_user.h"
#include "tests/support/temporary_directory.h"

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

std::string listenerPath;

TEST(StopLine, ofAnotherUserIsIgnored)
{
    const TemporaryDirectory folder;
    ASSERT_EQ(::chmod(folder.file("").c_str(), 0777), 0);
    listenerPath = folder.file("stop");
    auto line = StopLine::listen(listenerPath);
    ASSERT_TRUE(line) << line.error().text;
    constexpr uid_t kNobody = 65534;
    const int refused = asOtherUser(kNobody, [] {
        auto caller = StopCaller::open();
        constexpr int kFlood = 100;
        for (int i = 0; i < kFlood; ++i)
            if (!caller || caller->press(listenerPath)) return i;
        return kFlood;
    });
    if (refused < 0) GTEST_SKIP() << "only root may act as another user";
    EXPECT_EQ(refused, 100) << "the kernel takes none of them";
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller && caller->press(listenerPath)) << "they have not filled the queue";
    EXPECT_TRUE(line->consume()) << "the same user is heard";
    EXPECT_FALSE(line->consume());
}

TEST(StopLine, aFloodIsReadInPartsAndHidesNoStop)
{
    auto line = StopLine::listen(someName());
    ASSERT_TRUE(line) << line.error().text;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    someName().copy(address.sun_path, sizeof address.sun_path - 1);
    const PosixFd flood(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    ASSERT_EQ(::connect(flood.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
              0);
    for (int i = 0; i < StopLine::kMaxDatagrams; ++i) ASSERT_EQ(::send(flood.get(), "x", 1, 0), 1);
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller && caller->press(someName()));
    EXPECT_FALSE(line->consume()) << "one call reads no more, so that no flood holds it";
    EXPECT_TRUE(line->consume());
    EXPECT_TRUE(caller->isTaken());
}

TEST(StopLine, leavesNoFile)
{
    const TemporaryDirectory folder;
    {
        auto line = StopLine::listen(folder.file("stop"));
        ASSERT_TRUE(line) << line.error().text;
        const StopLine moved(std::move(*line));
        struct stat made {};
        ASSERT_EQ(::stat(folder.file("stop").c_str(), &made), 0);
        EXPECT_EQ(made.st_mode & 0077U, 0U) << "others cannot send to it";
    }
    EXPECT_TRUE(folder.entries().empty());
}

TEST(StopLine, ofAKilledListenerRefuses)
{
    const TemporaryDirectory folder;
    const std::string path = folder.file("stop"), left = folder.file("left");
    auto listens = StopLine::listen(path);
    ASSERT_TRUE(listens) << listens.error().text;
    auto line = std::make_unique<StopLine>(std::move(*listens));
    ASSERT_EQ(std::rename(path.c_str(), left.c_str()), 0) << "so that the socket stays";
    line.reset();
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller);
    const Status sent = caller->press(left);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, ECONNREFUSED);
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
    EXPECT_EQ(sent.error().code, ENOENT) << "the listener took its socket along";
    EXPECT_TRUE(StopLine::listen(someName())) << "a later console may have it";
    EXPECT_FALSE(StopLine::listen(""));
    EXPECT_FALSE(StopLine::listen(std::string(101, 'x')));
}

}  // namespace
}  // namespace terratact
