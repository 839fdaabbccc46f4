// Tests the numbers of a robot file against each other, and its picture.
#include "app/modelling/robots/robot_check.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "app/figures/robot_figure.h"
#include "core/robot/robot_file_lines.h"
#include "core/store/file_read.h"
#include "tests/support/absolem.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Level = RobotFinding::Level;

/// Returns the findings of Absolem after a change, as "level key".
std::vector<std::string> changed(const std::function<void(RobotModel&)>& change)
{
    RobotModel robot = absolem();
    change(robot);
    std::vector<std::string> found;
    for (const RobotFinding& f : checkRobot(robot))
        found.push_back((f.level == Level::Problem ? "problem " : "remark ") + f.key);
    return found;
}
using Found = std::vector<std::string>;

TEST(RobotCheckOfNumbers, shippedRobotHasNoFinding)
{
    EXPECT_EQ(changed([](RobotModel&) {}), Found{});
}

TEST(RobotCheckOfNumbers, flipperLongerThanTheTrackIsARemark)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.front.axleDistance = 0.75; }),
              Found{"remark front_flipper.axle_distance_m"});
}

TEST(RobotCheckOfNumbers, rearFlipperThatPassesTheFrontPivotIsARemark)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.rear.axleDistance = 0.48; }),
              Found{"remark rear_flipper.axle_distance_m"});
}

TEST(RobotCheckOfNumbers, centreOfMassOutsideOfTheSupportCannotBe)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.bodyCom.x = -0.34; }), Found{"remark body.com_m"});
    EXPECT_EQ(changed([](RobotModel& r) {
                  r.bodyCom.x = -0.33;
                  r.rear.axleDistance = 0.095;
              }).back(),
              "remark body.com_m");
    EXPECT_EQ(changed([](RobotModel& r) {
                  r.bodyCom = {-33.0, 0.1};
              }).front(),
              "problem body.com_m");
}

TEST(RobotCheckOfNumbers, baseHeightFollowsFromTheTracks)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.baseHeight += 0.002; }), Found{});
    EXPECT_EQ(changed([](RobotModel& r) { r.baseHeight += 0.02; }), Found{"remark base.height_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.baseHeight += 0.04; }), Found{"problem base.height_m"});
}

TEST(RobotCheckOfNumbers, flipperAtZeroLiesInLineWithTheTracks)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.rear.pivot.z += 0.01; }),
              Found{"remark rear_flipper.pivot_radius_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.front.pivot.z += 0.05; }),
              Found{"problem front_flipper.pivot_radius_m"});
}

TEST(RobotCheckOfNumbers, exchangedFlippersCannotBe)
{
    EXPECT_EQ(changed([](RobotModel& r) { std::swap(r.front, r.rear); }),
              (Found{"problem front_flipper.pivot_m", "problem rear_flipper.pivot_m"}));
}

TEST(RobotCheckOfNumbers, motorsThatCannotLiftAreFound)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.maxFlipperTorque = 10.0; }),
              Found{"remark flipper_drive.max_torque_nm"});
    EXPECT_EQ(changed([](RobotModel& r) { r.maxFlipperTorque = 0.3; }).front(),
              "problem flipper_drive.max_torque_nm");
}

TEST(RobotCheckOfNumbers, forceElementsStayWithinTheirVoltages)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.forceCalibration.shortAbove = 4.5; }),
              Found{"problem force_calibration.short_above_v"});
    EXPECT_EQ(changed([](RobotModel& r) { r.forceCalibration.openBelow = 2.0; }),
              Found{"problem force_calibration.open_below_v"});
    EXPECT_EQ(changed([](RobotModel& r) { r.forceCalibration.curve.back().force = 15.0; }).back(),
              "remark force_calibration.curve_n_ohm");
}

TEST(RobotCheckOfNumbers, partsOutsideOfTheRobotAreFound)
{
    EXPECT_EQ(changed([](RobotModel& r) { r.imu.z = -0.2; }), Found{"problem imu.z_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.imu.x = 0.9; }), Found{"remark imu.x_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.halfWidth = 0.5; }),
              Found{"problem tip_over.half_width_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.body.front()[0].z = -0.1; }),
              Found{"problem body.polygons_m"});
    EXPECT_EQ(changed([](RobotModel& r) { r.armReachBegin = r.armReachEnd = 1.5; }),
              Found{"remark arm.reach_begin_m"});
}

TEST(RobotCheckOfFile, findingsBeginWithLineAndKey)
{
    const TemporaryDirectory directory;
    std::string text =
        *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", std::size_t{1} << 20U);
    const std::string key = "\nmax_torque_nm = 30.0";
    text.replace(text.find(key), key.size(), "\nmax_torque_nm = 3.0");
    const std::string path = directory.write("robot.toml", text);
    const auto check = checkRobotFile(path);
    ASSERT_TRUE(check) << check.error().text;
    ASSERT_EQ(check->findings.size(), 1U);
    const std::size_t line = lineOfKey(text, "flipper_drive.max_torque_nm");
    EXPECT_EQ(check->findings[0].text.find(
                  fmt::format("line {}: flipper_drive.max_torque_nm is 3, but", line)),
              0U)
        << check->findings[0].text;
    EXPECT_EQ(check->problems(), 0U);
}

TEST(RobotCheckOfFile, missingSidesAreARemark)
{
    const TemporaryDirectory directory;
    std::string text =
        *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", std::size_t{1} << 20U);
    const std::size_t begin = text.find("[lateral]");
    text.erase(begin, text.find("[track_differential]") - begin);
    const auto check = checkRobotFile(directory.write("robot.toml", text));
    ASSERT_TRUE(check) << check.error().text;
    ASSERT_EQ(check->findings.size(), 1U);
    EXPECT_EQ(check->findings[0].key, "lateral");
}

TEST(RobotFileLines, keyOrItsTableIsFound)
{
    const std::string text = "a = 1\n[b]\nc = 2\n";
    EXPECT_EQ(lineOfKey(text, "a"), 1U);
    EXPECT_EQ(lineOfKey(text, "b.c"), 3U);
    EXPECT_EQ(lineOfKey(text, "b.d"), 2U);
    EXPECT_EQ(lineOfKey(text, "e.f"), 0U);
    EXPECT_EQ(lineOfKey("= no TOML", "a"), 0U);
}

TEST(RobotFigure, everyRobotIsDrawnWithItsParts)
{
    const TemporaryDirectory directory;
    RobotModel robot = absolem();
    robot.rearElementShare = robot.elementShare;
    ASSERT_TRUE(writeRobotFigure(directory.file("robot.svg"), robot));
    ASSERT_TRUE(writeRobotFigure(directory.file("robot.png"), robot));
    const auto svg = readFile(directory.file("robot.svg"), std::size_t{1} << 22U);
    ASSERT_TRUE(svg);
    EXPECT_NE(svg->find("<svg"), std::string::npos);
    EXPECT_FALSE(writeRobotFigure(directory.file("robot.gif"), robot));
    EXPECT_FALSE(std::filesystem::exists(directory.file("robot.gif")));
}

}  // namespace
}  // namespace terratact
