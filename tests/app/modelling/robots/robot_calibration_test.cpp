// Tests the calibration on a flat floor with simulated robots whose numbers differ from the file's.
#include "app/modelling/robots/robot_calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/modelling/robots/robot_proposal.h"
#include "core/sim/simulated_robot.h"
#include "core/store/file_read.h"
#include "core/terrain/terrain_profile.h"
#include "tests/support/absolem.h"
#include "tests/support/sessions/floor_recording.h"

namespace terratact {
namespace {

using P = FloorParameter;

/// Returns the truth of the tests: a robot and sensors that differ from the file.
FloorRobot different()
{
    FloorRobot truth{.robot = absolem()};
    truth.robot.trackAxle = 0.53;
    truth.robot.front.axleDistance = 0.335;
    truth.robot.rear.axleDistance = 0.305;
    truth.robot.torquePerAmpere = 6.4;
    truth.encoders = {0.03, 0.03, -0.02, -0.02};
    truth.pitch = 0.015;
    truth.roll = -0.02;
    truth.yaw = 0.05;
    return truth;
}

double truthOf(const FloorRobot& truth, std::size_t p)
{
    const FloorParameters lengths = parametersOf(truth.robot);
    if (p < P::Encoders) return lengths[static_cast<Eigen::Index>(p)];
    if (p < P::ImuPitch) return truth.encoders.at(p - P::Encoders);
    return std::array{truth.pitch, truth.roll, truth.yaw}.at(p - P::ImuPitch);
}

TEST(FloorModel, restIsThatOfTheSimulatedRobot)
{
    RobotModel robot = absolem();
    robot.trackAxle = 0.53;
    const TerrainProfile floor(std::vector<Vec2>{{-3.0, 0.0}, {5.0, 0.0}});
    for (const auto& [front, rear] :
         {std::pair{0.6, 0.6}, {-0.5, 0.5}, {0.5, -0.6}, {-0.7, -0.3}}) {
        const auto expected = restPose(robot, floor, 0.0, HoldAngle{front}, HoldAngle{rear});
        ASSERT_TRUE(expected);
        const auto rest = restOnFloor(robot, front, rear);
        ASSERT_TRUE(rest);
        EXPECT_NEAR(rest->pitch, expected->pose.pitch, 3e-4);
        if (rest->onFrontTip) {
            EXPECT_NEAR(rest->frontTorque, expected->frontTorque, 1.5);
        }
        if (rest->onRearTip) {
            EXPECT_NEAR(rest->rearTorque, expected->rearTorque, 1.5);
        }
        EXPECT_EQ(rest->onFrontTip, front < 0.0);
        EXPECT_EQ(rest->onRearTip, rear < 0.0);
    }
}

TEST(StandingPoses, everyHeldPoseIsFoundOnce)
{
    const auto poses = standingPoses(floorRecording({.robot = absolem()}, 1));
    EXPECT_GE(poses.size(), kFloorPoses.size());
    EXPECT_LE(poses.size(), kFloorPoses.size() + 4);
    for (const StandingPose& pose : poses) EXPECT_GE(pose.lines, 10U);
}

TEST(StandingPoses, aCurrentThatALineLacksIsMissing)
{
    std::vector<TelemetryLine> lines;
    for (int i = 0; i < 20; ++i) {
        Measurement m;
        setCurrents(m, {1.5, 1.5, std::nullopt, 1.5});
        if (i == 7) setCurrents(m, {std::nullopt, 1.5, std::nullopt, 1.5});
        lines.push_back({std::int64_t{50'000'000} * i, m});
    }
    const auto poses = standingPoses(lines);
    ASSERT_EQ(poses.size(), 1U);
    EXPECT_EQ(motorCurrents(poses[0].mean), (MotorCurrents{std::nullopt, 1.5, std::nullopt, 1.5}));
    EXPECT_EQ(poses[0].mean.frontLeftCurrent, 0.0);
}

TEST(RobotCalibration, findsANotherRobotWithinTwoSd)
{
    const FloorRobot truth = different();
    int beyond = 0, of = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        const auto found = calibrateRobot(absolem(), standingPoses(floorRecording(truth, seed)));
        ASSERT_TRUE(found) << found.error().text;
        EXPECT_LT(found->after, 0.3 * found->before);
        for (std::size_t p = 0; p < P::Count; ++p) {
            const Calibrated& c = found->parameter[p];
            const double off = std::abs(c.value - truthOf(truth, p));
            EXPECT_LT(off, 3.5 * c.sd) << "parameter " << p << " is " << c.value << " ± " << c.sd
                                       << ", truth " << truthOf(truth, p);
            beyond += off > 2.0 * c.sd ? 1 : 0;
            ++of;
        }
        for (const std::size_t p : {P::FrontLength, P::RearLength, P::ImuPitch, P::ImuRoll})
            EXPECT_TRUE(found->parameter.at(p).isIdentified) << "parameter " << p;
        ASSERT_TRUE(found->torquePerAmpere);
        EXPECT_NEAR(found->torquePerAmpere->value, 6.4, 2.0 * found->torquePerAmpere->sd);
    }
    EXPECT_LE(beyond, of / 10);
}

TEST(RobotCalibration, namesTheSidesOfPressedFlippers)
{
    FloorRobot truth{.robot = absolem()};
    truth.encoders = {0.05, 0.01, 0.0, 0.0};
    const auto found = calibrateRobot(absolem(), standingPoses(floorRecording(truth, 5)));
    ASSERT_TRUE(found);
    for (const std::size_t f : {0U, 1U})
        EXPECT_NEAR(found->parameter[P::Encoders + f].value, truth.encoders.at(f),
                    2.0 * found->parameter[P::Encoders + f].sd);
    EXPECT_LT(found->parameter[P::Encoders].sd, 0.01);
}

TEST(RobotCalibration, raisedFlippersIdentifyTheImuAlone)
{
    const FloorRobot truth = different();
    const auto found = calibrateRobot(
        absolem(), standingPoses(floorRecording(truth, 1, kRaisedFloorPoses, false)));
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_TRUE(found->parameter[P::ImuPitch].isIdentified);
    EXPECT_TRUE(found->parameter[P::ImuRoll].isIdentified);
    for (const std::size_t p : {P::FrontLength, P::RearLength, P::Encoders, P::ImuYaw})
        EXPECT_FALSE(found->parameter.at(p).isIdentified) << "parameter " << p;
    EXPECT_FALSE(found->torquePerAmpere);
}

TEST(RobotCalibration, posesOffTheFloorAreLeftOut)
{
    auto poses = standingPoses(floorRecording({.robot = absolem()}, 2));
    poses.front().mean.pitch += 0.3;
    const auto found = calibrateRobot(absolem(), poses);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->used + 1, found->poses);
}

