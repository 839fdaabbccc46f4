// Tests the survey of a recording, the proposed mapping and the warnings.
#include "core/mapping/recording_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mapping/mapping_proposal.h"
#include "core/mapping/recording_survey.h"
#include "tests/support/bytes/csv_mapping.h"
#include "tests/support/bytes/mcap_bytes.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct Checks : testing::Test {
    /// Returns the warnings about 100 rows whose values `row` makes.
    template <class Row>
    std::vector<std::string> doubts(Row row, const std::string& mapping = csvMapping())
    {
        std::string text = fmt::format("t,{},c\n", kPoseColumns);
        for (int i = 0; i < 100; ++i) text += fmt::format("{},{}\n", 0.1 * i, row(i));
        const auto found =
            checkRecording(directory.write("a.csv", text), parsedMapping(mapping), shippedRobot());
        EXPECT_TRUE(found) << found.error().text;
        return found ? *found : std::vector<std::string>{};
    }
    static std::string pose(double pitch, double current = 0.0)
    {
        return fmt::format("{0},{0},{0},{0},{0},{1}", pitch, current);
    }
    static const std::string& current()
    {
        static const std::string mapping = csvMapping(
            "[front_left_current]\nfield = \"c\"\n[front_right_current]\nfield = \"c\"\n");
        return mapping;
    }

    TemporaryDirectory directory;
};

TEST_F(Checks, aGoodRecordingHasNone)
{
    EXPECT_TRUE(doubts([](int i) { return pose(0.001 * i, 0.01 * i); }, current()).empty());
}

TEST_F(Checks, aClockThatWasSetIsFound)
{
    std::string text = fmt::format("t,{}\n", kPoseColumns);
    for (int i = 0; i < 40; ++i)
        text += fmt::format("{},{}\n", 0.05 * i - (i < 20 ? 0.0 : 0.48),
                            fmt::format("{0},{0},{0},{0},{0}", 0.001 * i));
    const auto found =
        checkRecording(directory.write("a.csv", text), parsedMapping(csvMapping()), shippedRobot());
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_EQ(*found, std::vector<std::string>{"the clock was set back by 0.430 s while this was "
                                               "recorded; times continue evenly from there"});
}

TEST_F(Checks, degreesTakenForRadiansAreFound)
{
    const auto found = doubts([](int i) { return pose(0.1 * i); });
    ASSERT_EQ(found.size(), 5U);
    EXPECT_EQ(found[0],
              "[pitch]: reaches 9.900 rad, more than 1.571: degrees may be taken for radians; add "
              "unit = \"deg\", or correct the field");
    const auto other = doubts([](int i) { return pose(0.001 * i); },
                              csvMapping("[pitch]\nfield = \"pitch\"\nunit = \"deg\"\n"));
    ASSERT_EQ(other.size(), 1U);
    EXPECT_NE(other[0].find("stays within 0.10 degrees"), std::string::npos) << other[0];
}

TEST_F(Checks, aSpikeIsNoOtherUnit)
{
    const auto found = doubts([](int i) {
        return fmt::format("{},0.{:02},0.1,0.{:02},0.{:02},0", i == 50 ? 40.0 : 0.001 * i, i, i, i);
    });
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0], "[pitch]: 1 of 100 values lie beyond 1.571 rad, up to 40: the sensor or "
                        "its line has spikes; leave these messages out");
}

TEST_F(Checks, aWayThatJumpsIsFound)
{
    const std::string mapping = csvMapping("[travelled]\nfield = \"c\"\n");
    EXPECT_TRUE(doubts([](int i) { return pose(0.001 * i, 0.02 * i); }, mapping).empty());
    const auto jump =
        doubts([](int i) { return pose(0.001 * i, 0.02 * i + (i > 50 ? 40.0 : 0.0)); }, mapping);
    ASSERT_EQ(jump.size(), 1U);
    EXPECT_NE(jump[0].find("jumps 40.02 m in 0.100 s"), std::string::npos) << jump[0];
    const auto mm = doubts([](int i) { return pose(0.001 * i, 20.0 * i); }, mapping);
    ASSERT_EQ(mm.size(), 1U);
    EXPECT_NE(mm[0].find("millimetres"), std::string::npos) << mm[0];
}

TEST_F(Checks, stuckAndSaturatedSensorsAreFound)
{
    const auto stuck =
        doubts([](int i) { return fmt::format("{0},{0},{0},{0},0.5,0", 0.001 * i); });
    ASSERT_EQ(stuck.size(), 1U);
    EXPECT_EQ(stuck[0].find("[rear_right]: is 0.5 in all 100 values of 9.9 s"), 0U) << stuck[0];
    EXPECT_TRUE(doubts([](int) { return pose(0.1); }).empty()) << "nothing moved";
    const auto saturated =
        doubts([](int i) { return pose(0.001 * i, std::min(i, 50)); }, current());
    ASSERT_EQ(saturated.size(), 2U);
    EXPECT_NE(saturated[0].find("50 of 100 values equal the largest, 50: the sensor saturates"),
              std::string::npos);
}

