// Tests the table of estimates.
#include "app/modelling/estimate_csv.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/estimates.h"

namespace terratact {
namespace {

using Fields = std::vector<std::string>;

/// Returns the fields of each line; no field of these tables holds a comma.
std::vector<Fields> linesOf(const std::string& csv)
{
    std::vector<Fields> lines;
    std::istringstream in(csv);
    for (std::string line; std::getline(in, line);) {
        Fields fields;
        line += ',';
        for (std::size_t at = 0, comma = 0; (comma = line.find(',', at)) != std::string::npos;
             at = comma + 1)
            fields.push_back(line.substr(at, comma - at));
        lines.push_back(fields);
    }
    return lines;
}

struct EstimateTable : testing::Test {
    std::string field(std::size_t bin, const std::string& column) const
    {
        const auto lines = linesOf(estimateCsv({scene}, {result}));
        for (std::size_t i = 0; i < lines.at(0).size(); ++i)
            if (lines[0][i] == column) return lines.at(bin + 1).at(i);
        return "no such column";
    }
    Scene scene{"first", 2.5, {}, {}};
    SceneEstimate result{stepEstimate(), "one, two; \"three\""};
};

TEST_F(EstimateTable, hasARowForEveryBinAsWideAsItsHeading)
{
    const auto lines = linesOf(estimateCsv({scene, scene}, {result, result}));
    ASSERT_EQ(lines.size(), 1U + 2U * kBins);
    for (const Fields& fields : lines) EXPECT_EQ(fields.size(), lines[0].size());
    EXPECT_EQ(field(0, "bin_m"), "-0.3");
    EXPECT_EQ(field(10, "bin_m"), "+0.7");
    EXPECT_EQ(field(8, "source"), name(Origin::Contact));
    EXPECT_EQ(field(9, "sd_m"), "0.09");
    EXPECT_EQ(field(9, "height_m"), "-0.05");
}

TEST_F(EstimateTable, unknownValuesAreEmpty)
{
    scene.truth[3] = -0.25;
    EXPECT_EQ(field(3, "truth_m"), "-0.25");
    EXPECT_EQ(field(4, "truth_m"), "");
    EXPECT_EQ(field(9, "ceiling_m"), "") << "nothing lies above it";
    EXPECT_EQ(field(9, "p_step"), "") << "there are no draws";
}

TEST_F(EstimateTable, stepsAndVerdictFollowFromTheDraws)
{
    result.estimate->draws.assign(500, result.estimate->height);
    EXPECT_EQ(field(7, "p_step"), "1") << "the step of 0.2 m at 0.45 m";
    EXPECT_EQ(field(2, "p_step"), "0");
    EXPECT_EQ(field(0, "draws"), "500");
    EXPECT_EQ(field(0, "verdict"), field(10, "verdict")) << "one for the scene";
    EXPECT_NE(field(0, "verdict"), "");
}

TEST_F(EstimateTable, aSceneWithoutAnEstimateHasAReason)
{
    result = {std::nullopt, "no ground fits: pitch, roll"};
    EXPECT_EQ(field(0, "mean_m"), "");
    EXPECT_EQ(field(0, "note"), "no ground fits: pitch: roll");
    const auto lines = linesOf(estimateCsv({scene}, {result}));
    for (const Fields& fields : lines) EXPECT_EQ(fields.size(), lines[0].size());
}

TEST_F(EstimateTable, aNoteIsDefusedLikeEveryText)
{
    result.note = "read from x;=1+1, y";
    EXPECT_EQ(field(0, "note"), "\"read from x;'=1+1: y\"");
}

TEST_F(EstimateTable, needsOneEstimatePerScene)
{
    EXPECT_THROW((void)estimateCsv({scene, scene}, {result}), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
