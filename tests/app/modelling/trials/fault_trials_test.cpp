#include "app/modelling/trials/fault_trials.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/absolem.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Returns twenty errors of this size [m], of which so many lie in the 80 % band.
FaultCounts countsWith(double error, std::size_t inBand)
{
    FaultCounts counts;
    for (std::size_t k = 0; k < 20; ++k) {
        BinError one;
        one.error = error;
        one.scores.in80 = k < inBand;
        counts.errors.push_back(one);
    }
    return counts;
}

TEST(FaultTrials, aFaultHarmsByErrorOrByCoverage)
{
    const FaultCounts sound = countsWith(0.010, 20);
    EXPECT_FALSE(harms(sound, sound));
    EXPECT_FALSE(harms(countsWith(0.014, 19), sound));
    EXPECT_TRUE(harms(countsWith(0.016, 20), sound));
    EXPECT_TRUE(harms(countsWith(0.010, 17), sound));
}

TEST(FaultTrials, aFaultIsFlaggedInNineOfTen)
{
    FaultCounts counts;
    counts.scenes = 20;
    counts.drives = 10;
    counts.doubted = 17;
    counts.seconds.assign(8, 1.0);
    EXPECT_FALSE(isFlagged(counts));
    counts.doubted = 18;
    EXPECT_TRUE(isFlagged(counts));
    counts.doubted = 0;
    counts.seconds.assign(9, 1.0);
    EXPECT_TRUE(isFlagged(counts));
}

TEST(FaultTrials, theMedianCountsDrivesWithoutDetection)
{
    EXPECT_EQ(medianOfDrives({3.0, 1.0, 2.0}, 3), 2.0);
    EXPECT_EQ(medianOfDrives({3.0, 1.0, 2.0}, 5), 3.0);
    EXPECT_EQ(medianOfDrives({2.0, 1.0}, 4), 2.0);
    EXPECT_FALSE(medianOfDrives({2.0, 1.0}, 5).has_value());
    EXPECT_FALSE(medianOfDrives({}, 0).has_value());
    EXPECT_EQ(sharePercent(1, 4), 25.0);
    EXPECT_EQ(sharePercent(0, 0), 0.0);
}

/// Level profiles of 3 m and of 7 m: too short to come back kMinWayBack, and long enough.
struct LevelGround : testing::Test {
    LevelGround()
    {
        trial.grounds.terrain = directory.write("profiles.csv", "0,0,0,0\n0,0,0,0,0,0,0,0\n");
        trial.grounds.step = 1.0;
        trial.spacing = 1.0;
    }
    TemporaryDirectory directory;
    FaultTrial trial;
};

TEST_F(LevelGround, drivesThatDoNotComeBackAreLeftOut)
{
    const auto there = driveForFaults(absolem(), trial);
    ASSERT_TRUE(there) << there.error().text;
    EXPECT_EQ(there->drives.size(), 2U);
    EXPECT_EQ(there->leftOut, 0U);
    trial.comesBack = true;
    const auto back = driveForFaults(absolem(), trial);
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->drives.size(), 1U);
    EXPECT_EQ(back->leftOut, 1U);
    EXPECT_GE(wayBack(back->drives[0]), kMinWayBack);
}

TEST_F(LevelGround, aTrialNeedsADriveAndItsFile)
{
    trial.comesBack = true;
    trial.grounds.terrain = directory.write("short.csv", "0,0,0,0\n");
    const auto none = driveForFaults(absolem(), trial);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text.find("no drive came back"), std::string::npos);
    trial.grounds.terrain = directory.file("absent.csv");
    EXPECT_TRUE(refused(driveForFaults(absolem(), trial), trial.grounds.terrain, {}));
}

TEST_F(LevelGround, everySceneWithAWildPitchIsDoubted)
{
    const auto opened =
        openEstimatorBundle(absolem(), TERRATACT_SOURCE_DIR "/resources/models/default.ttm", {});
    ASSERT_TRUE(opened) << opened.error().text;
    const EstimatorBundle& bundle = **opened;
    const auto driven = driveForFaults(bundle.robot, trial);
    ASSERT_TRUE(driven) << driven.error().text;
    const WatchedDrives& drives = driven->drives;
    const FaultCounts sound = tryFault({"", "none", ""}, trial, bundle, drives);
    const FaultCounts wild =
        tryFault({"out-of-range:pitch", "pitch out of range", ""}, trial, bundle, drives);
    EXPECT_GT(sound.scenes, 0U);
    EXPECT_EQ(sound.errors.size(), sound.scenes * kBins) << "every true height is known";
    EXPECT_EQ(wild.scenes, sound.scenes);
    EXPECT_EQ(wild.suspects, wild.scenes);
    EXPECT_EQ(wild.doubted, wild.scenes);
    EXPECT_TRUE(wild.trustedErrors.empty());
    EXPECT_EQ(wild.seconds.size(), drives.size());
    EXPECT_TRUE(isFlagged(wild));
    EXPECT_EQ(noticedPercent("out-of-range:pitch", bundle.robot, drives), 100.0);
}

}  // namespace
}  // namespace terratact
