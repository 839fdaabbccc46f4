#include "app/evaluation_report.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace terratact {
namespace {

std::vector<Scene> twoScenes()
{
    std::vector<Scene> scenes(2);
    scenes[0].run = std::string("a");
    scenes[0].time = 1.5;
    scenes[1].run = std::string("b");
    return scenes;
}

const std::vector<BinError> kErrors{
    {.scene = 0, .method = Method::Pa, .bin = 0, .error = -0.0125, .inBand = true},
    {.scene = 1,
     .method = Method::Pa,
     .bin = 0,
     .error = 0.03,
     .inBand = false,
     .origin = Origin::Contact},
    {.scene = 1,
     .method = Method::Pafac,
     .bin = 10,
     .error = 0.25,
     .inBand = true,
     .origin = Origin::Arm}};

TEST(ErrorsCsv, hasOneRowPerError)
{
    EXPECT_EQ(errorsCsv(kErrors, twoScenes()),
              "run,t_s,method,bin_m,error_m,abs_error_m,in_band,source\n"
              "a,1.5,pa,-0.3,-0.0125,0.0125,1,sampled\n"
              "b,0,pa,-0.3,0.03,0.03,0,contact\n"
              "b,0,pafac,+0.7,0.25,0.25,1,arm\n");
    EXPECT_THROW(errorsCsv(kErrors, {}), std::invalid_argument);
}

TEST(Fig8Csv, hasOneRowPerMethodAndClassTheLastWithoutEnd)
{
    EXPECT_EQ(fig8Csv(histograms(kErrors, 0.01, 3)), "method,from_m,to_m,count,share\n"
                                                     "pa,0,0.01,0,0.000000\n"
                                                     "pa,0.01,0.02,1,0.500000\n"
                                                     "pa,0.02,,1,0.500000\n"
                                                     "pafac,0,0.01,0,0.000000\n"
                                                     "pafac,0.01,0.02,0,0.000000\n"
                                                     "pafac,0.02,,1,1.000000\n");
}

TEST(Fig9Csv, hasOneRowPerMethodAndBinWithErrors)
{
    EXPECT_EQ(fig9Csv(summarise(kErrors)),
              "method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage\n"
              "pa,-0.3,2,0.016875,0.021250,0.025625,0.021250,0.5000,1,1.0000\n"
              "pafac,+0.7,1,0.250000,0.250000,0.250000,0.250000,1.0000,0,\n");
}

TEST(EvaluationTable, namesMethodsBinsAndCoverageInColumnsThatLineUp)
{
    const std::string table = evaluationTable(summarise(kErrors));
    EXPECT_EQ(table, "|error|: median (quartiles) [mm]\n"
                     "bin [m]                            pa          pafac\n"
                     "-0.3                       21 (17–26)              -\n"
                     "-0.2                                -              -\n"
                     "-0.1                                -              -\n"
                     "+0.0                                -              -\n"
                     "+0.1                                -              -\n"
                     "+0.2                                -              -\n"
                     "+0.3                                -              -\n"
                     "+0.4                                -              -\n"
                     "+0.5                                -              -\n"
                     "+0.6                                -              -\n"
                     "+0.7                                -  250 (250–250)\n"
                     "all bins                   21 (17–26)  250 (250–250)\n"
                     "mean |error| [mm]                21.2          250.0\n"
                     "80 % band covers                 50 %          100 %\n"
                     "  sampled bins alone            100 %              -\n"
                     "errors                              2              1\n");
}

TEST(ClaimsText, saysTheVerdictAndWhatItRestsOn)
{
    ClaimResult clear{.claim = kClaims[0], .verdict = Verdict::Holds, .n = 60, .runs = 12};
    clear.baseMedian = 0.010;
    clear.betterMedian = 0.008;
    clear.low = -0.003;
    clear.high = -0.001;
    const ClaimResult few{
        .claim = kClaims[1], .n = 9, .runs = 3, .baseMedian = 0.02, .betterMedian = 0.03};
    const ClaimResult none{.claim = kClaims[2]};
    EXPECT_EQ(claimsText(std::vector{clear, few, none}),
              "1. the body's ceilings improve bins -0.3 to 0.2: holds\n"
              "   median |error| pa 10.0 mm, pac 8.0 mm; difference -2.0 mm, 95 % interval -3.0 … "
              "-1.0; 60 bins of "
              "12 drives\n"
              "2. the flipper forces improve bins 0.3 to 0.5: not decided\n"
              "   median |error| pac 20.0 mm, pafc 30.0 mm; 3 of at least 5 drives\n"
              "3. the arm improves bins 0.6 and 0.7: not decided\n"
              "   no bin was estimated by both pafc and pafac\n");
}

}  // namespace
}  // namespace terratact
