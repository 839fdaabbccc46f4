#include "app/modelling/simulation/simulated_drives.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/learn/data/drive_file.h"
#include "tests/support/absolem.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

SimulatedDrives fewDrives(bool tracks)
{
    return {.grounds = {.seed = 5},
            .drives = 3,
            .tracks = tracks,
            .way = {.spacing = 0.6, .step = 0.2},
            .softDrives = 0.5};
}

std::string contentOf(const DriveRecording& recording)
{
    std::string content;
    for (const std::string& part : recording.parts) content += part;
    return content;
}

TEST(SimulatedDrives, tooManyForAFileSayHowManyFit)
{
    SimulatedDrives options = fewDrives(false);
    const auto three = simulateDrives(absolem(), options);
    ASSERT_TRUE(three);
    options.maxLines = three->lines;
    EXPECT_TRUE(simulateDrives(absolem(), options));
    options.maxLines = three->lines - 1;
    for (const int drives : {3, 100'000}) {  // so many take hours, unless it ends early
        options.drives = drives;
        const auto refused = simulateDrives(absolem(), options);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().text.find("ask for 2 drives"), std::string::npos)
            << refused.error().text;
    }
}

TEST(SimulatedDrives, threadsDoNotChangeTheFile)
{
    const TemporaryDirectory dir;
    for (const bool tracks : {false, true}) {
        SimulatedDrives options = fewDrives(tracks);
        options.threads = 1;
        const auto one = simulateDrives(absolem(), options);
        options.threads = 2;
        const auto two = simulateDrives(absolem(), options);
        ASSERT_TRUE(one && two);
        EXPECT_EQ(one->parts, two->parts);
        options.grounds.seed = 6;
        EXPECT_NE(one->parts, simulateDrives(absolem(), options)->parts);

        const auto file = readDrives(dir.write("drives.csv", contentOf(*one)));
        ASSERT_TRUE(file) << file.error().text;
        ASSERT_EQ(file->drives.size(), one->drives);
        EXPECT_EQ(file->drives[2].run, "3");
        std::size_t lines = 0, scenes = 0;
        for (const DriveLines& drive : file->drives) {
            EXPECT_EQ(drive.onePlane, !tracks);
            lines += drive.lines.size();
            scenes += static_cast<std::size_t>(
                std::ranges::count(drive.lines, true, &DriveLine::isScene));
        }
        EXPECT_EQ(lines, one->lines);
        EXPECT_EQ(scenes, one->scenes);
    }
}

TEST(SimulatedDrives, drivesOverTheGroundsOfAFile)
{
    const TemporaryDirectory dir;
    SimulatedDrives options = fewDrives(false);
    options.grounds.step = 1.0;
    options.grounds.terrain =
        dir.write("profiles.csv", "0,0,0,0,0\n1,1,1,1,1\n2,2,2,2,2\n3,3,3,3,3\n");
    options.drives = 2;
    const auto some = simulateDrives(absolem(), options);
    ASSERT_TRUE(some) << some.error().text;
    EXPECT_EQ(some->drives, 2U);
    EXPECT_TRUE(some->parts[2].starts_with("3,0,way,0,"));  // profiles 1 and 3 of 4
    options.drives = 100;
    EXPECT_EQ(simulateDrives(absolem(), options)->drives, 4U);
    options.grounds.terrain =
        dir.write("pairs.csv", "pair,y_m,heights_m\na,0.2,0,0,0,0,0\na,-0.2,0,0,0,0,0\n");
    options.tracks = true;
    EXPECT_EQ(simulateDrives(absolem(), options)->drives, 1U);
    options.grounds.terrain = dir.file("absent.csv");
    EXPECT_TRUE(refused(simulateDrives(absolem(), options), options.grounds.terrain, {}));
}

}  // namespace
}  // namespace terratact
