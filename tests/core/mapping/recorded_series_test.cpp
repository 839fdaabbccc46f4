// Tests fields of recordings as series, and their lines of telemetry.
#include "core/mapping/recorded_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/mapping/telemetry_lines.h"
#include "tests/support/bytes/csv_mapping.h"
#include "tests/support/bytes/mcap_bytes.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/transform_text.h"

namespace terratact {
namespace {

constexpr std::uint64_t kSecond = 1'000'000'000;
const Eigen::Quaterniond kNoTurn = Eigen::Quaterniond::Identity();
const Eigen::Quaterniond kQuarterLeft(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));

struct SeriesFiles : testing::Test {
    Result<RecordedSeries> read(const std::string& content, const Mapping& mapping)
    {
        auto recording = openRecording(directory.write("a", content), mapping.csv);
        EXPECT_TRUE(recording) << recording.error().text;
        return readSeries(**recording, mapping, shippedRobot());
    }
    std::vector<TelemetryLine> lines(const std::string& content, const std::string& mapping)
    {
        const Mapping parsed = parsedMapping(mapping);
        const auto series = read(content, parsed);
        EXPECT_TRUE(series) << series.error().text;
        if (!series) return {};
        remarks = series->remarks;
        return telemetryLines(*series, parsed);
    }
    std::string whyNot(const std::string& content, const std::string& mapping)
    {
        const auto series = read(content, parsedMapping(mapping));
        return series ? "" : series.error().text.substr(directory.file("a").size());
    }

    /// Returns an MCAP file of JSON with the topics /imu and /joints; `shift` moves the latter.
    static McapBytes robotFile(std::string_view quaternion, std::uint64_t shift = 0)
    {
        McapBytes mcap;
        mcap.channel(1, 0, "/imu", "json")
            .channel(2, 0, "/joints", "json")
            .channel(3, 0, "/tf_static", "json");
        mcap.message(
            3, kSecond,
            R"({"transforms":[{"header":{"frame_id":"base"},"child_frame_id":"imu","transform":{"rotation":{"x":0,"y":0,"z":1,"w":0}}}]})");
        for (std::uint64_t i = 1; i <= 5; ++i) {
            mcap.message(1, i * kSecond / 10,
                         R"({"header":{"frame_id":"imu"},"orientation":)" + std::string(quaternion)
                             + "}");
            mcap.message(
                2, shift + i * kSecond / 10,
                R"({"name":["fl","fr","rl","rr"],"position":[0.1,0.2,0.3,0.4],"effort":[17,17,0,0]})");
        }
        return mcap;
    }
    static std::string robotMapping(const std::string& attitude, const std::string& more = {})
    {
        std::string text =
            "name = \"t\"\n[attitude]\ntopic = \"/imu\"\nquaternion = \"orientation\"\n" + attitude
            + more;
        for (const auto& [table, joint] : {std::pair{"front_left", "fl"},
                                           {"front_right", "fr"},
                                           {"rear_left", "rl"},
                                           {"rear_right", "rr"}})
            text +=
                fmt::format("[{}]\ntopic = \"/joints\"\nfield = \"position[{}]\"\n", table, joint);
        return text;
    }

