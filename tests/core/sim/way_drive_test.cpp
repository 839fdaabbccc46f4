#include "core/sim/way_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/sim/ground/terrain_shapes.h"
#include "tests/support/absolem.h"

namespace terratact {
namespace {

constexpr double kStepX = 2.0;

TerrainProfile step()
{
    return stepTerrain(0.1, kStepX, 5.0);
}

struct WayDriven {
    DriveLines drive;
    int skipped = 0;
};

template <class Ground>
WayDriven driven(const Ground& ground, const WayDriveOptions& options,
                 const SensorNoise& noise = SensorNoise::none(), std::uint64_t seed = 1)
{
    std::mt19937_64 rng(seed);
    WayDriven result;
    result.drive =
        driveWay(absolem(), ground, "7", {}, options, {.noise = noise}, rng, result.skipped);
    return result;
}

std::vector<DriveLine> ofKind(const DriveLines& drive, bool isScene)
{
    std::vector<DriveLine> lines;
    std::ranges::copy_if(drive.lines, std::back_inserter(lines),
                         [&](const DriveLine& line) { return line.isScene == isScene; });
    return lines;
}

/// Returns the way of the tracks over the drive's stretch, without slip, in steps of the drive's.
double trackWayOver(const TerrainProfile& ground, double spacing, double step)
{
    const auto stops = stopsOver(ground, spacing);
    const auto count = std::lround((stops.back() - stops.front()) / step);
    double way = 0.0, pitch = 0.0;
    Pose last;
    for (long k = 0; k <= count; ++k) {
        const auto rest = restPose(absolem(), ground, stops.front() + step * static_cast<double>(k),
                                   HoldAngle{DriveStyle{}.drivingAngle},
                                   HoldAngle{DriveStyle{}.rearAngle}, pitch);
        pitch = rest->pose.pitch;
        if (k > 0) way += trackWay(last, rest->pose);
        last = rest->pose;
    }
    return way;
}

TEST(WayDrive, linesOfTheWayLieBetweenScenes)
{
    const auto [drive, skipped] = driven(flatTerrain(4.0), {.spacing = 0.3, .slipShare = 0.0});
    EXPECT_EQ(skipped, 0);
    EXPECT_EQ(drive.run, "7");
    EXPECT_TRUE(drive.onePlane);
    const auto scenes = ofKind(drive, true);
    ASSERT_EQ(scenes.size(), stopsOver(flatTerrain(4.0), 0.3).size());
    EXPECT_EQ(drive.lines.size(), scenes.size() + 1 + 10 * (scenes.size() - 1));
    for (std::size_t i = 1; i < drive.lines.size(); ++i) {
        const DriveLine &before = drive.lines[i - 1], &line = drive.lines[i];
        EXPECT_EQ(line.isScene, line.line.activity == RobotActivity::Pressed);
        EXPECT_EQ(line.line.turned, 0.0);
        EXPECT_LE(line.line.time - before.line.time, kMaxSilence);
        EXPECT_GT(line.line.time, before.line.time);
        const double way = *line.line.travelled - *before.line.travelled;
        EXPECT_NEAR(way, line.isScene ? 0.0 : 0.03, 1e-6);
        EXPECT_EQ(line.truth[0][5].has_value(), line.isScene);
        EXPECT_EQ(line.truth[0], line.truth[1]);
    }
}

TEST(WayDrive, flippersFeelTheGroundAtStopsAlone)
{
    const DriveLines drive = driven(flatTerrain(4.0), {.spacing = 0.3}).drive;
    for (const DriveLine& line : drive.lines) {
        EXPECT_EQ(line.line.frontLeft < DriveStyle{}.drivingAngle - 0.1, line.isScene);
        EXPECT_EQ(line.line.force[5] + line.line.force[4] > 5.0, line.isScene);
        EXPECT_EQ(line.line.sides.left, line.line.sides.right);
    }
}

TEST(WayDrive, odometryWithoutSlipIsTheTracksWay)
{
    const DriveLines drive = driven(step(), {.spacing = 0.3, .slipShare = 0.0}).drive;
    EXPECT_NEAR(*drive.lines.back().line.travelled, trackWayOver(step(), 0.3, 0.03), 1e-6);
    double before = 0.0;
    for (const DriveLine& line : drive.lines) {
        EXPECT_GE(*line.line.travelled, before);
        before = *line.line.travelled;
    }
    const auto pitches = [](const DriveLine& a, const DriveLine& b) {
        return a.line.pitch < b.line.pitch;
    };
    EXPECT_GT(std::ranges::max(drive.lines, pitches).line.pitch, 0.1);  // it climbs the step
}

TEST(WayDrive, slipIsDrawnForEachStretch)
{
    const DriveLines drive = driven(flatTerrain(400.0), {.spacing = 1.0, .step = 0.5}).drive;
    double squares = 0.0;
    int stretches = 0;
    for (std::size_t i = 3; i < drive.lines.size(); ++i) {
        if (!drive.lines[i].isScene) continue;
        const auto way = [&](std::size_t from, std::size_t to) {
            return (*drive.lines[to].line.travelled - *drive.lines[from].line.travelled) / 0.5;
        };
        EXPECT_NEAR(way(i - 3, i - 2), way(i - 2, i - 1), 1e-6);  // one slip within a stretch
        squares += std::pow(way(i - 2, i - 1) - 1.0, 2.0);
        ++stretches;
    }
    ASSERT_GT(stretches, 390);
    EXPECT_NEAR(std::sqrt(squares / stretches), 0.1, 0.015);
}

TEST(WayDrive, driveSlipScalesTheWholeWay)
{
    const auto scaled = [](std::uint64_t seed) {
        WayDriveOptions options{.spacing = 1.0, .step = 0.5};
        const DriveLines plain = driven(flatTerrain(4.0), options, {}, seed).drive;
        options.driveSlip = 0.1;
        DriveLines slipped = driven(flatTerrain(4.0), options, {}, seed).drive;
        EXPECT_EQ(slipped.lines.size(), plain.lines.size());
        const double factor =
            *slipped.lines.back().line.travelled / *plain.lines.back().line.travelled;
        for (std::size_t i = 0; i < std::min(plain.lines.size(), slipped.lines.size()); ++i) {
            const double way = *plain.lines[i].line.travelled;
            EXPECT_NEAR(*slipped.lines[i].line.travelled, factor * way, 1e-9);
            slipped.lines[i].line.travelled = way;
        }
        EXPECT_EQ(slipped, plain);  // nothing else changes
        return factor;
    };
    constexpr int kRuns = 100;
    double squares = 0.0;
    for (int seed = 1; seed <= kRuns; ++seed)
        squares += std::pow(scaled(static_cast<std::uint64_t>(seed)) - 1.0, 2.0);
    EXPECT_NEAR(std::sqrt(squares / kRuns), 0.1, 0.03);
}

TEST(WayDrive, stopsWithoutPressHaveNoScene)
{
    const TerrainProfile ground = flatTerrain(100.0);
    const WayDriveOptions all{.spacing = 0.25, .step = 0.25};
    WayDriveOptions half = all;
    half.pressShare = 0.5;
    const DriveLines full = driven(ground, all).drive, some = driven(ground, half).drive;
    EXPECT_NEAR(static_cast<double>(ofKind(some, true).size()),
                0.5 * static_cast<double>(ofKind(full, true).size()), 40.0);
    EXPECT_EQ(ofKind(some, false).size(), ofKind(full, false).size());
    half.pressShare = 0.0;
    const auto none = driven(ground, half);
    EXPECT_EQ(none.skipped, 0);
    EXPECT_TRUE(ofKind(none.drive, true).empty());
}

TEST(WayDrive, pressTorqueReplacesThatOfTheStyle)
{
    WayDriveOptions options{.spacing = 0.3, .slipShare = 0.0};
    const DriveLines full = driven(step(), options).drive;
    options.pressTorque = 4.0;
    const DriveLines light = driven(step(), options).drive;
    const auto torqueOnLevelGround = [](const DriveLines& drive) {
        const Measurement scene = ofKind(drive, true).at(0).line;
        return absolem().torquePerAmpere * (scene.frontLeftCurrent + scene.frontRightCurrent);
    };
    EXPECT_NEAR(torqueOnLevelGround(full), DriveStyle{}.pressTorque, 0.01);
    EXPECT_NEAR(torqueOnLevelGround(light), 4.0, 0.01);
    EXPECT_EQ(ofKind(light, false), ofKind(full, false)) << "the way is the same";
}

TEST(WayDrive, gapLosesTelemetryOnce)
{
    WayDriveOptions options{.spacing = 0.3};
    const DriveLines whole = driven(flatTerrain(10.0), options).drive;
    options.gap = 5.0;
    const DriveLines lost = driven(flatTerrain(10.0), options).drive;
    int gaps = 0;
    for (std::size_t i = 1; i < lost.lines.size(); ++i) {
        const double silence = lost.lines[i].line.time - lost.lines[i - 1].line.time;
        if (silence <= kMaxSilence) continue;
        ++gaps;
        EXPECT_NEAR(silence, options.gap, 1.2);
    }
    EXPECT_EQ(gaps, 1);
    for (const DriveLine& line : lost.lines)
        EXPECT_EQ(std::ranges::count(whole.lines, line), 1);  // the others are as they were
    EXPECT_LT(lost.lines.size(), whole.lines.size());
}

TEST(WayDrive, twoTracksOnEqualLinesAreThePlane)
{
    const WayDriveOptions options{.spacing = 0.3, .slipShare = 0.0, .pitchBias = 0.02};
    const DriveLines plane = driven(step(), options).drive;
    const DriveLines both = driven(GroundLines(step()), options).drive;
    EXPECT_FALSE(both.onePlane);
    ASSERT_EQ(plane.lines.size(), both.lines.size());
    for (std::size_t i = 0; i < plane.lines.size(); ++i) {
        const DriveLine &expected = plane.lines[i], &line = both.lines[i];
        ASSERT_EQ(line.isScene, expected.isScene);
        EXPECT_EQ(line.line.time, expected.line.time);
        EXPECT_NEAR(line.line.pitch, expected.line.pitch, 1e-5);
        EXPECT_NEAR(*line.line.travelled, *expected.line.travelled, 1e-4);
        EXPECT_NEAR(line.line.force[5], expected.line.force[5], 0.02);
        for (std::size_t bin = 0; line.isScene && bin < kBins; ++bin)
            for (const std::size_t side : {0U, 1U})
                EXPECT_NEAR(*line.truth[side][bin], *expected.truth[side][bin], 1e-4);
    }
}

TEST(WayDrive, pitchBiasIsInReadingsAlone)
{
    const DriveLines plain = driven(step(), {.spacing = 0.4}).drive;
    const DriveLines tilted = driven(step(), {.spacing = 0.4, .pitchBias = 0.03}).drive;
    ASSERT_EQ(plain.lines.size(), tilted.lines.size());
    for (std::size_t i = 0; i < plain.lines.size(); ++i) {
        EXPECT_NEAR(tilted.lines[i].line.pitch, plain.lines[i].line.pitch + 0.03, 1e-12);
        EXPECT_EQ(tilted.lines[i].truth, plain.lines[i].truth);
    }
}

TEST(WayDrive, seedDecidesEverything)
{
    const SensorNoise noise;
    EXPECT_EQ(driven(step(), {}, noise, 3).drive, driven(step(), {}, noise, 3).drive);
    EXPECT_NE(driven(step(), {}, noise, 3).drive, driven(step(), {}, noise, 4).drive);
}

TEST(WayDrive, stopsWithoutRestPoseAreCounted)
{
    const TerrainProfile cliff({{0, 0}, {2.0, 0}, {2.01, -3.0}, {5.0, -3.0}});
    const auto [drive, skipped] = driven(cliff, {.spacing = 0.1});
    EXPECT_GT(skipped, 0);
    EXPECT_EQ(ofKind(drive, true).size() + static_cast<std::size_t>(skipped),
              stopsOver(cliff, 0.1).size());
}

TEST(WayDrive, refusesWhatItDoesNotKnow)
{
    for (const WayDriveOptions& wrong :
         {WayDriveOptions{.spacing = -1.0}, WayDriveOptions{.step = 0.0},
          WayDriveOptions{.slipShare = -0.1}, WayDriveOptions{.driveSlip = -0.1},
          WayDriveOptions{.pressShare = 1.1}, WayDriveOptions{.pressTorque = -1.0},
          WayDriveOptions{.gap = -1.0}})
        EXPECT_THROW((void)driven(flatTerrain(4.0), wrong), std::invalid_argument);
    std::mt19937_64 rng(1);
    int skipped = 0;
    EXPECT_THROW((void)driveWay(absolem(), step(), "1", {}, {}, {.slide = 0.05}, rng, skipped),
                 std::invalid_argument);
}

}  // namespace
}  // namespace terratact
