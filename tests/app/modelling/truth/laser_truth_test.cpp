// Tests heights of scenes from files: runs, clocks, scans, recordings, reports.
#include "app/modelling/truth/laser_truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/figures/truth_figure.h"
#include "app/modelling/truth/laser_truth_report.h"
#include "core/clouds/cloud_messages.h"
#include "core/clouds/made_cloud.h"
#include "core/learn/data/drive_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/data/two_track_scene_file.h"
#include "core/store/csv_text.h"
#include "tests/support/absolem.h"
#include "tests/support/bytes/mcap_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/transform_text.h"

namespace terratact {
namespace {

/// A robot stands level on a floor at times 0, 1, 2 s, 0.1 m apart. A step lies ahead, beyond its flippers.
struct LaserFiles : testing::Test {
    void SetUp() override
    {
        std::string poses;
        for (int i = 0; i < 3; ++i) {
            TwoTrackScene scene{.run = "a", .time = static_cast<double>(i), .s = {}, .truth = {}};
            scenes.push_back(scene);
            const CloudPose base = baseAt(i);
            poses += fmt::format("{} {} {} {} 0 0 0 1\n", kClock + i, base.place.x(),
                                 base.place.y(), base.place.z());
        }
        options.robot = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
        options.scenes = directory.write("scenes.csv", twoTrackScenesText(scenes));
        options.poses = directory.write("poses.tum", poses);
        options.start = kClock;
        points = groundCloud(robot, GroundLines(ground), {}, -1.0, 2.0,
                             {.density = 20'000, .noise = 0.002}, rng);
        options.clouds = {directory.write("map.pcd", pcdText(points))};
    }

    CloudPose baseAt(int i) const
    {
        return {{0.1 * i, 0.0, robot.baseHeight}, Eigen::Quaterniond::Identity()};
    }

    /// Returns the largest error against the floor and the step [m].
    double worst(const LaserTruth& truth) const
    {
        double worst = 0.0;
        for (std::size_t row = 0; row < truth.scenes(); ++row) {
            const Vec2 imu{baseAt(static_cast<int>(row)).place.x() + robot.imu.x,
                           robot.baseHeight + robot.imu.z};
            const Heights wanted = binHeights(ground, imu);
            for (const auto& side : truth.tracks[row].truth)
                for (std::size_t i = 0; i < kBins; ++i)
                    if (side.at(i)) worst = std::max(worst, std::abs(*side.at(i) - wanted.at(i)));
        }
        return worst;
    }

    static constexpr double kClock = 1.7e9;
    RobotModel robot = absolem();
    TerrainProfile ground{{{-2, 0}, {0.9, 0}, {0.9, 0.2}, {3, 0.2}}};
    std::mt19937_64 rng{5};
    std::vector<TwoTrackScene> scenes;
    std::vector<CloudPoint> points;
    LaserTruthOptions options;
    TemporaryDirectory directory;
};

TEST_F(LaserFiles, heightsComeIntoTheSceneFile)
{
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_FALSE(truth->isPlane);
    EXPECT_EQ(truth->count(TruthGap::None), 3U);
    EXPECT_EQ(truth->knownHeights(), 66U);
    EXPECT_LT(worst(*truth), 0.022) << "half a cell of the step";
    const auto again = readTwoTrackScenes(directory.write("out.csv", truthScenesCsv(*truth)));
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(again->scenes, truth->tracks);
    const std::string support = truthSupportCsv(*truth);
    EXPECT_EQ(std::ranges::count(support, '\n'), 1 + 66);
    EXPECT_NE(support.find("a,0,left,-0.3,-0.2"), std::string::npos) << support.substr(0, 200);
}

TEST_F(LaserFiles, aFileOfOnePlaneGetsTheMeanOfBothSides)
{
    std::vector<Scene> plane(1);
    plane[0].run = "a";
    options.scenes = directory.write("plane.csv", scenesText(plane));
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_TRUE(truth->isPlane);
    ASSERT_TRUE(truth->plane[0].truth[0]);
    EXPECT_NEAR(*truth->plane[0].truth[0], -robot.baseHeight - robot.imu.z, 0.002);
    EXPECT_TRUE(readScenesWithTruth(directory.write("out.csv", truthScenesCsv(*truth))));
}

TEST_F(LaserFiles, drivesKeepTheirWay)
{
    for (const bool onePlane : {false, true}) {
        DriveLines drive{.run = "a", .onePlane = onePlane, .lines = {}};
        for (int i = 0; i < 3; ++i)
            for (const bool isScene : {false, true}) {
                DriveLine line{.line = measurementOf(TwoTrackReadings{}), .isScene = isScene};
                line.line.time = static_cast<double>(i);
                line.line.activity = isScene ? RobotActivity::Pressed : RobotActivity::Driving;
                line.line.travelled = 0.1 * i;
                line.line.turned = 0.0;
                drive.lines.push_back(line);
            }
        options.scenes = directory.write("drives.csv", drivesHeader(onePlane) + driveText(drive));
        const auto truth = laserTruth(options);
        ASSERT_TRUE(truth) << truth.error().text;
        EXPECT_EQ(truth->scenes(), 3U);
        EXPECT_LT(worst(*truth), 0.02);
        const auto again = readDrives(directory.write("out.csv", truthScenesCsv(*truth)));
        ASSERT_TRUE(again) << again.error().text;
        ASSERT_EQ(again->drives.size(), 1U);
        const std::vector<DriveLine>& lines = again->drives[0].lines;
        ASSERT_EQ(lines.size(), 6U);
        EXPECT_EQ(lines[0], drive.lines[0]);
        ASSERT_TRUE(lines[1].truth[0][2]);
        ASSERT_TRUE(lines[1].truthSd[0][2]);
        const auto& wanted = onePlane ? truth->plane[0].truth : truth->tracks[0].truth[0];
        EXPECT_NEAR(*lines[1].truth[0][2], *wanted[2], 1e-5);
    }
}

TEST_F(LaserFiles, cloudsThatTellNothingAreNamed)
{
    options.clouds = {directory.write("nan.xyz", "nan nan nan\ninf 1 2\n")};
    EXPECT_TRUE(refused(laserTruth(options), options.clouds[0], {"all of its 2 points", "in m"}));
    std::vector<CloudPoint> larger = points;
    for (CloudPoint& p : larger) p = {1e3 * p.x + 5e3, 1e3 * p.y, 1e3 * p.z};
    options.clouds = {directory.write("mm.pcd", pcdText(larger))};
    EXPECT_TRUE(refused(laserTruth(options), options.clouds[0],
                        {"no point lies under a scene", "the robot within x", "in mm?"}));
}

TEST_F(LaserFiles, clocksThatDifferAreReportedWithBothSpans)
{
    options.start.reset();
    EXPECT_TRUE(refused(laserTruth(options), options.poses,
                        {"poses from 1700000000.000 to 1700000002.000 s",
                         "scenes are from 0.000 to 2.000 s", "--start"}));
}

TEST_F(LaserFiles, runsMustMatch)
{
    options.run = "b";
    EXPECT_TRUE(refused(laserTruth(options), options.scenes, {"has no run 'b'"}));
    options.run.clear();
    scenes[1].run = "b";
    options.scenes = directory.write("scenes.csv", twoTrackScenesText(scenes));
    EXPECT_TRUE(refused(laserTruth(options), options.poses, {"names no runs", "--run"}));
    options.run = "a";
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->count(TruthGap::OtherRun), 1U);
    EXPECT_EQ(truth->count(TruthGap::None), 2U);
}

TEST_F(LaserFiles, aPoseThatJumpsLeavesItsSceneEmpty)
{
    const std::string poses =
        "1700000000 0 0 P 0 0 0 1\n1700000001 0.1 0 P 0 0 0 1\n1700000002 0.2 0 Q 0 0 0 1\n";
    std::string text;
    for (const char c : poses)
        text += c == 'P' ? fmt::format("{}", robot.baseHeight)
              : c == 'Q' ? fmt::format("{}", robot.baseHeight + 0.09)
                         : std::string(1, c);
    options.poses = directory.write("poses.tum", text);
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->truths[2].gap, TruthGap::OffCloud);
    EXPECT_FALSE(truth->tracks[2].truth[0][0]);
    EXPECT_EQ(truth->count(TruthGap::None), 2U);
    EXPECT_NE(truthReport(*truth, options).find("1 lie off the cloud"), std::string::npos);
}

TEST_F(LaserFiles, posesOfAnotherFrameAreMounted)
{
    std::string poses;
    for (int i = 0; i < 3; ++i)
        poses += fmt::format("{} {} 0.2 {} 0 0 1 0\n", kClock + i, 0.1 * i + 0.3,
                             robot.baseHeight + 0.4);
    options.poses = directory.write("poses.tum", poses);
    options.poseMount = *mountFrom("0.3 0.2 0.4 0 0 180");
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->knownHeights(), 66U);
    EXPECT_LT(worst(*truth), 0.022);
}

/// Returns the points in the frame of a sensor at the pose.
std::vector<CloudPoint> seenFrom(const std::vector<CloudPoint>& points, const CloudPose& sensor)
{
    const CloudPose back = sensor.inverse();
    std::vector<CloudPoint> seen;
    seen.reserve(points.size());
    for (const CloudPoint& p : points) {
        const Eigen::Vector3d s = back.toOther({p.x, p.y, p.z});
        seen.push_back({s.x(), s.y(), s.z()});
    }
    return seen;
}

TEST_F(LaserFiles, scansAreNamedByTheirTimes)
{
    options.scans = true;
    options.sensorMount = *mountFrom("0.2 0 0.4 0 30 0");
    options.clouds.clear();
    for (int i = 0; i < 3; ++i)
        options.clouds.push_back(
            directory.write(fmt::format("scan_{:.2f}.pcd", kClock + i),
                            pcdText(seenFrom(points, baseAt(i).with(*options.sensorMount)))));
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_GT(truth->grid->ownPoints(), 0U) << "the floor below the robot is in its box";
    EXPECT_LT(worst(*truth), 0.022);
    EXPECT_GT(truth->knownHeights(), 5U) << "earlier scans see below the robot";
    options.clouds = {directory.write("scan.pcd", pcdText(points))};
    EXPECT_TRUE(refused(laserTruth(options), options.clouds[0], {"its name holds no time"}));
}

/// Returns a message of PointCloud2 in ROS 1 with x, y, z as floats behind four other bytes.
std::string cloudMessageBytes(const std::vector<CloudPoint>& points, double stamp, bool cdr,
                              std::string_view frame = "laser")
{
    auto b = cdr ? MessageBytes::cdr() : MessageBytes::ros1();
    if (!cdr) b.add(std::uint32_t{7});
    b.add(static_cast<std::uint32_t>(stamp)).add(std::uint32_t{0}).text(frame);
    b.add(std::uint32_t{1}).add(static_cast<std::uint32_t>(points.size())).add(std::uint32_t{3});
    for (const std::uint32_t k : {0U, 1U, 2U})
        b.text(std::string(1, "xyz"[k]))
            .add(4U + 4U * k)
            .add(std::uint8_t{7})
            .add(std::uint32_t{1});
    b.add(std::uint8_t{0})
        .add(std::uint32_t{16})
        .add(static_cast<std::uint32_t>(16 * points.size()));
    b.add(static_cast<std::uint32_t>(16 * points.size()));
    for (const CloudPoint& p : points)
        b.add(std::uint32_t{0})
            .add(static_cast<float>(p.x))
            .add(static_cast<float>(p.y))
            .add(static_cast<float>(p.z));
    b.add(std::uint8_t{1});
    return b.bytes();
}

TEST_F(LaserFiles, cloudsOfARecordingAreScans)
{
    McapBytes mcap;
    mcap.schema(1, "sensor_msgs/msg/PointCloud2", "ros2msg", "uint8 unused")
        .channel(1, 1, "/points", "cdr");
    for (int i = 0; i < 3; ++i)
        mcap.message(1, static_cast<std::uint64_t>(i),
                     cloudMessageBytes(seenFrom(points, baseAt(i)), kClock + i, true));
    options.clouds = {directory.write("drive.mcap", mcap.file())};
    options.topic = "/points";
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->points, 3 * points.size());
    EXPECT_GT(truth->knownHeights(), 5U) << "earlier scans see below the robot";
    EXPECT_LT(worst(*truth), 0.022);
    options.topic = "/other";
    EXPECT_TRUE(
        refused(laserTruth(options), options.clouds[0], {"no message of topic /other", "/points"}));
}

