#include "app/modelling/evaluation/evaluation_report.h"

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

BinError errorOf(std::size_t scene, const std::string& label, int bin, double error, bool inBand,
                 Origin origin)
{
    BinError e{.scene = scene, .label = label, .bin = bin, .error = error, .origin = origin};
    e.scores = {.crps = 0.01, .pit = 0.25, .in80 = inBand, .in95 = true, .width = 0.1};
    return e;
}

const std::vector<BinError> kErrors{errorOf(0, "pa", 0, -0.0125, true, Origin::Sampled),
                                    errorOf(1, "pa", 0, 0.03, false, Origin::Contact),
                                    errorOf(1, "pafac", 10, 0.25, true, Origin::Arm)};

TEST(ErrorsCsv, hasOneRowPerError)
{
    EXPECT_EQ(
        errorsCsv(kErrors, twoScenes()),
        "run,t_s,method,bin_m,error_m,abs_error_m,in_band,source,crps_m,pit,in_50,in_95,width_m,"
        "novelty\n"
        "a,1.5,pa,-0.3,-0.0125,0.0125,1,sampled,0.010000,0.250000,0,1,0.100000,\n"
        "b,0,pa,-0.3,0.03,0.03,0,contact,0.010000,0.250000,0,1,0.100000,\n"
        "b,0,pafac,+0.7,0.25,0.25,1,arm,0.010000,0.250000,0,1,0.100000,\n");
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
              "method,bin_m,n,q1_m,median_m,q3_m,mean_m,coverage,sampled,sampled_coverage,crps_m\n"
              "pa,-0.3,2,0.016875,0.021250,0.025625,0.021250,0.5000,1,1.0000,0.010000\n"
              "pafac,+0.7,1,0.250000,0.250000,0.250000,0.250000,1.0000,0,,0.010000\n");
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

TEST(PitCsv, endsAtOne)
{
    EXPECT_EQ(pitCsv(pitHistograms(std::span(kErrors).first(2), 2)), "method,from,to,count,share\n"
                                                                     "pa,0,0.5,2,1.000000\n"
                                                                     "pa,0.5,1,0,0.000000\n");
}

TEST(CoverageCsv, hasOneRowPerBinAndOneForAll)
{
    EXPECT_EQ(coverageCsv(summarise(std::span(kErrors).first(2))),
              "method,bin_m,n,in_50,in_80,in_95,width_m\n"
              "pa,-0.3,2,0.0000,0.5000,1.0000,0.100000\n"
              "pa,all,2,0.0000,0.5000,1.0000,0.100000\n");
}

const std::vector<Confidence> kConfidences{
    {.label = "pa",
     .drives = 6,
     .intervals = ScoreIntervals{{0.01, 0.03}, {0.011, 0.031}, {0.005, 0.02}, {0.4, 0.6}, {0, 1}}}};

TEST(Scores, haveIntervalsWhereThereAreEnoughDrives)
{
    const auto summaries = summarise(kErrors);
    const std::vector<MethodTime> times{{"pafac", 0.0125}};
    const std::string csv = scoresCsv(summaries, kConfidences, times);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "method,n,drives,near_median_m,near_median_low_m,near_median_high_m,median_m,"
              "median_low_m,median_high_m,mean_m,mean_low_m,mean_high_m,crps_m,crps_low_m,"
              "crps_high_m,coverage,coverage_low,coverage_high,coverage_50,coverage_95,width_m,"
              "scene_s");
    EXPECT_NE(csv.find("\npa,2,6,0.021250,0.000000,1.000000,0.021250,0.010000,0.030000,0.021250,"
                       "0.011000,0.031000,0.010000,0.005000,0.020000,0.500000,0.400000,0.600000,"
                       "0.0000,1.0000,0.100000,0.000000\n"),
              std::string::npos);
    EXPECT_NE(csv.find("\npafac,1,0,0.000000,,,0.250000,,,"), std::string::npos);
    const std::string table = scoresTable(summaries, kConfidences, times);
    EXPECT_NE(table.find("21.2 [10.0, 30.0]"), std::string::npos) << table;
    EXPECT_NE(table.find("50 [40, 60]"), std::string::npos);
    EXPECT_NE(table.find("12.5\n"), std::string::npos);
}

