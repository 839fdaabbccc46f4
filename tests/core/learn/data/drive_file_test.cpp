#include "core/learn/data/drive_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/learn/data/two_track_scene.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/robot/two_tracks.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TwoTrackReadings someReadings()
{
    TwoTrackReadings s;
    s.pitch = 0.12345;
    s.roll = -0.2;
    s.flippers = {0.1, 0.2, 0.3, -0.4};
    s.currents = {1.0, 2.0, std::nullopt, std::nullopt};
    s.forces[0] = {1.0, 2.5, std::nullopt, 0.0, 0.01, 20.0};
    s.forces[1] = {2.0, std::nullopt, std::nullopt, 0.0, 0.03, 19.0};
    s.forces[3][2] = 3.5;
    s.differential = 0.05;
    return s;
}

DriveLine driveLine(const TwoTrackReadings& s, double time, double travelled, bool isScene)
{
    DriveLine line{.line = measurementOf(s), .isScene = isScene};
    line.line.time = time;
    line.line.travelled = travelled;
    line.line.turned = 0.0;
    line.line.activity = isScene ? RobotActivity::Pressed : RobotActivity::Driving;
    if (isScene) line.truth[0][0] = line.truth[1][0] = -0.3;
    return line;
}

DriveLines trackDrive(const std::string& run)
{
    DriveLines drive{.run = run, .onePlane = false, .lines = {}};
    drive.lines = {driveLine(someReadings(), 0.0, 0.0, false),
                   driveLine(someReadings(), 0.0, 0.00003, true),
                   driveLine(someReadings(), 1.7, -0.25, false)};
    drive.lines[1].truth[1] = {};
    drive.lines[1].truth[1][10] = 0.125;
    return drive;
}

DriveLines planeDrive(const std::string& run)
{
    Scene scene;
    scene.s.pitch = 0.1;
    scene.s.front = 0.7;
    scene.s.rear = -0.2;
    scene.s.frontCurrent = 0.5;
    scene.s.force = {0.0, 1.0, std::nullopt, 3.0, 4.0, 12.34567};
    const TwoTrackReadings s = onBothSides(scene).s;
    return {.run = run,
            .onePlane = true,
            .lines = {driveLine(s, 0.0, 0.0, false), driveLine(s, 0.8, 0.0, true)}};
}

struct DriveFileTest : testing::Test {
    Result<DriveFile> read(const std::string& content)
    {
        return readDrives(dir.write("drives.csv", content));
    }
    TemporaryDirectory dir;
};

TEST_F(DriveFileTest, readsWhatItWroteOnTwoTracks)
{
    const auto file =
        read(drivesHeader(false) + driveText(trackDrive("7")) + driveText(trackDrive("8")));
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->drives, (std::vector{trackDrive("7"), trackDrive("8")}));
    EXPECT_TRUE(file->notices.empty());
}

TEST_F(DriveFileTest, readsWhatItWroteOfOnePlane)
{
    const std::string text = drivesHeader(true) + driveText(planeDrive("a b"));
    const auto file = read(text);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(file->drives, std::vector{planeDrive("a b")});
    EXPECT_TRUE(text.starts_with("run,t_s,kind,travelled_m,pitch_rad,front_rad,"));
}

TEST_F(DriveFileTest, measuredDrivesKeepSdAndHeading)
{
    for (const bool onePlane : {false, true}) {
        DriveLines drive = onePlane ? planeDrive("1") : trackDrive("1");
        drive.lines[0].line.turned = 0.5;
        drive.lines[1].line.turned.reset();
        drive.lines[1].truthSd[0][0] = drive.lines[1].truthSd[onePlane ? 1 : 0][0] = 0.0125;
        const auto file = read(drivesHeader(onePlane, DriveColumns::Measured)
                               + driveText(drive, DriveColumns::Measured));
        ASSERT_TRUE(file) << file.error().text;
        EXPECT_EQ(file->drives, std::vector{drive});
        EXPECT_EQ(driveText(drive).find("0.0125"), std::string::npos) << "simulated ones are exact";
    }
}

TEST_F(DriveFileTest, roundsToTheResolution)
{
    DriveLines drive = planeDrive("1");
    for (DriveLine& line : drive.lines) {
        line.line.time += 1.0 / 3.0;
        line.line.travelled = 2.0 / 3.0;
        line.line.pitch = -1e-7;
    }
    const auto file = read(drivesHeader(true) + driveText(drive));
    ASSERT_TRUE(file) << file.error().text;
    const Measurement& line = file->drives[0].lines[0].line;
    EXPECT_EQ(line.time, 0.33333);
    EXPECT_EQ(line.travelled, 0.66667);
    EXPECT_EQ(driveText(file->drives[0]), driveText(drive));
    EXPECT_EQ(driveText(drive).find(",-0,"), std::string::npos);
}

