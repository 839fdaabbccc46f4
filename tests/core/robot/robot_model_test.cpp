#include "core/robot/robot_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <stdexcept>

#include "core/base/text.h"
#include "tests/support/absolem.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kAbsolem = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";

std::string replaced(std::string text, const std::string& old, const std::string& with)
{
    const std::size_t at = text.find(old);
    if (at == std::string::npos) throw std::invalid_argument("no " + old);
    return text.replace(at, old.size(), with);
}

struct RobotFile : testing::Test {
    Result<RobotModel> read(const std::string& content)
    {
        return readRobotModel(dir.write("robot.toml", content));
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), dir.file("robot.toml"), parts);
    }
    testing::AssertionResult refusesChange(const std::string& old, const std::string& with,
                                           std::initializer_list<std::string_view> parts)
    {
        return refuses(replaced(absolem, old, with), parts);
    }
    TemporaryDirectory dir;
    std::string absolem = contentOf(kAbsolem);
};

/// Centre of mass of both flippers of an axle at joint angle 0, base frame; `forward` is +1 or −1.
Vec2 comOf(const FlipperGeometry& flipper, double forward)
{
    return {flipper.pivot.x + forward * flipper.comDistance * std::cos(flipper.taper()),
            flipper.pivot.z - flipper.comDistance * std::sin(flipper.taper())};
}

TEST(Absolem, hasTheCentreOfMassOfTheWholeRobot)
{
    const RobotModel robot = absolem();
    const Vec2 front = comOf(robot.front, 1.0), rear = comOf(robot.rear, -1.0);
    const double x =
        robot.bodyMass * robot.bodyCom.x + robot.front.mass * front.x + robot.rear.mass * rear.x;
    const double z =
        robot.bodyMass * robot.bodyCom.z + robot.front.mass * front.z + robot.rear.mass * rear.z;
    EXPECT_NEAR(robot.totalMass(), 38.1, 1e-9);
    EXPECT_NEAR(x / robot.totalMass(), -0.031, 1e-5);
    EXPECT_NEAR(z / robot.totalMass(), 0.108, 1e-5);
}

TEST(Absolem, touchesFlatGroundWithTracksAndFlat)
{
    const RobotModel robot = absolem();
    EXPECT_NEAR(robot.trackZ - robot.trackRadius, -robot.baseHeight, 1e-4);
    for (const FlipperGeometry& flipper : {robot.front, robot.rear}) {
        const double tipZ = flipper.pivot.z - flipper.axleDistance * std::sin(flipper.taper());
        EXPECT_NEAR(flipper.pivot.z - flipper.pivotRadius, -robot.baseHeight, 1e-9);
        EXPECT_NEAR(tipZ - flipper.tipRadius, -robot.baseHeight, 1e-9);
        EXPECT_NEAR(flipper.axleDistance + flipper.tipRadius, 0.3476, 1e-9);
        EXPECT_NEAR(flipper.taper(), 0.193732, 1e-4);
        EXPECT_NEAR(flipper.edgeLength(), 0.31303, 1e-5);
    }
}

TEST(Absolem, isMirroredAtTheMiddleBetweenItsAxles)
{
    const RobotModel robot = absolem();
    EXPECT_EQ(robot.rear.pivot, (Vec2{-robot.front.pivot.x, robot.front.pivot.z}));
    EXPECT_EQ(robot.front.pivot.x, robot.trackAxle / 2.0);
    EXPECT_EQ(robot.front.axleDistance, robot.rear.axleDistance);
}

TEST(Absolem, hasSixElementsOfWhichTheLastIsAtTheTip)
{
    const RobotModel robot = absolem();
    for (std::size_t i = 0; i < kForceElements; ++i)
        EXPECT_DOUBLE_EQ(robot.elementShare[i], static_cast<double>(i + 1) / kForceElements);
    EXPECT_EQ(robot.forceSaturation, 20.0);
}

