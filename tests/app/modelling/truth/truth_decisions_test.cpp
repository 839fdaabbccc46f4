// Tests a person's decisions on heights of laser clouds.
#include "app/modelling/truth/truth_decisions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/modelling/truth/laser_truth_report.h"
#include "app/modelling/truth/truth_slice.h"
#include "core/terrain/bins.h"
#include "tests/support/absolem.h"
#include "tests/support/made_truth.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

/// Two scenes of two tracks, all bins known at −0.2 m.
LaserTruth twoScenes()
{
    LaserTruth truth{.robot = absolem()};
    for (const char* run : {"a", "b"}) {
        TwoTrackScene scene{.run = run, .time = 1.0, .s = {}, .truth = {}};
        SceneTruth found;
        found.gap = TruthGap::None;
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t bin = 0; bin < kBins; ++bin) {
                scene.truth.at(side).at(bin) = -0.2;
                scene.truthSd.at(side).at(bin) = 0.01;
                found.side.at(side).at(bin) = {.height = -0.2, .sd = 0.01};
            }
        truth.tracks.push_back(scene);
        truth.truths.push_back(found);
    }
    return truth;
}

struct DecisionFile : testing::Test {
    std::string write(const std::string& rows) const
    {
        return directory.write("decisions.csv", "row,run,decision,offset_m,tilt_rad\n" + rows);
    }
    TemporaryDirectory directory;
};

TEST_F(DecisionFile, excludedSceneLosesItsHeights)
{
    const std::string path = write("2,b,exclude,,\n");
    const auto decisions = readTruthDecisions(path);
    ASSERT_TRUE(decisions) << decisions.error().text;
    LaserTruth truth = twoScenes();
    ASSERT_TRUE(applyTruthDecisions(truth, *decisions, path));
    EXPECT_EQ(truth.knownHeights(), 22U);
    EXPECT_EQ(truth.count(TruthGap::Excluded), 1U);
    EXPECT_TRUE(truth.tracks[0].truth[1][10]);
    EXPECT_FALSE(truth.tracks[1].truth[0][0]);
    EXPECT_FALSE(truth.tracks[1].truthSd[0][0]);
    EXPECT_FALSE(truth.truths[1].side[1][5].height);
}

TEST_F(DecisionFile, nudgeMovesHeightsAndSlice)
{
    const std::string path = write("1,,accept,0.01,0.05\n");
    const auto decisions = readTruthDecisions(path);
    ASSERT_TRUE(decisions) << decisions.error().text;
    LaserTruth truth = twoScenes();
    ASSERT_TRUE(applyTruthDecisions(truth, *decisions, path));
    for (const int bin : {0, 3, 10}) {
        const double wanted = -0.2 + 0.01 + std::tan(0.05) * binCentre(bin);
        EXPECT_NEAR(*truth.tracks[0].truth[0].at(static_cast<std::size_t>(bin)), wanted, 1e-12);
        EXPECT_NEAR(*truth.truths[0].side[1].at(static_cast<std::size_t>(bin)).height, wanted,
                    1e-12);
        EXPECT_EQ(*truth.tracks[1].truth[0].at(static_cast<std::size_t>(bin)), -0.2);
    }
    EXPECT_NEAR(truth.truths[0].correction.offset, 0.01, 1e-12);
    EXPECT_NEAR(truth.truths[0].correction.tiltX, std::tan(0.05), 1e-12);
}

TEST_F(DecisionFile, nudgeAlongSamplesTheHeightsAgain)
{
    LaserTruth truth = madeTruth(directory, 4);
    const auto before = truth.truths;
    const std::vector<SlicePoint> slice = truthSlice(truth, 0);
    const std::string path = directory.write(
        "along.csv",
        "row,run,decision,offset_m,tilt_rad,along_m\n1,a,accept,0.01,,-0.1\n2,,accept,,,0.04\n");
    const auto decisions = readTruthDecisions(path);
    ASSERT_TRUE(decisions) << decisions.error().text;
    ASSERT_TRUE(applyTruthDecisions(truth, *decisions, path));
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t bin = 0; bin < kBins; ++bin) {
            const BinTruth& moved = truth.truths[0].side.at(side).at(bin);
            ASSERT_TRUE(moved.height) << bin;
            EXPECT_NEAR(*moved.height - 0.01, *before[1].side.at(side).at(bin).height, 0.002)
                << "a robot 0.1 m ahead, as in the next scene, saw bin " << bin << " so";
            EXPECT_EQ(*truth.tracks[0].truth.at(side).at(bin), *moved.height);
            EXPECT_EQ(*truth.tracks[0].truthSd.at(side).at(bin), moved.sd);
            EXPECT_EQ(truth.truths[2].side.at(side).at(bin).height,
                      before[2].side.at(side).at(bin).height);
        }
    const std::vector<SlicePoint> movedSlice = truthSlice(truth, 0);
    const auto step = [](const std::vector<SlicePoint>& points) {
        double x = 9.0;
        for (const SlicePoint& p : points)
            if (p.line == TruthLine::LeftFlippers && p.z > -0.15) x = std::min(x, p.x);
        return x;
    };
    EXPECT_NEAR(step(movedSlice), step(slice) - 0.1, 0.005) << "the sheet shows the moved cloud";
}

TEST_F(DecisionFile, nudgeAlongNeedsWholeCells)
{
    const std::string path = directory.write(
        "along.csv", "row,run,decision,offset_m,tilt_rad,along_m\n1,,accept,,,0.03\n");
    EXPECT_TRUE(refused(readTruthDecisions(path), path,
                        {"line 2: along_m is 0.03, expected a multiple of 0.02"}));
    const std::string far = directory.write(
        "far.csv", "row,run,decision,offset_m,tilt_rad,along_m\n1,,accept,,,0.22\n");
    EXPECT_TRUE(refused(readTruthDecisions(far), far, {"line 2: along_m is 0.22"}));
}

TEST_F(DecisionFile, decisionsOnOtherScenesChangeNothing)
{
    for (const char* const rows :
         {"1,,exclude,,\n3,,exclude,,\n", "1,,exclude,,\n2,a,accept,,\n"}) {
        const std::string path = write(rows);
        const auto decisions = readTruthDecisions(path);
        ASSERT_TRUE(decisions);
        LaserTruth truth = twoScenes();
        const Status done = applyTruthDecisions(truth, *decisions, path);
        EXPECT_TRUE(refused(done, path, {"line 3: row"}));
        EXPECT_EQ(truth.knownHeights(), 44U);
    }
}

TEST_F(DecisionFile, badRowsAreRefusedWithTheirLine)
{
    for (const char* const rows :
         {"0,,exclude,,\n", "1.5,,exclude,,\n", "1,,maybe,,\n", "1,,accept,0.3,\n",
          "1,,accept,,0.2\n", "1,,accept,,\n1,,exclude,,\n"}) {
        const std::string path = write(rows);
        const auto decisions = readTruthDecisions(path);
        ASSERT_FALSE(decisions) << rows;
        EXPECT_NE(decisions.error().text.find("line "), std::string::npos)
            << decisions.error().text;
    }
    EXPECT_FALSE(readTruthDecisions(directory.write("other.csv", "row,decision\n1,accept\n")));
}

}  // namespace
}  // namespace terratact