TEST(CoverageTable, hasARowPerBin)
{
    const std::string table = coverageTable(summarise(kErrors));
    EXPECT_NE(table.find("-0.3                             50 %              -\n"),
              std::string::npos)
        << table;
}

TEST(Groups, areWrittenOnceAndQuotedIfNeeded)
{
    std::vector<GroupSummary> groups(2);
    groups[0] = {.group = "steps, high", .label = "pa", .scenes = 3};
    groups[0].all.n = 30;
    groups[0].all.median = 0.012;
    groups[0].all.coverage = 0.75;
    groups[1] = groups[0];
    groups[1].label = "flat";
    EXPECT_EQ(groupsCsv("class", groups),
              "class,method,scenes,n,median_m,mean_m,crps_m,coverage\n"
              "\"steps, high\",pa,3,30,0.012000,0.000000,0.000000,0.7500\n"
              "\"steps, high\",flat,3,30,0.012000,0.000000,0.000000,0.7500\n");
    EXPECT_EQ(
        groupsTable("class", groups),
        "By class: |error| and CRPS [mm], how often the 80 % band covers\n"
        "class                     method        scenes   median     mean     CRPS   covers\n"
        "steps, high               pa                 3     12.0      0.0      0.0     75 %\n"
        "                          flat               3     12.0      0.0      0.0     75 %\n");
    groups[0].group = "steps\nforged";
    EXPECT_NE(groupsTable("class", groups).find("\nsteps?forged  "), std::string::npos);
}

TEST(Steps, haveTheirScoreAndTheReliabilityOfEachClass)
{
    BrierSummary b;
    b.label = "pa";
    b.place = StepPlace::Ahead;
    b.n = 20;
    b.observedShare = 0.25;
    b.score = 0.125;
    b.interval = Interval{0.1, 0.2};
    b.classes[3] = {20, 0.34, 0.4};
    EXPECT_EQ(reliabilityCsv(std::vector{b}),
              "method,place,from,to,n,mean_forecast,observed_share\n"
              "pa,ahead,0.3,0.4,20,0.3400,0.4000\n");
    BrierSummary few = b;
    few.interval.reset();
    EXPECT_EQ(brierCsv(std::vector{b, few}),
              "method,place,n,observed_share,brier,brier_low,brier_high,reliability,resolution,"
              "uncertainty\n"
              "pa,ahead,20,0.250000,0.125000,0.100000,0.200000,0.000000,0.000000,0.000000\n"
              "pa,ahead,20,0.250000,0.125000,,,0.000000,0.000000,0.000000\n");
    const std::string table = stepsTable(std::vector{b}, 0.1);
    EXPECT_NE(table.find("step of more than 100 mm"), std::string::npos);
    EXPECT_NE(table.find("0.125 [0.100, 0.200]"), std::string::npos);
    EXPECT_NE(table.find("0.3 - 0.4     0.34 0.40    20\n"), std::string::npos) << table;
    EXPECT_NE(table.find("0.4 - 0.5                   -\n"), std::string::npos);
}

TEST(Probes, showTheGainOfOneAndTheNumberNeeded)
{
    ProbeSummary p;
    p.label = std::string("pafc");
    p.rule = std::string("sd");
    p.scenes = 4;
    p.probed = 3;
    p.before = {0.1, 0.05};
    p.after = {0.04, 0.03};
    p.settled = 1;
    p.probesNeeded = 2.5;
    EXPECT_EQ(probesCsv(std::vector{p}),
              "method,rule,scenes,probed,ahead_before_m,ahead_after_m,all_before_m,all_after_m,"
              "probes_needed,settled\n"
              "pafc,sd,4,3,0.100000,0.040000,0.050000,0.030000,2.5000,1\n");
    const std::string table = probesTable(std::vector{p}, {});
    EXPECT_NE(table.find("below 60 mm (at most 4)"), std::string::npos);
    EXPECT_NE(table.find("100.0 to 40.0"), std::string::npos);
    EXPECT_NE(table.find("2.50      25 %\n"), std::string::npos) << table;
}

TEST(ClaimsText, showsTheVerdictAndItsEvidence)
{
    ClaimResult clear{.claim = kClaims[0], .verdict = ClaimVerdict::Holds, .n = 60, .runs = 12};
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