TEST(Absolem, hasTheCalibrationOfItsForceElements)
{
    const ForceCalibration calibration = absolem().forceCalibration;
    EXPECT_EQ(calibration.supply, 5.0);
    EXPECT_EQ(calibration.reference, 10e3);
    EXPECT_EQ(calibration.curve,
              (std::vector<ForcePoint>{{0.2, 30e3}, {1.0, 6e3}, {10.0, 1e3}, {100.0, 250.0}}));
    for (std::size_t e = 0; e < kForceElements; ++e) {
        EXPECT_EQ(calibration.biasLeft[e], 0.3);
        EXPECT_EQ(calibration.biasRight[e], 0.3);
    }
    EXPECT_EQ(calibration.openBelow, 0.2);
    EXPECT_EQ(calibration.shortAbove, 4.95);
}

TEST(Absolem, reachesTheBinsAheadOfItsTracksWithTheArm)
{
    const RobotModel robot = absolem();
    for (int bin = 0; bin <= 10; ++bin) EXPECT_EQ(robot.armReaches(bin), bin >= 6) << bin;
    RobotModel narrow = robot;
    narrow.armReachY = 0.25;
    for (int bin = 6; bin <= 10; ++bin)
        for (const ProbeSide side : {ProbeSide::Left, ProbeSide::Right}) {
            EXPECT_TRUE(robot.armReaches(bin, side)) << bin;
            EXPECT_FALSE(narrow.armReaches(bin, side)) << "the flippers' line is at 0.272 m";
        }
    EXPECT_TRUE(narrow.armReaches(8));
    EXPECT_FALSE(robot.armReaches(2, ProbeSide::Left));
    EXPECT_THROW(static_cast<void>(robot.armReaches(-1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(robot.armReaches(11)), std::invalid_argument);
}

TEST(Absolem, readsEveryKeyIntoItsPlace)
{
    const RobotModel robot = absolem();
    EXPECT_EQ(robot.name, "Absolem");
    EXPECT_EQ(robot.baseHeight, 0.0705);
    EXPECT_EQ(robot.imu, (Vec2{0.0, 0.1694}));
    EXPECT_EQ(robot.trackAxle, 0.5);
    EXPECT_EQ(robot.trackRadius, 0.089);
    EXPECT_EQ(robot.trackZ, 0.01855);
    ASSERT_EQ(robot.body.size(), 3U);
    EXPECT_EQ(
        robot.body[0],
        (std::vector<Vec2>{{-0.372, 0.0485}, {0.128, 0.0485}, {0.128, 0.1875}, {-0.372, 0.1875}}));
    EXPECT_EQ(robot.front.mass, 1.5);
    EXPECT_EQ(robot.front.comDistance, 0.08);
    EXPECT_NEAR(robot.torquePerAmpere * 3.0, 17.0, 1e-12);
    EXPECT_EQ(robot.maxFlipperTorque, 30.0);
    EXPECT_EQ(robot.flipperSpeed, 0.785);
    EXPECT_EQ(robot.armReachBegin, 0.3);
    EXPECT_EQ(robot.armReachEnd, 0.8);
    EXPECT_EQ(robot.armSd, 0.03);
    EXPECT_EQ(robot.travelledSdShare, 0.10);
    EXPECT_EQ(robot.pitchSd, 0.0087);
}

TEST_F(RobotFile, everyKeyIsRequiredAndNoOtherAllowed)
{
    std::istringstream lines(absolem);
    std::string line, section;
    int keys = 0;
    for (std::size_t begin = 0; std::getline(lines, line);) {
        begin += line.size() + 1;  // of the next line
        if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1) + ".";
        const std::size_t equals = line.find(" = ");
        if (equals == std::string::npos || line.starts_with('#')) continue;
        const std::string key = line.substr(0, equals);
        // The key is renamed and not removed, because a value may continue over several lines.
        const std::size_t at = begin - line.size() - 1;
        const std::string renamed = std::string(absolem).insert(at, "my_");
        EXPECT_TRUE(refuses(renamed, {section + key, "missing"})) << section << key;
        const std::string added = std::string(absolem).insert(at, replaced("my_? = 1\n", "?", key));
        EXPECT_TRUE(refuses(added, {"line ", section + "my_", key, "not a known key"}))
            << section << key;
        ++keys;
    }
    EXPECT_EQ(keys, 46);
    EXPECT_TRUE(refusesChange("[arm]", "[arms]", {"arm is missing"}));
    EXPECT_TRUE(refuses(absolem + "\n[laser]\n", {"'laser' is not a known key"}));
}

TEST_F(RobotFile, refusesNumbersOutOfRangeSayingWhatWasExpected)
{
    EXPECT_TRUE(refusesChange(
        "wheel_radius_m = 0.089", "wheel_radius_m = 89",
        {"line 27", "track.wheel_radius_m is 89", "expected a number from 0.001 to 0.5"}));
    EXPECT_TRUE(
        refusesChange("height_m = 0.0705", "height_m = nan", {"base.height_m is nan", "expected"}));
    EXPECT_TRUE(refusesChange("height_m = 0.0705", "height_m = -inf",
                              {"base.height_m is -inf", "expected"}));
    EXPECT_TRUE(refusesChange("height_m = 0.0705", "height_m = 0", {"base.height_m is 0"}));
    EXPECT_TRUE(refusesChange("mass_kg = 35.1", "mass_kg = -1", {"body.mass_kg is -1"}));
    EXPECT_TRUE(refusesChange("tip_radius_m = 0.0286", "tip_radius_m = 0.1",
                              {"front_flipper.tip_radius_m is 0.1"}));
    EXPECT_TRUE(refusesChange("axle_distance_m = 0.319", "axle_distance_m = 0.05",
                              {"front_flipper.axle_distance_m"}));
    EXPECT_TRUE(refusesChange("com_distance_m = 0.08", "com_distance_m = 0.4",
                              {"front_flipper.com_distance_m"}));
    EXPECT_TRUE(refusesChange("speed_rad_s = 0.785", "speed_rad_s = 45",
                              {"flipper_drive.speed_rad_s is 45"}));
    EXPECT_TRUE(
        refusesChange("reach_end_m = 0.80", "reach_end_m = 0.1", {"arm.reach_end_m", "from 0.3"}));
}

TEST_F(RobotFile, refusesValuesOfOtherTypes)
{
    EXPECT_TRUE(refusesChange("0.0705", "\"0.0705\"", {"base.height_m is not a number"}));
    EXPECT_TRUE(refusesChange("0.0705", "true", {"base.height_m is not a number"}));
    EXPECT_TRUE(refusesChange("\"Absolem\"", "7", {"name is not a text"}));
    EXPECT_TRUE(refusesChange("\"Absolem\"", "\"\"", {"name is not a text"}));
    EXPECT_TRUE(
        refusesChange("com_m = [-0.03365, 0.11688]", "com_m = [1]", {"body.com_m", "array of 2"}));
    EXPECT_TRUE(refusesChange("0.5, 0.66", "0.66", {"force_elements.edge_share", "array of 6"}));
    EXPECT_TRUE(refusesChange("0.5, 0.66", "0.1, 0.66", {"force_elements.edge_share", "increase"}));
    EXPECT_TRUE(
        refuses("arm = 1\n" + replaced(absolem, "[arm]\n", "[my_arm]\n"), {"arm is not a table"}));
}

TEST_F(RobotFile, refusesCalibrationsThatCannotBe)
{
    EXPECT_TRUE(refusesChange("[1, 6000]", "[0.1, 6000]",
                              {"force_calibration.curve_n_ohm", "rise in force"}));
    EXPECT_TRUE(refusesChange("[1, 6000]", "[1, 30000]",
                              {"force_calibration.curve_n_ohm", "fall in resistance"}));
    EXPECT_TRUE(refusesChange("[1, 6000]", "[1, 0]", {"force_calibration.curve_n_ohm is 0"}));
    EXPECT_TRUE(refusesChange("[1, 6000]", "[1]", {"curve_n_ohm", "array of 2"}));
    EXPECT_TRUE(refusesChange("[[0.2, 30000], [1, 6000], [10, 1000], [100, 250]]", "[[1, 2]]",
                              {"curve_n_ohm", "array of 2 to 64"}));
    EXPECT_TRUE(refusesChange("bias_left_n = [0.3, ", "bias_left_n = [-1, ",
                              {"force_calibration.bias_left_n is -1"}));
    EXPECT_TRUE(refusesChange("bias_right_n = [0.3, ", "bias_right_n = [99, ",
                              {"force_calibration.bias_right_n is 99", "to 20"}));
    EXPECT_TRUE(refusesChange("bias_right_n = [0.3, ", "bias_right_n = [",
                              {"force_calibration.bias_right_n", "array of 6"}));
    EXPECT_TRUE(refusesChange("open_below_v = 0.2", "open_below_v = 5.1",
                              {"force_calibration.open_below_v is 5.1"}));
    EXPECT_TRUE(refusesChange("short_above_v = 4.95", "short_above_v = 0.1",
                              {"force_calibration.short_above_v is 0.1", "from 0.2 to 5"}));
    EXPECT_TRUE(refusesChange("supply_v = 5.0", "supply_v = 12", {"supply_v is 12"}));
    EXPECT_TRUE(refusesChange("reference_ohm = 10000", "reference_ohm = 0", {"reference_ohm"}));
}

std::string arrayTable(const std::string& name, const std::string& side,
                       const std::string& elements)
{
    return "\n[[force_array]]\nname = \"" + name + "\"\nside = \"" + side + "\"\nelements = ["
         + elements + "]\n";
}

TEST_F(RobotFile, readsForceArrays)
{
    const auto without = read(absolem);
    ASSERT_TRUE(without);
    EXPECT_EQ(without->forceArrays, leftAndRightArrays());

    const auto one = read(absolem + arrayTable("front", "right", "1, 2, 3, 4, 5, 6"));
    ASSERT_TRUE(one) << one.error().text;
    ASSERT_EQ(one->forceArrays.size(), 1U);
    EXPECT_EQ(one->forceArrays[0].name, "front");
    EXPECT_TRUE(haveElement(one->forceArrays, Side::Right, 5));
    EXPECT_FALSE(haveElement(one->forceArrays, Side::Left, 5));

    const auto four = read(
        absolem + arrayTable("L low", "left", "1, 2, 3") + arrayTable("L tip", "left", "4, 5, 6")
        + arrayTable("R low", "right", "3, 1, 2") + arrayTable("R tip", "right", "6"));
    ASSERT_TRUE(four) << four.error().text;
    ASSERT_EQ(four->forceArrays.size(), 4U);
    EXPECT_EQ(four->forceArrays[2].name, "R low");
    EXPECT_EQ(four->forceArrays[3].has, (std::array{false, false, false, false, false, true}));
}

TEST_F(RobotFile, refusesForceArraysThatTheLinkCannotCarry)
{
    const std::string all = "1, 2, 3, 4, 5, 6", left = arrayTable("L", "left", all);
    EXPECT_TRUE(refuses(absolem + arrayTable("L", "rear_left", all),
                        {"line 115", "force_array.side is 'rear_left'", "\"left\" or \"right\""}));
    EXPECT_TRUE(refuses(absolem + arrayTable("L", "left", "1, 2, 3, 4, 5, 6, 7"),
                        {"line 116", "force_array.elements is not an array of 1 to 6"}));
    EXPECT_TRUE(refuses(absolem + arrayTable("L", "left", "1, 7"),
                        {"line 116", "force_array.elements is 7", "from 1 to 6"}));
    EXPECT_TRUE(refuses(absolem + arrayTable("L", "left", "1, 2.5"), {"2.5", "whole numbers"}));
    EXPECT_TRUE(refuses(absolem + left + arrayTable("again", "left", "3"),
                        {"line 121", "element 3 of that side again", "one array for each"}));
    EXPECT_TRUE(refuses(absolem + left + arrayTable("L", "right", all),
                        {"line 119", "force_array.name is 'L' again", "a name of its own"}));
    EXPECT_TRUE(refuses(absolem + arrayTable("L", "left", "1, 2, 4, 5, 6")
                            + arrayTable("R", "right", "1, 2"),
                        {"line 113", "no force_array has element 3", "each of 1 to 6"}));
    std::string five;
    for (const char* element : {"1", "2", "3", "4", "5, 6"})
        five += arrayTable("L", "left", element);
    EXPECT_TRUE(refuses(absolem + five, {"line 133", "more than the 4 expected"}));
    EXPECT_TRUE(refuses(absolem + arrayTable("a long name", "left", all),
                        {"line 114", "force_array.name is 'a long name'", "at most 6"}));
    EXPECT_TRUE(refuses(absolem + "\n[force_array]\nname = \"L\"\n",
                        {"line 113", "expected [[force_array]]"}));
    EXPECT_TRUE(refuses(absolem + left + "colour = 7\n", {"line 117", "'force_array.colour'"}));
}

TEST_F(RobotFile, readsLeftAndRight)
{
    const auto shipped = read(absolem);
    ASSERT_TRUE(shipped);
    EXPECT_EQ(shipped->lateral, (LateralGeometry{0.1985, 0.097, 0.272, 0.050, 0.0}));
    EXPECT_EQ(shipped->differential, (TrackDifferential{true, 0.7}));
    EXPECT_DOUBLE_EQ(shipped->halfWidth, 0.247);  // 0.494 m over the tracks
    EXPECT_FALSE(shipped->rearElementShare);

    const auto other =
        read(replaced(replaced(replaced(absolem, "flipper_y_m = 0.272", "flipper_y_m = 0.1"),
                               "body_com_y_m = 0.0", "body_com_y_m = -0.02"),
                      "state = \"locked\"", "state = \"free\""));
    ASSERT_TRUE(other) << other.error().text;
    EXPECT_EQ(other->lateral.flipperY, 0.1);  // flippers between the tracks
    EXPECT_EQ(other->lateral.bodyComY, -0.02);
    EXPECT_FALSE(other->differential.locked);
}

TEST_F(RobotFile, withoutSidesHasTheStatedDefaults)
{
    const std::string old = absolem.substr(0, absolem.find("# Left and right"));
    const auto robot = read(old);
    ASSERT_TRUE(robot) << robot.error().text;
    EXPECT_EQ(robot->lateral, LateralGeometry{});
    EXPECT_EQ(robot->differential, TrackDifferential{});
    EXPECT_EQ(robot->halfWidth, 0.25);
    const auto wide = read(absolem + "\n[tip_over]\nhalf_width_m = 0.3\n");
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->halfWidth, 0.3);
}