/// A drive whose poses and scans come from transforms: map → base_link → mast → laser; the mast nods.
struct TransformFiles : LaserFiles {
    void SetUp() override
    {
        LaserFiles::SetUp();
        mcap.schema(1, "sensor_msgs/msg/PointCloud2", "ros2msg", "uint8 unused")
            .channel(1, 1, "/points", "cdr")
            .channel(2, 0, "/tf", "json")
            .channel(3, 0, "/tf_static", "json");
        const CloudPose laser = *mountFrom("0.1 0 0.2 0 20 0");
        mcap.message(3, 0, transformText("mast", "laser", laser, 0));
        for (int i = 0; i < 3; ++i) {
            const CloudPose mast = *mountFrom(fmt::format("0.1 0 0.2 0 {} 0", 5 * i));
            const auto stamp = static_cast<std::int64_t>(kClock + i) * 1'000'000'000;
            const auto time = static_cast<std::uint64_t>(stamp);
            mcap.message(2, time, transformText("map", "base_link", baseAt(i), stamp));
            mcap.message(2, time, transformText("base_link", "mast", mast, stamp));
            mcap.message(1, time,
                         cloudMessageBytes(seenFrom(points, baseAt(i).with(mast).with(laser)),
                                           kClock + i, true));
        }
        options.topic = "/points";
        options.limits.maxGap = 2.0;
    }
    void write()
    {
        options.clouds = {directory.write("drive.mcap", mcap.file())};
        options.poses = options.clouds[0];
        options.mapping =
            directory.write("m.toml", "name = \"t\"\n[odometry]\nframe = \"" + map
                                          + "\"\nbase_frame = \"base_link\"\n" + kPoseTables);
    }

