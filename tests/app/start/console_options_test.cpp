// Tests the command line of the console.
#include "app/start/console_options.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>

namespace terratact {
namespace {

/// Returns the reason of a refusal; empty: accepted.
std::string refusal(const std::string& line, ConsoleOptions* into = nullptr)
{
    ConsoleOptions options;
    CLI::App app;
    declareOptions(app, into ? *into : options);
    try {
        app.parse(line);
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return {};
}

TEST(ConsoleOptionsTest, aReplayAndAPictureAreNotRecorded)
{
    EXPECT_TRUE(ConsoleOptions{}.records());
    for (const char* line : {"drive.tts", "--screenshot a.png", "--no-record"}) {
        ConsoleOptions options;
        EXPECT_EQ(refusal(line, &options), "");
        EXPECT_FALSE(options.records()) << line;
    }
}

TEST(ConsoleOptionsTest, aWindowHasASizeThatItsPartsFit)
{
    ConsoleOptions options;
    EXPECT_EQ(refusal("--size 1280x720", &options), "");
    EXPECT_EQ(options.size, QSize(1280, 720));
    for (const char* size :
         {"1280", "1280x720x3", "1x1", "1199x680", "20000x720", "x720", "-1280x720"})
        EXPECT_NE(refusal(std::string("--size=") + size).find("expected WIDTHxHEIGHT"),
                  std::string::npos)
            << size;
}

TEST(ConsoleOptionsTest, onlyARobotOnABusIsCommanded)
{
    EXPECT_NE(refusal("--transmit"), "");
    EXPECT_EQ(refusal("--can can0 --transmit"), "");
    EXPECT_NE(refusal("--can can0 --fault silence"), "") << "a real robot has no such faults";
    EXPECT_NE(refusal("drive.log --can can0"), "") << "one of the two is shown";
    EXPECT_NE(refusal("--speed 2"), "") << "there is no replay";
    EXPECT_NE(refusal("drive.log --speed 0"), "");
}

TEST(ConsoleOptionsTest, anUnknownDisplayOptionIsRefused)
{
    EXPECT_EQ(refusal("--theme night-red --layout drive --language cs --font-scale 120 "
                      "--length-unit cm --angle-unit rad"),
              "");
    for (const char* line : {"--theme pink", "--layout wide", "--language tlh", "--font-scale 1000",
                             "--length-unit mm", "--angle-unit grad"})
        EXPECT_NE(refusal(line), "") << line;
}

}  // namespace
}  // namespace terratact