TEST_F(RobotFile, readsRearForceElements)
{
    const std::string table =
        "\n[rear_force_elements]\nedge_share = [0.1, 0.2, 0.4, 0.6, 0.8, 1.0]\n";
    const auto robot = read(absolem + table);
    ASSERT_TRUE(robot) << robot.error().text;
    EXPECT_EQ(robot->rearElementShare, (std::array{0.1, 0.2, 0.4, 0.6, 0.8, 1.0}));
    EXPECT_TRUE(refuses(absolem + replaced(table, "0.2", "0.1"),
                        {"line 114", "rear_force_elements.edge_share does not increase"}));
    EXPECT_TRUE(refuses(absolem + "\n[rear_force_elements]\n",
                        {"rear_force_elements.edge_share is missing"}));
}

TEST_F(RobotFile, refusesSidesThatCannotBe)
{
    EXPECT_TRUE(refusesChange("flipper_y_m = 0.272", "flipper_y_m = 0.2",
                              {"line 104", "lateral.flipper_y_m is 0.2", "at least 0.0735 m",
                               "flipper and track overlap"}));
    EXPECT_TRUE(refusesChange("track_y_m = 0.1985", "track_y_m = 0.04",
                              {"line 102", "lateral.track_y_m is 0.04", "from 0.0485"}));
    EXPECT_TRUE(refusesChange("body_com_y_m = 0.0", "body_com_y_m = 0.3",
                              {"line 106", "lateral.body_com_y_m is 0.3", "to 0.1985"}));
    EXPECT_TRUE(refusesChange(
        "state = \"locked\"", "state = \"open\"",
        {"line 110", "track_differential.state is 'open'", "\"locked\" or \"free\""}));
    EXPECT_TRUE(refusesChange("limit_rad = 0.7", "limit_rad = 7",
                              {"line 111", "track_differential.limit_rad is 7"}));
}

