// Tests the robot's activity in few words.
#include "app/mission/text/robot_text.h"

#include <gtest/gtest.h>

#include <set>

namespace terratact {
namespace {

TEST(ActivityOfTheRobot, hasADistinctShortText)
{
    std::set<QString> texts;
    for (int i = 0; i <= static_cast<int>(RobotActivity::Stopped); ++i) {
        const QString text = glance(static_cast<RobotActivity>(i));
        EXPECT_TRUE(texts.insert(text).second) << text.toStdString();
        EXPECT_FALSE(text.isEmpty()) << i;
        EXPECT_LE(text.size(), 16) << "it has a place in the header: " << text.toStdString();
    }
}

TEST(ActivityOfTheRobot, onlyAStopLooksBadAndOnlyAPressGood)
{
    for (int i = 0; i <= static_cast<int>(RobotActivity::Stopped); ++i) {
        const auto activity = static_cast<RobotActivity>(i);
        EXPECT_EQ(toneOf(activity) == Tone::Bad, activity == RobotActivity::Stopped) << i;
        EXPECT_EQ(toneOf(activity) == Tone::Good, activity == RobotActivity::Pressed) << i;
    }
}

}  // namespace
}  // namespace terratact