TEST_F(DriveFileTest, passesOnOneDriveAtATime)
{
    std::vector<std::string> runs;
    const std::string path =
        dir.write("drives.csv", drivesHeader(true) + driveText(planeDrive("1"))
                                    + driveText(planeDrive("2")) + driveText(planeDrive("1")));
    const auto add = [&](DriveLines&& drive) { runs.push_back(drive.run); };
    EXPECT_TRUE(refused(readDrives(path, add), path,
                        {"line 6", "run '1', whose lines do not stand together"}));
    EXPECT_EQ(runs, (std::vector<std::string>{"1", "2"}));
}

TEST_F(DriveFileTest, refusesLinesThatCannotBe)
{
    const std::string text = drivesHeader(true) + driveText(planeDrive("1"));
    const std::string path = dir.file("drives.csv");
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string copy = text;
        const std::size_t at = copy.find(from);
        if (at == std::string::npos) throw std::invalid_argument("no " + from);
        return read(copy.replace(at, from.size(), to));
    };
    EXPECT_TRUE(
        refused(changed("scene", "stop"), path, {"line 3", "kind is 'stop'", "way or scene"}));
    EXPECT_TRUE(refused(changed("scene", "way"), path, {"line 3", "heights", "scene"}));
    EXPECT_TRUE(refused(changed("kind", "sort"), path, {"the column kind is missing"}));
    EXPECT_TRUE(refused(changed("travelled_m", "way_m"), path,
                        {"the column travelled_m is missing; not known: 'way_m'"}));
    EXPECT_TRUE(refused(changed("way,0,", "way,,"), path, {"line 2", "travelled_m"}));
    EXPECT_TRUE(refused(changed("1,0,way", "1,0.9,way"), path,
                        {"line 3", "t_s is 0.8 after 0.9", "in the order of time"}));
    EXPECT_TRUE(refused(changed("0.7,", "70,"), path, {"line 2", "front_rad is 70"}));
    EXPECT_TRUE(refused(read(drivesHeader(true)), path, {"line 1", "no line follows it"}));
    EXPECT_TRUE(refused(read(""), path, {"is empty"}));
}

TEST_F(DriveFileTest, scenesFileHasNoKind)
{
    const std::string scenes = twoTrackScenesText(
        {TwoTrackScene{.run = "1", .time = 0.0, .s = someReadings(), .truth = {}}});
    EXPECT_EQ(scenes.find("kind"), std::string::npos);
    EXPECT_TRUE(refused(read(scenes), dir.file("drives.csv"), {"the column kind is missing"}));
}

TEST(DriveFile, plausibleLinesAreWithinTheirColumns)
{
    const DriveLines tracks = trackDrive("1"), plane = planeDrive("1");
    for (const DriveLine& line : tracks.lines) EXPECT_TRUE(isPlausible(tracks, line));
    for (const DriveLine& line : plane.lines) EXPECT_TRUE(isPlausible(plane, line));
    const auto isRefused = [](const DriveLines& drive, const auto& change) {
        DriveLine line = drive.lines[1];
        change(line);
        return !isPlausible(drive, line);
    };
    EXPECT_TRUE(isRefused(tracks, [](DriveLine& l) { l.line.pitch = 4.0; }));
    EXPECT_TRUE(isRefused(tracks, [](DriveLine& l) { l.line.roll = -4.0; }));
    EXPECT_TRUE(isRefused(tracks, [](DriveLine& l) { l.line.sides.left[0] = -1000.0; }));
    EXPECT_TRUE(isRefused(tracks, [](DriveLine& l) { l.line.travelled = std::nan(""); }));
    EXPECT_TRUE(isRefused(tracks, [](DriveLine& l) { l.truth[1][10] = 100.0; }));
    EXPECT_TRUE(isRefused(plane, [](DriveLine& l) { l.truth[0][0] = l.truth[1][0] = 100.0; }));
    EXPECT_FALSE(isRefused(plane, [](DriveLine& l) {
        l.truth[0][0] = l.truth[1][0] = std::nullopt;
    })) << "not known";
}

TEST_F(DriveFileTest, refusesToWriteWhatItWouldNotRead)
{
    const auto throwsFor = [](DriveLines drive, const auto& change) {
        change(drive);
        EXPECT_THROW((void)driveText(drive), std::invalid_argument);
    };
    throwsFor(planeDrive("1"), [](DriveLines& d) { d.lines[0].line.roll = 0.1; });
    throwsFor(planeDrive("1"), [](DriveLines& d) { d.lines[1].truth[1][3] = 0.1; });
    throwsFor(planeDrive("1"), [](DriveLines& d) { d.lines[0].line.travelled.reset(); });
    throwsFor(trackDrive("1"), [](DriveLines& d) { d.lines[0].truth[1][3] = 0.1; });
    throwsFor(trackDrive("1"), [](DriveLines& d) { d.lines[0].line.pitch = 4.0; });
    throwsFor(trackDrive(""), [](DriveLines&) {});
}

}  // namespace
}  // namespace terratact
