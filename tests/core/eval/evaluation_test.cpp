#include "core/eval/evaluation.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

namespace terratact {
namespace {

BinError errorOf(double error, const std::string& label = "pa", int bin = 0, std::size_t scene = 0)
{
    BinError e;
    e.scene = scene;
    e.label = label;
    e.bin = bin;
    e.error = error;
    e.scores.in80 = true;
    return e;
}

TEST(BinErrors, areTakenWhereTheTruthIsKnown)
{
    Scene scene;
    scene.truth[2] = -0.20;
    scene.truth[9] = 0.10;
    TerrainEstimate estimate;
    estimate.novelty = 0.5;
    estimate.mean[2] = -0.27;
    estimate.height[2] = -0.17;
    estimate.q10[2] = -0.19;  // the truth lies 1 cm below the band
    estimate.q90[2] = -0.15;
    estimate.origin[2] = Origin::Contact;
    estimate.height[9] = 0.05;
    estimate.q10[9] = 0.0;
    estimate.q90[9] = 0.10;  // and here on its edge

    const auto errors = binErrors(7, scene, "pafac/b", estimate);
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_EQ(errors[0].scene, 7U);
    EXPECT_EQ(errors[0].label, "pafac/b");
    EXPECT_EQ(errors[0].bin, 2);
    EXPECT_DOUBLE_EQ(errors[0].error, 0.03);
    EXPECT_FALSE(errors[0].scores.in80);
    EXPECT_EQ(errors[0].origin, Origin::Contact);
    EXPECT_EQ(errors[1].bin, 9);
    EXPECT_DOUBLE_EQ(errors[0].scores.width, 0.04);
    EXPECT_EQ(errors[0].novelty, 0.5);
    EXPECT_DOUBLE_EQ(errors[1].error, -0.05);
    EXPECT_TRUE(errors[1].scores.in80);
    EXPECT_EQ(errors[1].origin, Origin::Sampled);
}

TEST(Statistics, useTheErrorsMagnitude)
{
    std::vector<BinError> errors{errorOf(-0.04), errorOf(0.01), errorOf(0.08), errorOf(-0.02)};
    errors[0].scores.in80 = errors[1].scores.in80 = false;
    errors[1].origin = Origin::Contact;
    errors[2].scores = {.crps = 0.04, .in50 = true, .in80 = true, .in95 = true, .width = 0.2};
    errors[0].scores.in95 = true;
    const ErrorStatistics s = statistics(errors);
    EXPECT_EQ(s.n, 4U);
    EXPECT_DOUBLE_EQ(s.q1, 0.0175);
    EXPECT_DOUBLE_EQ(s.median, 0.03);
    EXPECT_DOUBLE_EQ(s.q3, 0.05);
    EXPECT_DOUBLE_EQ(s.mean, 0.0375);
    EXPECT_DOUBLE_EQ(s.coverage, 0.5);
    EXPECT_DOUBLE_EQ(s.coverage50, 0.25);
    EXPECT_DOUBLE_EQ(s.coverage95, 0.5);
    EXPECT_DOUBLE_EQ(s.crps, 0.01);
    EXPECT_DOUBLE_EQ(s.width, 0.05);
    EXPECT_EQ(s.sampled, 3U);
    EXPECT_DOUBLE_EQ(s.sampledCoverage, 2.0 / 3.0);
    EXPECT_EQ(statistics({}).n, 0U);
}

TEST(Summaries, separateMethodsAndBins)
{
    const std::vector<BinError> errors{errorOf(0.05, "pafc", 3), errorOf(0.01, "pa", 3),
                                       errorOf(0.03, "pa", 10)};
    const auto summaries = summarise(errors);
    ASSERT_EQ(summaries.size(), 2U);
    EXPECT_EQ(summaries[0].label, "pafc");
    EXPECT_DOUBLE_EQ(summaries[0].all.median, 0.05);
    EXPECT_EQ(summaries[1].label, "pa");
    EXPECT_DOUBLE_EQ(summaries[1].bin[3].median, 0.01);
    EXPECT_DOUBLE_EQ(summaries[1].bin[10].median, 0.03);
    EXPECT_EQ(summaries[1].bin[5].n, 0U);
    EXPECT_DOUBLE_EQ(summaries[1].all.median, 0.02);
    EXPECT_DOUBLE_EQ(summaries[1].near.median, 0.01);  // without the last two bins
}

TEST(Histograms, countLargeErrorsInTheLastClass)
{
    const std::vector<BinError> errors{errorOf(0.0),  errorOf(-0.009), errorOf(0.011),
                                       errorOf(-0.5), errorOf(0.021),  errorOf(0.03, "pac")};
    const auto found = histograms(errors, 0.01, 3);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].count, (std::vector<std::size_t>{2, 1, 2}));
    EXPECT_EQ(found[0].n, 5U);
    EXPECT_EQ(found[1].label, "pac");
    EXPECT_EQ(found[1].count, (std::vector<std::size_t>{0, 0, 1}));
    EXPECT_THROW(histograms(errors, 0.0, 3), std::invalid_argument);
    EXPECT_THROW(histograms(errors, 0.01, 0), std::invalid_argument);
}