    TemporaryDirectory directory;
    std::vector<std::string> remarks;
};

TEST_F(SeriesFiles, factorsOffsetsAndDelaysAreApplied)
{
    const auto found =
        lines("t,pitch,front_left,front_right,rear_left,rear_right\n0,10,1,1,1,1\n1,20,1,1,1,1\n",
              csvMapping("[time]\nmax_gap_s = 2.0\n[pitch]\nfield = \"pitch\"\nunit = "
                         "\"deg\"\nsign = -1\noffset = 0.5\ndelay_s = -0.5\n"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].time, 500'000'000) << "the message is sooner than its measurement";
    EXPECT_NEAR(found[0].measurement.pitch, 0.5 - 10.0 * M_PI / 180.0, 1e-12);
    EXPECT_TRUE(found[0].measurement.missing.all() == false);
    EXPECT_TRUE(found[0].measurement.missing[kFrontCurrentFeature]);
}

TEST_F(SeriesFiles, valuesAreInterpolatedWithinGaps)
{
    const auto found = lines("t,pitch,front_left,front_right,rear_left,rear_right,roll\n0,0,3,1,1,"
                             "1,\n0.1,0,,1,1,1,0.5\n0.2,0,-3.0831853,1,1,1,\n"
                             "2,0,1,1,1,1,\n",
                             csvMapping("[roll]\nfield = \"roll\"\n"));
    ASSERT_EQ(found.size(), 3U) << "an empty angle is not measured";
    EXPECT_EQ(found[1].measurement.frontLeft, -3.0831853);
    EXPECT_EQ(found[0].measurement.roll, 0.0);
}

TEST_F(SeriesFiles, anglesTurnTheShorterWay)
{
    McapBytes mcap;
    mcap.channel(1, 0, "/p", "json").channel(2, 0, "/f", "json");
    mcap.message(2, 0, R"({"a":3.1})").message(2, kSecond / 5, R"({"a":-3.1})");
    mcap.message(1, kSecond / 10, R"({"p":0.1})");
    std::string text = "name = \"t\"\n[pitch]\ntopic = \"/p\"\nfield = \"p\"\n";
    for (const char* const table : {"front_left", "front_right", "rear_left", "rear_right"})
        text += fmt::format("[{}]\ntopic = \"/f\"\nfield = \"a\"\n", table);
    const auto found = lines(mcap.file(), text);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(std::abs(turnBetween(found[0].measurement.frontLeft, M_PI)), 0.0, 1e-9);
}

TEST_F(SeriesFiles, quaternionsBecomeNoseAndLeftSideUp)
{
    const double half = 0.1;  // [rad]
    // ROS turns the nose down by a positive angle about y.
    const std::string nose =
        fmt::format(R"({{"x":0,"y":{},"z":0,"w":{}}})", -std::sin(half), std::cos(half));
    const auto pitched = lines(robotFile(nose).file(), robotMapping(""));
    ASSERT_EQ(pitched.size(), 5U);
    EXPECT_NEAR(pitched[0].measurement.pitch, 0.2, 1e-12);
    EXPECT_NEAR(pitched[0].measurement.roll, 0.0, 1e-12);
    EXPECT_EQ(pitched[0].measurement.rearLeft, 0.3);
    const std::string left =
        fmt::format(R"({{"x":{},"y":0,"z":0,"w":{}}})", std::sin(half), std::cos(half));
    EXPECT_NEAR(lines(robotFile(left).file(), robotMapping(""))[0].measurement.roll, 0.2, 1e-12);
    // An IMU that looks backwards, by numbers and through tf.
    for (const char* const mount : {"mount_rpy_deg = [0, 0, 180]\n", "base_frame = \"base\"\n"})
        EXPECT_NEAR(lines(robotFile(nose).file(), robotMapping(mount))[0].measurement.pitch, -0.2,
                    1e-12)
            << mount;
}

TEST_F(SeriesFiles, torquesBecomeCurrentsOfTheRobot)
{
    std::string currents;
    for (const auto& [table, joint] :
         {std::pair{"front_left_current", "fl"}, {"front_right_current", "fr"}})
        currents += fmt::format(
            "[{}]\ntopic = \"/joints\"\nfield = \"effort[{}]\"\nunit = \"N m\"\n", table, joint);
    const auto found =
        lines(robotFile(R"({"x":0,"y":0,"z":0,"w":1})").file(), robotMapping("", currents));
    EXPECT_NEAR(found.at(0).measurement.frontLeftCurrent, 3.0, 1e-12) << "17 N m";
    EXPECT_TRUE(found[0].measurement.missing[kRearCurrentFeature]);
}

TEST_F(SeriesFiles, speedAndPosesBecomeTheWay)
{
    const std::string rows = "t,pitch,front_left,front_right,rear_left,rear_right,v\n0,0,0,0,0,0,"
                             "1\n0.25,0,0,0,0,0,2\n5,0,0,0,0,0,2\n";
    const auto driven = lines(rows, csvMapping("[speed]\nfield = \"v\"\n"));
    ASSERT_EQ(driven.size(), 3U);
    EXPECT_NEAR(*driven[1].measurement.travelled, 0.375, 1e-12);
    EXPECT_NEAR(*driven[2].measurement.travelled, 0.375, 1e-12) << "nothing is known of the gap";
    const std::string poses = "t,pitch,front_left,front_right,rear_left,rear_right,p.x,p.y,p.z,q.x,"
                              "q.y,q.z,q.w\n0,0,0,0,0,0,1,1,0,0,0,1,1\n"
                              "0.1,0,0,0,0,0,1,0.5,0,0,0,1,1\n";
    const auto posed =
        lines(poses, csvMapping("[odometry]\nposition = \"p\"\norientation = \"q\"\n"));
    ASSERT_EQ(posed.size(), 2U);
    EXPECT_NEAR(*posed[1].measurement.travelled, -0.5, 1e-12) << "backwards, heading along y";
    EXPECT_NEAR(*posed[1].measurement.turned, M_PI / 2, 1e-12);
}

TEST_F(SeriesFiles, whatIsMissingIsNamed)
{
    const std::string rows = "t,pitch,front_left,front_right,rear_left\n0,0,0,0,0\n";
    EXPECT_EQ(whyNot(rows, csvMapping()), ": topic /csv: none of its 1 messages has the field "
                                          "'rear_right'; `terratact import --probe` lists "
                                          "the fields; correct [rear_right] of the mapping");
    const std::string none = R"({"x":0,"y":0,"z":0,"w":0})";
    EXPECT_NE(whyNot(robotFile(none).file(), robotMapping("")).find("all quaternions are 0"),
              std::string::npos);
    const std::string flat = R"({"x":0,"y":0,"z":0,"w":1})";
    EXPECT_NE(whyNot(robotFile(flat).file(), robotMapping("base_frame = \"world\"\n"))
                  .find("hold no transforms from 'world' to 'imu'; there are: base → imu; give "
                        "mount_rpy_deg"),
              std::string::npos);
    EXPECT_NE(whyNot(robotFile(flat, 7200 * kSecond).file(), robotMapping(""))
                  .find("topic /joints: its times begin after those of the pitch by 7199.6 s"),
              std::string::npos);
    std::string other = robotMapping("");
    other.replace(other.find("/joints"), 7, "/legs");
    EXPECT_NE(whyNot(robotFile(flat).file(), other)
                  .find("topic /legs: the file has no such topic; its topics are /imu, /joints, "
                        "/tf_static"),
              std::string::npos);
}

TEST_F(SeriesFiles, headerStampsAreUsedOnRequest)
{
    const std::string stamped =
        R"({"header":{"stamp":{"sec":9,"nanosec":5}},"pitch":0,"front_left":0,"front_right":0,"rear_left":0,"rear_right":0})";
    McapBytes mcap;
    mcap.channel(1, 0, "/csv", "json").message(1, 5, stamped);
    EXPECT_EQ(lines(mcap.file(), csvMapping("[time]\nsource = \"header\"\n")).at(0).time,
              9'000'000'005);
    EXPECT_EQ(lines(mcap.file(), csvMapping()).at(0).time, 5);
}

TEST_F(SeriesFiles, nanIsNotMeasured)
{
    const auto found = lines(
        "t,pitch,front_left,front_right,rear_left,rear_right,c\n0,0,0,0,0,0,NaN\n0.1,0,0,0,0,0,2\n",
        csvMapping("[front_left_current]\nfield = \"c\"\n[front_right_current]\nfield = \"c\"\n"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[0].measurement.missing[kFrontCurrentFeature]);
    EXPECT_EQ(found[1].measurement.frontLeftCurrent, 2.0);
    EXPECT_EQ(remarks.size(), 2U) << "both fields";
}

TEST_F(SeriesFiles, theCurrentOfOneMotorIsKept)
{
    const auto found = lines(
        "t,pitch,front_left,front_right,rear_left,rear_right,c\n0,0,0,0,0,0,2\n0.1,0,0,0,0,0,2\n",
        csvMapping("[front_left_current]\nfield = \"c\"\n"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(motorCurrents(found[0].measurement)[0], 2.0);
    EXPECT_FALSE(motorCurrents(found[0].measurement)[1]);
    EXPECT_EQ(proprioception(found[0].measurement).frontCurrent, 2.0);
}

TEST_F(SeriesFiles, damageIsTheCauseOfAMissingTopic)
{
    McapBytes mcap = robotFile(R"({"x":0,"y":0,"z":0,"w":1})");
    mcap.chunk("", 5);
    const std::string why = whyNot(mcap.file(), robotMapping(""));
    EXPECT_NE(why.find("has a wrong checksum; it is left out: no topic lies before that; "
                       "copy or record it again"),
              std::string::npos)
        << why;
    EXPECT_EQ(why.find("correct ["), std::string::npos) << "the mapping is not the cause";
}

TEST_F(SeriesFiles, theCauseInReadMessagesPrecedesDamage)
{
    const std::string file = robotFile(R"({"x":0,"y":0,"z":0,"w":1})").file();
    std::string mapping = robotMapping("");
    mapping.replace(mapping.find("position[fl]"), 12, "position[fx]");
    const std::string why = whyNot(file.substr(0, file.size() - 45), mapping);
    EXPECT_EQ(why.find(": topic /joints: none of its 5 messages has the field 'position[fx]'; "
                       "`terratact import --probe` lists the fields; correct [front_left] of the "
                       "mapping; the file is damaged, too: ends within the record at byte "),
              0U)
        << why;
}

TEST_F(SeriesFiles, aNoteIsNotTheCauseOfAMissingField)
{
    const std::string rows =
        "t,pitch,front_left,front_right,rear_left\ns,deg,deg,deg,deg\n0,0,0,0,0\n";
    EXPECT_EQ(whyNot(rows, csvMapping()).find(": topic /csv: none of its 1 messages"), 0U)
        << "the line of units is left out, which costs no field";
}

TEST_F(SeriesFiles, aTopicWithoutMessagesIsNamed)
{
    McapBytes mcap;
    mcap.channel(1, 0, "/imu", "json").channel(2, 0, "/joints", "json");
    mcap.message(2, kSecond, R"({"name":["fl","fr","rl","rr"],"position":[0,0,0,0]})");
    EXPECT_EQ(whyNot(mcap.file(), robotMapping("")),
              ": topic /imu: the topic has no message; correct [attitude] of the mapping");
}

TEST_F(SeriesFiles, brokenMessagesAreCountedAndLeftOut)
{
    McapBytes mcap = robotFile(R"({"x":0,"y":0,"z":0,"w":1})");
    mcap.message(2, kSecond / 10 + 1, R"({"name":[)");
    EXPECT_EQ(lines(mcap.file(), robotMapping("")).size(), 5U);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0].find("1 of 6 messages cannot be decoded and are left out; the first: "
                              "topic /joints: the message at byte "),
              0U)
        << remarks[0];
    for (int i = 0; i < 9; ++i) mcap.message(2, kSecond, "{");
    EXPECT_NE(whyNot(mcap.file(), robotMapping("")).find("topic /joints: the message at byte"),
              std::string::npos)
        << "most are broken";
}

TEST_F(SeriesFiles, textsInsteadOfNumbersAreCounted)
{
    const std::string head = fmt::format("t,{}\n", kPoseColumns);
    EXPECT_EQ(lines(head + "0,0,0,0,0,0\n0.1,inf,0,0,0,0\n0.2,abc,0,0,0,0\n", csvMapping()).size(),
              1U);
    EXPECT_EQ(remarks, (std::vector<std::string>{
                           "topic /csv, [pitch]: 1 values of 'pitch' are null or not finite; they "
                           "count as not measured",
                           "topic /csv, [pitch]: 1 values of 'pitch' are texts, expected numbers; "
                           "they are left out"}));
    EXPECT_NE(whyNot(head + "0,nan,0,0,0,0\n", csvMapping())
                  .find("all 1 values of 'pitch' are null or not finite; correct [pitch]"),
              std::string::npos);
}

TEST_F(SeriesFiles, timesContinueWhereTheClockWasSet)
{
    const std::string head = fmt::format("t,{}\n", kPoseColumns);
    const auto found =
        lines(head + "9000,0,0,0,0,0\n9000.1,0.1,0,0,0,0\n5400.2,0.2,0,0,0,0\n", csvMapping());
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[2].time, 9'000'200'000'000);
    EXPECT_EQ(found[2].measurement.pitch, 0.2) << "the order of the file is kept";
    EXPECT_EQ(remarks.size(), 1U);
}

TEST_F(SeriesFiles, rowsKeepTheirOrderWhereTheClockWasSet)
{
    std::string rows = fmt::format("t,{},v\n", kPoseColumns);
    // Times after the step repeat earlier ones. A column of texts lacks the rows around it.
    for (int i = 0; i < 40; ++i)
        rows += fmt::format("{:.3f},{},0,0,0,0,{}\n", 1000.0 + 0.05 * i - (i < 20 ? 0.0 : 0.5),
                            0.001 * i, i < 5 || i > 35 ? std::to_string(i) : "word");
    const auto found = lines(rows, csvMapping("[roll]\nfield = \"v\"\n"));
    ASSERT_EQ(found.size(), 40U) << "no time occurs twice";
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].measurement.pitch, 0.001 * static_cast<double>(i), 1e-12) << i;
        EXPECT_NEAR(static_cast<double>(found[i].time) * 1e-9,
                    1000.0 + 0.05 * static_cast<double>(i), 1e-6)
            << i;
    }
    EXPECT_EQ(found[39].measurement.roll, 39.0) << "a text hides the step from its column alone";
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_EQ(remarks[1], "the clock was set back by 0.450 s while this was recorded; times "
                          "continue evenly from there");
}

