// Tests poses: files, limits and interpolation.
#include "core/clouds/pose_track.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/bytes/csv_mapping.h"
#include "tests/support/bytes/mcap_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/transform_text.h"

namespace terratact {
namespace {

struct Poses : testing::Test {
    Result<PoseTracks> read(const std::string& content)
    {
        return readPoses(directory.write("p", content), {});
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), directory.file("p"), parts);
    }
    TemporaryDirectory directory;
};

TEST_F(Poses, tumIsInterpolatedWithinTheGap)
{
    const auto tracks =
        read("# time x y z q\n10 0 0 0 0 0 0 1\n10.4 0.2 0 0.1 0 0 0.7071068 0.7071068\n"
             "20 0.2 0 0.1 0 0 0.7071068 0.7071068\n");
    ASSERT_TRUE(tracks) << tracks.error().text;
    const PoseTrack& track = tracks->at("");
    const auto middle = track.at(10.2);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->place.x(), 0.1, 1e-12);
    EXPECT_NEAR(middle->place.z(), 0.05, 1e-12);
    const Eigen::Vector3d ahead = middle->turn * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), M_PI / 4, 1e-6);
    EXPECT_FALSE(track.at(15.0)) << "the neighbours are too far apart";
    EXPECT_TRUE(track.at(20.0));
    EXPECT_FALSE(track.at(9.9));
    EXPECT_FALSE(track.at(20.1));
}

TEST_F(Poses, doubtfulUnitsAreReported)
{
    const auto drive = [](double unit, double length) {
        std::string text;
        for (int i = 0; i < 9; ++i)
            text += fmt::format("{} {} 0 0 0 0 0 1\n", 0.4 * i * unit, 0.5 * i * length);
        return text;
    };
    ASSERT_TRUE(read(drive(1.0, 1.0)));
    EXPECT_TRUE(refuses(drive(1e3, 1.0), {"400 s apart", "are the times in ms?"}));
    EXPECT_TRUE(refuses(drive(1e6, 1.0), {"are the times in µs?"}));
    EXPECT_TRUE(refuses(drive(1e9, 1.0), {"400000000 s apart", "are the times in ns?"}));
    for (const auto& [name, perSecond] : {std::pair{"ms", 1e3}, {"µs", 1e6}, {"ns", 1e9}})
        for (const double begin : {0.0, 1.793e9}) {
            std::string text;
            for (int i = 0; i < 900; ++i)
                text +=
                    fmt::format("{:.0f} {} 0 0 0 0 0 1\n", (begin + 0.1 * i) * perSecond, 0.01 * i);
            EXPECT_TRUE(refuses(text, {fmt::format("are the times in {}?", name).c_str()}));
        }
    EXPECT_TRUE(refuses(drive(1.0, 1e3), {"line 2: the pose jumps 500.00 m", "in mm?"}));
    EXPECT_TRUE(
        refuses("1793000000123 0 0 0 0 0 0 1\n", {"line 1: the time", "are the times in ms?"}));
    EXPECT_TRUE(refuses("1793000000123000000 0 0 0 0 0 0 1\n", {"2286", "are the times in ns?"}));
}

TEST_F(Poses, csvHasRunsAndAnyOrder)
{
    const auto tracks =
        read("run,x_m,y_m,z_m,qx,qy,qz,qw,t_s\na,1,2,3,0,0,0,1,5\nb,4,5,6,0,0,0,1,1\n");
    ASSERT_TRUE(tracks) << tracks.error().text;
    EXPECT_EQ(tracks->size(), 2U);
    EXPECT_EQ(tracks->at("b").at(1.0)->place, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(tracks->at("a").begin(), 5.0);
    const auto german = read("time;x;y;z;qx;qy;qz;qw\n1,5;0,25;2;3;0;0;0;1\n");
    ASSERT_TRUE(german) << german.error().text;
    EXPECT_EQ(german->begin()->second.at(1.5)->place, Eigen::Vector3d(0.25, 2, 3));
}

TEST_F(Poses, everyRefusalNamesTheLine)
{
    EXPECT_TRUE(refuses("1 0 0 0 0 0 0 1\n1.1 9 0 0 0 0 0 1\n",
                        {"line 2: the pose jumps 9.00 m", "--max-speed"}));
    EXPECT_TRUE(
        refuses("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", {"line 2: the time 1.000 s does not rise"}));
    EXPECT_TRUE(refuses("1 0 0 0 1 2 0 1\n", {"line 1: the quaternion has the length 2.449"}));
    EXPECT_TRUE(refuses("1 0 nan 0 0 0 0 1\n", {"line 1: y is nan"}));
    EXPECT_TRUE(refuses("1 0 0 0 0 0 0\n", {"line 1: qw is missing"}));
    EXPECT_TRUE(refuses("time,x,y,z,qx,qy,qz\n", {"line 1: names no column qw"}));
    EXPECT_TRUE(refuses("", {"holds no pose"}));
    EXPECT_TRUE(refuses(std::string("\0\1", 2), {"line 1: holds bytes that are no text"}));
}

TEST_F(Poses, transformsMayBeRecordedOutOfOrder)
{
    const Mapping mapping =
        parsedMapping(csvMapping("[odometry]\nframe = \"map\"\nbase_frame = \"base\"\n"));
    constexpr std::int64_t kSecond = 1'000'000'000;
    McapBytes mcap;
    mcap.channel(1, 0, "/tf", "json");
    for (const auto& [stamp, recorded] : {std::pair{10, 12}, {11, 12}, {13, 14}}) {
        const FramePose pose{{0.1 * stamp, 0, 0}, Eigen::Quaterniond::Identity()};
        mcap.message(1, static_cast<std::uint64_t>(recorded * kSecond),
                     transformText("map", "base", pose, stamp * kSecond));
    }
    const auto recording = openRecording(directory.write("a.mcap", mcap.file()));
    ASSERT_TRUE(recording) << recording.error().text;
    const auto tracks = readPoses(**recording, mapping, {});
    ASSERT_TRUE(tracks) << tracks.error().text;
    EXPECT_EQ(tracks->begin()->second.size(), 2U) << "one pose for each time";
    EXPECT_NEAR(tracks->begin()->second.at(14.0)->place.x(), 1.3, 1e-9);
}

TEST_F(Poses, mountsAreSixNumbers)
{
    const auto mount = mountFrom("0.1 0 0.5  0 0 90");
    ASSERT_TRUE(mount);
    EXPECT_TRUE(mount->toOther({1, 0, 0}).isApprox(Eigen::Vector3d(0.1, 1, 0.5), 1e-9));
    EXPECT_TRUE(mount->inverse().toOther({0.1, 1, 0.5}).isApprox(Eigen::Vector3d(1, 0, 0), 1e-9));
    for (const char* wrong : {"", "1 2 3", "1 2 3 4 5 nan", "1 2 3 4 5 6 7", "a b c d e f"})
        EXPECT_FALSE(mountFrom(wrong)) << wrong;
}

}  // namespace
}  // namespace terratact