TEST_F(RobotFile, takesWholeNumbersForNumbers)
{
    EXPECT_TRUE(read(replaced(absolem, "saturation_n = 20.0", "saturation_n = 20")));
}

TEST_F(RobotFile, refusesPolygonsThatAreNotConvex)
{
    const std::string box =
        "[[-0.372, 0.0485], [0.128, 0.0485], [0.128, 0.1875], [-0.372, 0.1875]]";
    const auto with = [&](const std::string& polygon) { return replaced(absolem, box, polygon); };
    EXPECT_TRUE(read(with("[[0, 0], [0, 1], [1, 0]]"))) << "clockwise";
    EXPECT_TRUE(
        refuses(with("[[0, 0], [1, 0], [0.1, 0.1], [0, 1]]"), {"body.polygons_m", "not convex"}));
    EXPECT_TRUE(refuses(with("[[0, 0], [1, 0], [2, 0]]"), {"not convex"})) << "flat";
    EXPECT_TRUE(
        refuses(with("[[0, 1], [0.59, -0.81], [-0.95, 0.31], [0.95, 0.31], [-0.59, -0.81]]"),
                {"not convex"}))
        << "a star";
    EXPECT_TRUE(refuses(with("[[0, 0], [1, 0]]"), {"array of 3 to 64"}));
    EXPECT_TRUE(refuses(with("[[0, 0], [1, 0], [0]]"), {"array of 2"}));
}