TEST_F(SeriesFiles, rowsOutOfOrderAreSorted)
{
    std::string rows = fmt::format("t,{}\n", kPoseColumns);
    for (int i = 40; i > 0; --i) rows += fmt::format("{},{},0,0,0,0\n", 0.05 * i, 0.001 * i);
    const auto found = lines(rows, csvMapping());
    ASSERT_EQ(found.size(), 40U);
    EXPECT_NEAR(found[0].measurement.pitch, 0.001, 1e-12);
    EXPECT_EQ(remarks, std::vector<std::string>{"the messages are not in the order of their times; "
                                                "they were sorted"});
}

/// Returns a recording with the transforms map → odom → base_link, the latter moving ahead and to the left.
McapBytes movingBase()
{
    McapBytes mcap = SeriesFiles::robotFile(R"({"x":0,"y":0,"z":0,"w":1})");
    mcap.channel(4, 0, "/tf", "json");
    mcap.message(3, kSecond, transformText("map", "odom", {{5, 0, 0}, kQuarterLeft}, 0));
    for (std::int64_t i = 0; i <= 5; ++i)
        mcap.message(4, static_cast<std::uint64_t>(i + 1) * kSecond / 10,
                     transformText("odom", "base_link",
                                   {{0.1 * static_cast<double>(i), 0, 0}, kNoTurn},
                                   9'000'000'000 + i * 100'000'000));
    return mcap;
}
constexpr const char* kTfOdometry = "[odometry]\nframe = \"map\"\nbase_frame = \"base_link\"\n";

TEST_F(SeriesFiles, transformsGiveWayAndHeading)
{
    const auto found = lines(movingBase().file(), robotMapping("", kTfOdometry));
    ASSERT_EQ(found.size(), 5U);
    EXPECT_NEAR(*found[0].measurement.travelled, 0.0, 1e-9) << "recorded at 0.1 s";
    EXPECT_NEAR(*found[4].measurement.travelled, 0.4, 1e-9);
    EXPECT_NEAR(*found[4].measurement.turned, std::numbers::pi / 2.0, 1e-9);
    EXPECT_TRUE(remarks.empty()) << remarks.front();
}

TEST_F(SeriesFiles, missingFramesAreReported)
{
    const auto found =
        lines(movingBase().file(),
              robotMapping("", "[odometry]\nframe = \"world\"\nbase_frame = \"base_link\"\n"));
    ASSERT_EQ(found.size(), 5U);
    EXPECT_FALSE(found[0].measurement.travelled);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0],
              "topic /tf, [odometry]: /tf_static and /tf hold no transforms from 'world' to "
              "'base_link'; there are: odom → base_link, base → imu, map → odom; correct frame and "
              "base_frame of [odometry]; the way counts as not measured");
}