TEST_F(Checks, gapsAndClocksAreFound)
{
    McapBytes mcap;
    mcap.channel(1, 0, "/a", "json").channel(2, 0, "/b", "json");
    for (std::uint64_t i = 0; i < 10; ++i) {
        const std::uint64_t time = 20'000'000'000 + i * 100'000'000 + (i > 5 ? 900'000'000 : 0);
        mcap.message(1, time,
                     fmt::format(R"({{"header":{{"stamp":{{"sec":15,"nanosec":{}}}}},"pitch":{}}})",
                                 i, 0.01 * static_cast<double>(i)));
        mcap.message(2, time,
                     fmt::format(R"({{"header":{{"stamp":{{"sec":{},"nanosec":1}}}},"a":{}}})",
                                 time / 1'000'000'000, 0.01 * static_cast<double>(i)));
    }
    std::string text = "name = \"t\"\n[pitch]\ntopic = \"/a\"\nfield = \"pitch\"\n";
    for (const char* const table : {"front_left", "front_right", "rear_left", "rear_right"})
        text += fmt::format("[{}]\ntopic = \"/b\"\nfield = \"a\"\n", table);
    const auto found =
        checkRecording(directory.write("a.mcap", mcap.file()), parsedMapping(text), shippedRobot());
    ASSERT_TRUE(found);
    const auto has = [&](std::string_view part) {
        return std::ranges::any_of(
            *found, [part](const std::string& s) { return s.find(part) != std::string::npos; });
    };
    EXPECT_TRUE(has("topic /a: a gap of 1.000 s at 0.500 s is longer than max_gap_s, 0.5 s"));
    EXPECT_TRUE(has("topic /a: header.stamp lies"));
    EXPECT_TRUE(has("topics /a and /b: their clocks"));
    EXPECT_FALSE(has("topic /b: header.stamp"));
}

TEST_F(Checks, aProposalIsAMapping)
{
    McapBytes mcap;
    mcap.schema(1, "sensor_msgs/msg/Imu", "", "")
        .schema(2, "sensor_msgs/msg/JointState", "", "")
        .schema(3, "nav_msgs/msg/Odometry", "", "");
    mcap.channel(1, 1, "/imu \"1\"", "json")
        .channel(2, 2, "/joints", "json")
        .channel(3, 3, "/odom", "json");
    mcap.message(1, 1, R"({"orientation":{"x":0,"y":0,"z":0,"w":1}})");
    mcap.message(
        2, 1,
        R"({"name":["flipper_fl_j","front_right_flipper","flipper_back_left","RR_flipper","left_wheel"],)"
        R"("position":[1,2,30,4,5],"effort":[1,2,3,4,5]})");
    mcap.message(3, 1, R"({"pose":{"pose":{"position":{"x":0}}}})");
    auto recording = openRecording(directory.write("a.mcap", mcap.file()));
    ASSERT_TRUE(recording);
    const auto surveys = surveyRecording(**recording);
    ASSERT_TRUE(surveys);
    const Mapping mapping = parsedMapping(proposedMapping(*surveys, "a \"b\""));
    EXPECT_EQ(mapping.attitude->source.topic, "/imu \"1\"");
    EXPECT_EQ(mapping.of(Quantity::FrontLeft)->field, "position[flipper_fl_j]");
    EXPECT_EQ(mapping.of(Quantity::FrontRight)->field, "position[front_right_flipper]");
    EXPECT_EQ(mapping.of(Quantity::RearLeft)->field, "position[flipper_back_left]");
    EXPECT_LT(mapping.of(Quantity::RearLeft)->factor, 0.1) << "30 is in degrees";
    EXPECT_EQ(mapping.of(Quantity::RearRight)->field, "position[RR_flipper]");
    EXPECT_TRUE(mapping.of(Quantity::RearRightCurrent)->isTorque);
    EXPECT_EQ(mapping.odometry->source.topic, "/odom");
}

TEST_F(Checks, largeMessagesAreOnlyCounted)
{
    McapBytes mcap;
    mcap.channel(1, 0, "/a", "json")
        .message(1, 5, "[" + std::string(70'000, ' ') + "1]")
        .message(1, 1'000'000'005, "[2]");
    auto recording = openRecording(directory.write("a.mcap", mcap.file()));
    const auto surveys = surveyRecording(**recording);
    ASSERT_TRUE(surveys);
    EXPECT_EQ(surveys->at(0).messages, 2U);
    EXPECT_EQ(surveys->at(0).rate(), 1.0);
    EXPECT_TRUE(surveys->at(0).fields.empty());
}

}  // namespace
}  // namespace terratact
