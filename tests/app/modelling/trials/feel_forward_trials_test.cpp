#include "app/modelling/trials/feel_forward_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace terratact {
namespace {

const EstimatorBundle& shippedBundle()
{
    static const auto bundle =
        openEstimatorBundle(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml",
                            TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
    return **bundle;
}

std::size_t sumOfEnds(const FeelForwardCounts& counts)
{
    std::size_t sum = 0;
    for (const auto& [end, count] : counts.ends) sum += count;
    return sum;
}

TEST(FeelForwardTrials, theDrivesCoverEveryHazardGroundAndKind)
{
    std::set<std::size_t> grounds;
    std::set<Hazard> plane, tracks;
    bool withoutHazard = false;
    for (const FeelForwardDrive& drive : feelForwardDrives(50, true)) {
        grounds.insert(drive.ground);
        withoutHazard = withoutHazard || !drive.hazard;
        if (drive.hazard) (drive.tracks ? tracks : plane).insert(*drive.hazard);
    }
    EXPECT_EQ(grounds.size(), kHazardGrounds.size());
    EXPECT_EQ(plane.size(), kHazards.size());
    EXPECT_EQ(tracks.size(), kHazards.size());
    EXPECT_TRUE(withoutHazard);
    EXPECT_TRUE(std::ranges::none_of(feelForwardDrives(50, false), &FeelForwardDrive::tracks));
}

TEST(FeelForwardTrials, neitherFallsNorCollides)
{
    FeelForwardTrial trial;
    FeelForwardCounts all;
    for (const FeelForwardDrive& drive :
         {FeelForwardDrive{.ground = 0, .hazard = Hazard::Drop},
          FeelForwardDrive{.ground = 3, .hazard = Hazard::Wall},
          FeelForwardDrive{
              .ground = 1, .hazard = Hazard::Drop, .tracks = true, .onBothSides = false}})
        all += feelForwardOnce(shippedBundle(), trial, drive, 7);
    EXPECT_EQ(all.drives, 3U);
    EXPECT_EQ(all.falls, 0U);
    EXPECT_EQ(all.collisions, 0U);
    EXPECT_EQ(all.touches, 0U);
    EXPECT_EQ(all.beforeHazard + all.atEnd, 3U) << "each drive came to its hazard or to the end";
    EXPECT_EQ(all.presses, all.advances + sumOfEnds(all));
    EXPECT_NEAR(all.advanced, 0.1 * static_cast<double>(all.advances), 0.01);
    EXPECT_TRUE(all.failures.empty());
}

TEST(FeelForwardTrials, aBlindLoopFallsAndCollides)
{
    FeelForwardTrial trial;
    trial.isBlind = true;
    const auto blind = [&](Hazard hazard) {
        return feelForwardOnce(shippedBundle(), trial, {.ground = 0, .hazard = hazard}, 7);
    };
    const FeelForwardCounts drop = blind(Hazard::Drop);
    EXPECT_EQ(drop.falls, 1U) << feelForwardTable(std::vector{FeelForwardLine{"drop", drop}},
                                                  shippedBundle().robot, trial);
    const FeelForwardCounts wall = blind(Hazard::Wall);
    EXPECT_GT(wall.touches, 0U) << "the raised flippers meet the wall first";
    EXPECT_GT(wall.metresPerMinute(), 0.0);
}

TEST(FeelForwardTrials, theTableHasARowForEachKindAndAReasonForEachEnd)
{
    FeelForwardLine all{"all", {}};
    all.counts.drives = 1;
    all.counts.ends[LoopEnd::Undecided] = 3;
    const std::string text = feelForwardTable(std::vector{all}, shippedBundle().robot, {});
    EXPECT_NE(text.find("time model: flippers"), std::string::npos);
    EXPECT_NE(text.find("     3  CANNOT TELL: what was felt does not decide"), std::string::npos);
}

}  // namespace
}  // namespace terratact