TEST_F(SeriesFiles, anImuOnAMovingPartIsMountedAtEachTime)
{
    McapBytes mcap = robotFile(R"({"x":0,"y":0,"z":0,"w":1})");
    mcap.channel(4, 0, "/tf", "json");
    for (std::int64_t i = 1; i <= 3; ++i)
        mcap.message(4, 0,
                     transformText("part", "base",
                                   {{0, 0, 0},
                                    Eigen::Quaterniond(Eigen::AngleAxisd(
                                        0.1 * static_cast<double>(i), Eigen::Vector3d::UnitY()))},
                                   i * 100'000'000));
    const auto found = lines(mcap.file(), robotMapping("base_frame = \"part\"\n"));
    ASSERT_EQ(found.size(), 3U);
    EXPECT_NEAR(found[0].measurement.pitch, 0.1, 1e-9);
    EXPECT_NEAR(found[2].measurement.pitch, 0.3, 1e-9);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("2 messages have no transforms from 'part' to 'imu'"),
              std::string::npos)
        << remarks[0];
}

TEST(MostSamples, growsWithTheRecordingWithinLimits)
{
    EXPECT_EQ(mostSamples(0), 1'000'000U);
    EXPECT_EQ(mostSamples(3'000'000), 12'000'000U);
    EXPECT_EQ(mostSamples(1'000'000'000'000), kMaxSamples);
}

}  // namespace
}  // namespace terratact