TEST(RobotCalibration, anglesOfTheWrongSignAreRefused)
{
    auto poses = standingPoses(floorRecording({.robot = absolem()}, 2));
    for (StandingPose& pose : poses) pose.mean.pitch *= -1.0;
    const auto found = calibrateRobot(absolem(), poses);
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().text.find("check signs and units"), std::string::npos);
}

TEST(RobotCalibration, aRecordingWithoutPosesIsRefused)
{
    const auto found = calibrateRobot(absolem(), {});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().text.find("0 poses"), 0U);
}

TEST(RobotProposal, identifiedNumbersReplaceThoseOfTheFile)
{
    const std::string path = TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml";
    const std::string text = *readFile(path, std::size_t{1} << 16U);
    const auto found = calibrateRobot(absolem(), standingPoses(floorRecording(different(), 1)));
    ASSERT_TRUE(found);
    const auto proposed = proposedRobotFile(path, text, *found);
    ASSERT_TRUE(proposed) << proposed.error().text;
    const auto robot = robotModelFrom("proposed", *proposed);
    ASSERT_TRUE(robot) << robot.error().text;
    EXPECT_NEAR(robot->front.axleDistance, found->parameter[P::FrontLength].value, 1e-5);
    EXPECT_NEAR(robot->torquePerAmpere, found->torquePerAmpere->value, 1e-5);
    EXPECT_EQ(robot->trackAxle, absolem().trackAxle);  // not identified
    EXPECT_NE(proposed->find("# calibrated: sd 0.0"), std::string::npos);
    EXPECT_EQ(std::count(proposed->begin(), proposed->end(), '\n'),
              std::count(text.begin(), text.end(), '\n'));
}

TEST(RobotProposal, reportSaysWhatIsFoundAndWhatIsNot)
{
    const auto found = calibrateRobot(absolem(), standingPoses(floorRecording(different(), 1)));
    ASSERT_TRUE(found);
    std::string all;
    for (const std::string& line : calibrationReport(*found, absolem())) all += line + "\n";
    EXPECT_NE(all.find("front_flipper.axle_distance_m = 0.3"), std::string::npos) << all;
    EXPECT_NE(all.find("not identified: track.axle_distance_m"), std::string::npos) << all;
    EXPECT_NE(all.find("IMU, pitch reads +0.01"), std::string::npos) << all;
    EXPECT_NE(all.find("never identified by standing poses"), std::string::npos) << all;
}

TEST(RobotProposal, numberInAnInlineTableIsRefused)
{
    std::string text =
        *readFile(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml", std::size_t{1} << 16U);
    const std::size_t begin = text.find("[flipper_drive]");
    text.erase(begin, text.find("# [assumption] \"about", begin) - begin);
    const std::string name = "name = \"Absolem\"";
    text.insert(
        text.find(name),
        "flipper_drive = {torque_per_ampere_nm = 5.6, max_torque_nm = 30, speed_rad_s = 0.7}\n");
    ASSERT_TRUE(robotModelFrom("robot.toml", text));
    const auto found = calibrateRobot(absolem(), standingPoses(floorRecording(different(), 1)));
    const auto proposed = proposedRobotFile("robot.toml", text, *found);
    ASSERT_FALSE(proposed);
    EXPECT_NE(proposed.error().text.find("does not stand on a line of its own"), std::string::npos);
}

}  // namespace
}  // namespace terratact
