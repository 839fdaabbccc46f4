// Session files: estimates of two sides are read back, and sides that cannot be are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/log/rows/session_tables.h"
#include "core/log/session_reader.h"
#include "core/log/session_writer.h"
#include "tests/core/log/session_fixture.h"
#include "tests/support/sessions/sessions.h"

namespace terratact {
namespace {

TEST_F(Session, keepsBothSidesOfAnEstimate)
{
    EstimateRow sides = someSides(3, 600'000'001);
    ProposalRow proposal = someProposal(600'000'002);
    proposal.id = 2;
    proposal.estimate = 3;
    proposal.side = ProbeSide::Right;
    proposal.offers = {{9, 0.5, 0.3, ProbeSide::Right}, {9, 0.2, 0.4, ProbeSide::Left}};
    SceneRow scene = someScene(3, 600'000'000);
    scene.sideTruth = {{stepEstimate().height, Heights{}}};
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(scene));
    ASSERT_TRUE(writer->add(sides));
    ASSERT_TRUE(writer->add(proposal));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_EQ(reader->scenes().back(), scene);
    EXPECT_EQ(reader->proposals().back(), proposal);
    EstimateRow read = reader->estimates().back();
    setDraws(read.estimate, *reader->draws(3));
    EXPECT_EQ(read, sides);
    EXPECT_TRUE(reader->estimate(1)->estimate.onePlane);
    EXPECT_FALSE(reader->verify().broken);
}

TEST_F(Session, keepsWhichFeaturesASideLacks)
{
    SceneRow scene = someScene(3, 600'000'000);
    SideForces front;
    front.left.fill(1.0);
    setSides(scene.measurement, front);
    EstimateRow sides = someSides(3, 600'000'001);
    for (TerrainEstimate& side : sides.estimate.side) side.settings.method = Method::Local;
    for (std::size_t e = 0; e < kForceElements; ++e)
        sides.estimate.side[1].missing[kFirstForceFeature + e] = true;
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(scene));
    ASSERT_TRUE(writer->add(sides));
    ASSERT_TRUE(writer->seal());
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    for (const std::size_t side : {0U, 1U})
        EXPECT_EQ(reader->estimates().back().estimate.side.at(side).missing,
                  sides.estimate.side.at(side).missing);
}

/// Returns why the writer refuses a row; empty if it does not.
std::string refusalOf(SessionWriter& writer, const EstimateRow& row)
{
    try {
        (void)writer.add(row);
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

TEST_F(Session, refusesSidesThatContradictEachOther)
{
    auto writer = someSession(path, 100);
    ASSERT_TRUE(writer) << writer.error().text;
    ASSERT_TRUE(writer->add(someScene(3, 600'000'000)));
    const auto refusalAfter = [&](const auto& change) {
        EstimateRow row = someSides(3, 600'000'001);
        change(row.estimate);
        return refusalOf(*writer, row);
    };
    using Estimate = TwoTrackEstimate;
    EXPECT_EQ(refusalAfter([](Estimate& e) { e.onePlane = true; }),
              "SessionWriter: estimate 3: both sides of one plane must be equal");
    EXPECT_EQ(refusalAfter([](Estimate& e) { e.side[1].draws.pop_back(); }),
              "SessionWriter: estimate 3: both sides must have the same number of draws");
    EXPECT_EQ(refusalAfter([](Estimate& e) { e.side[1].settings.seed = 1; }),
              "SessionWriter: estimate 3: both sides must have the same settings");
    EXPECT_NE(refusalAfter([](Estimate& e) { e.side[1].draws[0][0] = std::nan(""); }), "");
    EXPECT_EQ(refusalAfter([](Estimate&) {}), "");
}

TEST_F(Session, refusesStoredSidesThatCannotBe)
{
    const struct {
        const char *sql, *complaint;
    } cases[]{
        {"UPDATE estimate SET one_plane = 0 WHERE id = 1",
         "row 1 of its table estimate: columns of the right side are expected for two sides, and "
         "none for one plane"},
        {"UPDATE estimate SET one_plane = 1 WHERE id = 2",
         "row 2 of its table estimate: columns of the right side are expected for two sides, and "
         "none for one plane"},
        {"UPDATE estimate SET right_messages = NULL WHERE id = 2", "row 2 of its table estimate"},
        {"UPDATE estimate_bin SET side = 'left' WHERE id = 3",
         "row 3 of its table estimate_bin: bins of one plane are expected to be of both sides"},
        {"UPDATE estimate_bin SET side = 'both' WHERE id = 12", "row 12 of its table estimate_bin"},
        {"UPDATE estimate_bin SET side = 'middle' WHERE id = 12", "an unknown name"},
        {"UPDATE proposal_offer SET side = 'top' WHERE id = 1",
         "row 1 of its table proposal_offer: an unknown name"},
        {"UPDATE scene_truth SET side = 'both' WHERE id = 1",
         "row 1 of its table scene_truth: an unknown name"},
    };
    for (const auto& [sql, complaint] : cases) {
        const std::string found = complaintsAfter(path, sql);
        EXPECT_NE(found.find(complaint), std::string::npos) << sql << ": " << found;
        std::filesystem::remove(path);
    }
    EXPECT_EQ(complaintsAfter(path, "SELECT 1"), "");
}

TEST_F(Session, drawsOfTwoSidesAreReadInPairs)
{
    seal(path, 200);
    change(path, "UPDATE estimate_draws SET draws = substr(draws, 1, 88 * 3) WHERE id = 2");
    auto reader = SessionReader::open(path);
    ASSERT_TRUE(reader) << reader.error().text;
    EXPECT_FALSE(reader->draws(2)) << "the hash of the draws does not hold";
    EXPECT_TRUE(reader->draws(1));
    EXPECT_THROW(drawsFrom(std::string(88 * 3, '\0'), false), SqliteError);
    EXPECT_EQ(drawsFrom(std::string(88 * 3, '\0'), true)[1].size(), 3U);
}

}  // namespace
}  // namespace terratact
