// Tests that a drive is recognised whatever its name.
#include "core/learn/data/drive_copies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

namespace terratact {
namespace {

DriveLines someDrive(double pitch)
{
    DriveLines drive{.run = "1", .onePlane = true, .lines = std::vector<DriveLine>(12)};
    for (std::size_t k = 0; k < drive.lines.size(); ++k) {
        Measurement& line = drive.lines[k].line;
        line.pitch = pitch + 0.01 * static_cast<double>(k);
        line.travelled = 0.1 * static_cast<double>(k);
        drive.lines[k].isScene = k % 4 == 3;
    }
    return drive;
}

TEST(DriveCopies, knowsADriveByAnotherNameAndNumberFormat)
{
    DriveCopies copies;
    EXPECT_FALSE(copies.isCopy(someDrive(0.1)));
    DriveLines other = someDrive(0.1 + 0.0004);
    other.run = "again";
    EXPECT_TRUE(copies.isCopy(other));
}

TEST(DriveCopies, keepsDrivesThatDiffer)
{
    DriveCopies copies;
    EXPECT_FALSE(copies.isCopy(someDrive(0.1)));
    EXPECT_FALSE(copies.isCopy(someDrive(0.102)));
    DriveLines oneScene = someDrive(0.1);
    for (DriveLine& line : std::span(oneScene.lines).subspan(5)) line.line.pitch += 0.2;
    EXPECT_FALSE(copies.isCopy(oneScene)) << "it shares one scene of three";
    DriveLines without = someDrive(0.3);
    for (DriveLine& line : without.lines) line.isScene = false;
    EXPECT_FALSE(copies.isCopy(without));
    EXPECT_FALSE(copies.isCopy(without));
}

TEST(DriveCopies, keepsADriveAfterAnExcerptOfIt)
{
    DriveCopies copies;
    DriveLines begin = someDrive(0.1);
    begin.lines.resize(4);
    EXPECT_FALSE(copies.isCopy(begin));
    EXPECT_TRUE(copies.contains(driveMarks(someDrive(0.1))));
    EXPECT_FALSE(copies.isCopy(someDrive(0.1))) << "two of its three scenes are new";
}

TEST(DriveCopies, knowsADriveWithOtherLines)
{
    DriveCopies copies;
    EXPECT_FALSE(copies.isCopy(someDrive(0.1)));
    DriveLines longer = someDrive(0.1);
    longer.lines.insert(longer.lines.begin(), DriveLine{});
    EXPECT_TRUE(copies.isCopy(longer)) << "one more line of the way";
    DriveLines shorter = someDrive(0.1);
    shorter.lines.erase(shorter.lines.begin() + 3);
    EXPECT_TRUE(copies.isCopy(shorter)) << "one scene less";
    DriveLines begin = someDrive(0.1);
    begin.lines.resize(4);
    EXPECT_TRUE(copies.isCopy(begin)) << "its first scene alone";
    ASSERT_EQ(copies.drives().size(), 1U);
    EXPECT_EQ(copies.drives().front(), driveMarks(someDrive(0.1)));
}

TEST(DriveCopies, marksAreOfScenesAlone)
{
    DriveLines drive = someDrive(0.1);
    const DriveMarks marks = driveMarks(drive);
    EXPECT_EQ(marks.size(), 3U);
    EXPECT_TRUE(std::ranges::is_sorted(marks));
    drive.run = "another";
    for (DriveLine& line : drive.lines) {
        line.line.time += 5.0;
        if (!line.isScene) line.line.pitch = 0.7;
    }
    EXPECT_EQ(driveMarks(drive), marks);
    DriveCopies copies;
    copies.add(marks);
    EXPECT_TRUE(copies.contains(marks));
    EXPECT_FALSE(copies.contains(driveMarks(someDrive(0.3))));
    EXPECT_FALSE(copies.contains({}));
}

}  // namespace
}  // namespace terratact
