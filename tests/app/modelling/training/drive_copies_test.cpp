// Tests that a drive is recognised whatever its name.
#include "app/modelling/training/drive_copies.h"

#include <gtest/gtest.h>

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
    DriveLines longer = someDrive(0.1);
    longer.lines.insert(longer.lines.begin(), DriveLine{});
    EXPECT_FALSE(copies.isCopy(longer));
    DriveLines without = someDrive(0.3);
    for (DriveLine& line : without.lines) line.isScene = false;
    EXPECT_FALSE(copies.isCopy(without));
    EXPECT_FALSE(copies.isCopy(without));
}

}  // namespace
}  // namespace terratact
