#include "app/modelling/trials/strip_trials.h"

#include <gtest/gtest.h>

#include "app/modelling/simulation/driven_grounds.h"

namespace terratact {
namespace {

TEST(StripTrials, aTableNamesPlacesAndErrorsInMillimetres)
{
    StripFindings findings{.drives = 2, .scenes = 9, .way = 4.25, .results = {}};
    StripResult result{.name = "the newest", .stretch = {}};
    result.stretch[3] = {.bins = 70, .median = 0.0123, .mean = 0.0456, .in80 = 0.815, .width = 0.1};
    findings.results.push_back(result);
    const std::string table = stripTable(findings);
    EXPECT_EQ(table.substr(0, table.find('\n')), "2 drives of 4.2 m on average, 9 scenes");
    EXPECT_NE(table.find("behind, -0.3 m and further        70    12.3    45.6    81.5   100.0\n"),
              std::string::npos)
        << table;
    EXPECT_EQ(table.find("ahead"), std::string::npos) << "a place without bins has no row";
}

TEST(StripTrials, aTableComparesLaterTouchesWithTheTruth)
{
    StripFindings findings{.drives = 1, .scenes = 2, .way = 1.0, .results = {}};
    EXPECT_EQ(stripTable(findings).find("later touches"), std::string::npos);
    const HeightBand said{0.0, 0.01, -0.0128, 0.0128};
    for (const double felt : {0.0, 0.0, 0.0, 0.03})
        findings.ledger.add(ScoredBy::Pass, said, felt, 0.0);
    findings.inTruth[static_cast<std::size_t>(ScoredBy::Pass)] = 2;
    const std::string table = stripTable(findings);
    EXPECT_NE(table.find("pass                               4    75.0    50.0    0.75    1.50\n"),
              std::string::npos)
        << table;
    EXPECT_EQ(table.find("contact"), std::string::npos) << "no touch, no row";
}

TEST(DrivenGrounds, randomOnesDependOnTheSeedAlone)
{
    const auto some = drivenGrounds({.seed = 3}, 2), same = drivenGrounds({.seed = 3}, 2);
    ASSERT_TRUE(some && same);
    ASSERT_EQ(some->size(), 2U);
    EXPECT_EQ((*some)[1].points(), (*same)[1].points());
    EXPECT_NE((*some)[0].points(), (*some)[1].points());
    EXPECT_FALSE(drivenGrounds({.terrain = "/nowhere.csv"}, 2));
}

}  // namespace
}  // namespace terratact