    /// What every mapping needs; truth does not read it.
    static constexpr const char* kPoseTables =
        "[pitch]\ntopic = \"/a\"\nfield = \"p\"\n[front_left]\ntopic = \"/a\"\nfield = \"p\"\n"
        "[front_right]\ntopic = \"/a\"\nfield = \"p\"\n[rear_left]\ntopic = \"/a\"\n"
        "field = \"p\"\n[rear_right]\ntopic = \"/a\"\nfield = \"p\"\n";
    McapBytes mcap;
    std::string map = "map";
};

TEST_F(TransformFiles, transformsPlaceBaseAndSensor)
{
    write();
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->points, 3 * points.size());
    EXPECT_GT(truth->knownHeights(), 5U);
    EXPECT_LT(worst(*truth), 0.022);
}

TEST_F(TransformFiles, posesOfAFileTakeOnlyTheSensorFromTransforms)
{
    const std::string poses = options.poses;
    write();
    options.poses = poses;
    options.mapping.clear();
    options.tfBase = "base_link";
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_GT(truth->knownHeights(), 5U);
    EXPECT_LT(worst(*truth), 0.022);
}

TEST_F(TransformFiles, cloudsInTheFrameOfThePosesAreMaps)
{
    mcap.channel(4, 1, "/map_points", "cdr");
    mcap.message(4, 9, cloudMessageBytes(points, 5.0, true, "map"));
    write();
    options.topic = "/map_points";
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth) << truth.error().text;
    EXPECT_EQ(truth->knownHeights(), 66U);
    EXPECT_LT(worst(*truth), 0.022);
}