TEST(PitHistograms, haveEqualClassesUpToOne)
{
    std::vector<BinError> errors(5, errorOf(0.0));
    const std::vector<double> pit{0.0, 0.3, 0.6, 0.75, 1.0};
    for (std::size_t k = 0; k < pit.size(); ++k) errors[k].scores.pit = pit[k];
    const auto found = pitHistograms(errors, 4);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].count, (std::vector<std::size_t>{1, 1, 1, 2}));
    EXPECT_DOUBLE_EQ(found[0].width, 0.25);
    EXPECT_THROW(pitHistograms(errors, 0), std::invalid_argument);
}

TEST(Labels, areMethodNamesInOrderOfEvaluation)
{
    const std::vector<BinError> errors{errorOf(0.0, "pafc"), errorOf(0.0, "flat"),
                                       errorOf(0.0, "pafc"), errorOf(0.0, "pa")};
    EXPECT_EQ(labelsOf(errors), (std::vector<std::string>{"pafc", "flat", "pa"}));
    EXPECT_EQ(errorsOf("pafc", errors).size(), 2U);
    EXPECT_EQ(labelOf({.method = Method::Local}), "local");
}

TEST(ErrorsInBins, areThoseListedForTheirScene)
{
    const std::vector<BinError> errors{errorOf(0.01, "pa", 6, 0), errorOf(0.02, "pa", 7, 0),
                                       errorOf(0.03, "pa", 6, 1), errorOf(0.04, "pa", 7, 1)};
    const std::vector<std::vector<int>> bins{{6}, {7, 8}};
    const auto kept = errorsInBins(errors, bins);
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept[0], errors[0]);
    EXPECT_EQ(kept[1], errors[3]);
    EXPECT_THROW(errorsInBins(errors, std::span(bins).first(1)), std::invalid_argument);
}

class FrontFlipper : public testing::Test {
protected:
    std::vector<int> binsAt(double pitch, double front) const
    {
        Proprioception s;
        s.pitch = pitch;
        s.front = front;
        return binsUnderFrontFlipper(robot_, s);
    }

private:
    RobotModel robot_ = *readRobotModel(TERRATACT_SOURCE_DIR "/resources/robots/absolem.toml");
};

TEST_F(FrontFlipper, coversTheBinsOfThePaperWhenItLiesFlat)
{
    EXPECT_EQ(binsAt(0.0, 0.0), (std::vector<int>{6, 7, 8}));  // 0.3, 0.4, 0.5
}

TEST_F(FrontFlipper, coversFewerBinsTheSteeperItStands)
{
    EXPECT_EQ(binsAt(0.0, 1.0), (std::vector<int>{6, 7}));  // tip at 0.25 + 0.319 cos(0.81) + 0.03
    EXPECT_EQ(binsAt(0.0, 0.93), (std::vector<int>{6, 7, 8}));  // 0.5 lies under the tip's circle
    EXPECT_EQ(binsAt(0.0, -1.1), (std::vector<int>{6}));
    // As steep, but the nose up by 0.3 moves the pivot, 0.13 m below the IMU, 3 cm ahead.
    EXPECT_EQ(binsAt(0.3, 0.7), (std::vector<int>{6, 7, 8}));
}

TEST_F(FrontFlipper, coversBinsBehindItsPivotWhenItIsFoldedBack)
{
    EXPECT_EQ(binsAt(0.0, std::numbers::pi), (std::vector<int>{3, 4, 5}));  // 0, 0.1, 0.2
    EXPECT_EQ(binsAt(0.0, 2.605), (std::vector<int>{3, 4, 5}));  // 0 lies under the tip's circle
}

TEST(TruthShare, isTheTruthsPartOfTheSquaredError)
{
    std::vector<BinError> errors(4);
    for (BinError& e : errors) e.error = 0.02;
    EXPECT_EQ(truthShare(errors).measured, 0U);
    EXPECT_EQ(truthShare(errors).share, 0.0);
    errors[0].truthSd = errors[1].truthSd = 0.01;
    const TruthShare share = truthShare(errors);
    EXPECT_EQ(share.n, 4U);
    EXPECT_EQ(share.measured, 2U);
    EXPECT_NEAR(share.sd, 0.01 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(share.share, 0.125, 1e-12);
    EXPECT_EQ(truthShare({}).n, 0U);
}

}  // namespace
}  // namespace terratact