TEST_F(RobotFile, refusesWhatIsNotToml)
{
    EXPECT_TRUE(refuses("", {"is empty"}));
    EXPECT_TRUE(refuses("name = \n", {"line 1", "not TOML"}));
    EXPECT_TRUE(refuses(absolem + "\nheight_m = 1\nheight_m = 2\n", {"not TOML"}));
    EXPECT_TRUE(refuses(std::string("\0\0\0\0", 4), {"not TOML"}));
    EXPECT_TRUE(refuses("name = \"\xff\xfe\"\n", {"not TOML"}));
    EXPECT_TRUE(refused(readRobotModel(dir.file("")), dir.file(""), {"directory"}));
    EXPECT_TRUE(refused(readRobotModel(dir.file("none")), dir.file("none"), {"cannot be opened"}));
}

TEST_F(RobotFile, quotesNoControlCharacterOfAFile)
{
    for (const char* text : {"a = 1\x1b[31m\n", "\x01 = 1\n", "a = \"\x7f\"\n", "a = ,,\x0b\n"}) {
        const Result<RobotModel> robot = robotModelFrom("text", text);
        ASSERT_TRUE(refused(robot, "text", {"not TOML"}));
        EXPECT_TRUE(std::none_of(robot.error().text.begin(), robot.error().text.end(), isControl))
            << text;
    }
}