TEST_F(TransformFiles, missingFramesAreReported)
{
    options.tfBase = "robot";
    write();
    EXPECT_TRUE(refused(laserTruth(options), options.clouds[0],
                        {"topic /points", "no transforms from 'robot' to 'laser'", "mast → laser",
                         "--sensor-mount"}));
    map = "world";
    write();
    EXPECT_TRUE(refused(laserTruth(options), options.poses,
                        {"no transforms from 'world' to 'base_link'", "[odometry]"}));
}

TEST_F(TransformFiles, cloudsOfAnotherClockAreReported)
{
    mcap.channel(4, 1, "/late", "cdr");
    mcap.message(4, 9, cloudMessageBytes(points, kClock + 7200.0, true));
    write();
    options.topic = "/late";
    EXPECT_TRUE(refused(laserTruth(options), options.clouds[0],
                        {"topic /late", "1700007200.000", "no poses are known"}));
}

TEST(CloudMessages, sizesThatDisagreeAreRefused)
{
    const RecordedTopic topic{.name = "/p", .type = "sensor_msgs/PointCloud2", .encoding = "ros1"};
    const std::string whole = cloudMessageBytes({{1, 2, 3}, {4, 5, NAN}}, 12.0, false);
    const auto cloud = cloudMessage(topic, whole);
    ASSERT_TRUE(cloud) << cloud.error().text;
    EXPECT_EQ(cloud->points, (std::vector<CloudPoint>{{1, 2, 3}}));
    EXPECT_EQ(cloud->leftOut, 1U);
    EXPECT_EQ(cloud->stamp, 12.0);
    for (std::size_t n = 0; n + 1 < whole.size(); ++n)
        EXPECT_FALSE(cloudMessage(topic, whole.substr(0, n))) << n << " bytes";
    std::string wide = whole;
    wide[4 + 8 + 4 + 5 + 4] = '\x09';
    EXPECT_NE(cloudMessage(topic, wide).error().text.find("declares 9 x 1 points"),
              std::string::npos);
}

TEST_F(LaserFiles, theSheetIsDrawn)
{
    const auto truth = laserTruth(options);
    ASSERT_TRUE(truth);
    ASSERT_TRUE(writeTruthSheet(directory.file("sheet.svg"), *truth));
    EXPECT_GT(contentOf(directory.file("sheet.svg")).size(), 20'000U);
    EXPECT_TRUE(refused(writeTruthSheet(directory.file("sheet.txt"), *truth),
                        directory.file("sheet.txt"), {}));
}

}  // namespace
}  // namespace terratact
