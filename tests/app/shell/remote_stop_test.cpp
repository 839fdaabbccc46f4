// Tests what a window says of STOP that no console can receive.
#include "app/shell/remote_stop.h"

#include <gtest/gtest.h>

#include <QByteArray>
#include <QObject>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "core/base/message.h"
#include "drivers/stop_line.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct RemoteStopTo : testing::Test {
    void SetUp() override
    {
        std::filesystem::create_directory(folder.file("own"));
        auto listens = StopLine::listen(path);
        ASSERT_TRUE(listens) << listens.error().text;
        line.emplace(std::move(*listens));
    }

    /// Presses STOP in a window that this console opened. Returns what the window says.
    std::string pressed(const std::string& at) const
    {
        qputenv(kStopLineVariable, QByteArray::fromStdString(at));
        RemoteStop stop;
        qunsetenv(kStopLineVariable);
        std::string said;
        QObject::connect(&stop, &RemoteStop::reported,
                         [&said](const Message& text) { said = text.english(); });
        stop.press();
        return said;
    }

    const TemporaryDirectory folder;
    const std::string path = folder.file("own/stop");
    std::optional<StopLine> line;
};

TEST_F(RemoteStopTo, aConsoleWhoseSocketIsRemovedIsNotGone)
{
    const std::string notFound = "STOP NOT SENT: the console's stop line was not found at " + path
                               + "; press STOP in the console, or use the robot's own switch";
    std::filesystem::remove(path);
    EXPECT_EQ(pressed(path), notFound);
    std::filesystem::remove_all(folder.file("own"));
    EXPECT_EQ(pressed(path), notFound) << "a cleaner of temporary files removed the folder";
    EXPECT_FALSE(line->consume());
}

TEST_F(RemoteStopTo, aKilledConsoleIsGone)
{
    const std::string left = folder.file("left");
    std::filesystem::rename(path, left);  // so that the socket stays, as when the console is killed
    EXPECT_EQ(pressed(left), "STOP SENT to the console that opened this window …");
    line.reset();
    EXPECT_EQ(pressed(left),
              "STOP HAS NO EFFECT HERE: the console that opened this window is gone");
}

}  // namespace
}  // namespace terratact