TEST_F(RobotFile, refusesHugeAndDeepFilesBeforeParsingThem)
{
    EXPECT_TRUE(refused(robotModelFrom("text", absolem + std::string(65536, '#')), "text",
                        {"larger than the 65536 bytes"}));
    EXPECT_TRUE(refuses(absolem + std::string(65536, '#'), {"larger than the 65536 bytes"}));
    std::string dotted = "a", braces = "a = ";
    for (int i = 0; i < 10000; ++i) dotted += ".a";
    for (int i = 0; i < 10000; ++i) braces += "{a=";
    for (const std::string& deep :
         {"a = " + std::string(60000, '['), dotted + " = 1\n", braces, "[" + dotted + "]\n"})
        EXPECT_TRUE(refuses(deep, {"nests deeper than 16"}));
}

TEST_F(RobotFile, everyFileOfBytesIsReadOrRefusedInOneLine)
{
    std::mt19937_64 rng(9);
    for (int i = 0; i < 500; ++i) {
        std::string content = absolem;
        for (int changes = 0; changes < 3; ++changes)
            content[rng() % content.size()] = static_cast<char>(rng());
        const Result<RobotModel> robot = read(content);
        ASSERT_TRUE(robot || refused(robot, dir.file("robot.toml"), {}));
    }
}

}  // namespace
}  // namespace terratact
