#include "core/learn/model/model_card.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kContent(64, 'a');

ModelCard card()
{
    return {.model = kContent,
            .trained = "2026-11-22T07:05:00Z",
            .terrain = "C:\\fields \"behind\" the school",
            .scores = {{.method = "local",
                        .date = "2026-11-23T00:00:59Z",
                        .data = "unseen.csv",
                        .dataHash = std::string(64, 'b'),
                        .scenes = 299,
                        .meanError = 0.1 + 0.2,
                        .coverage = 0.8}}};
}

struct ModelCardFile : testing::Test {
    const TemporaryDirectory dir;
    const std::string model = dir.file("mine.ttm");
    const std::string path = dir.file("mine.card.toml");

    testing::AssertionResult refusesWith(const std::string& from, const std::string& to,
                                         std::initializer_list<std::string_view> parts)
    {
        std::string text = contentOf(path);
        const auto at = text.find(from);
        if (at == std::string::npos) return testing::AssertionFailure() << "no " << from;
        return refused(modelCardFrom(path, text.replace(at, from.size(), to)), path, parts);
    }
};

TEST_F(ModelCardFile, everyCardSurvivesARoundTrip)
{
    ModelCard sent = card();
    sent.mix = CardMix{.weight = 0.25, .heldOut = "2 files", .trials = {{0.0, 0.1}, {0.25, 0.03}}};
    sent.planeMix = CardMix{.weight = 1.0, .heldOut = "3 runs", .trials = {{1.0, 0.02}}};
    for (std::size_t k = 0; k < kMaxCardScores; ++k) {
        ASSERT_TRUE(writeModelCard(model, sent));
        const auto got = readModelCard(model, kContent);
        ASSERT_TRUE(got);
        ASSERT_EQ(*got, sent);
        CardScores more = sent.scores.front();
        more.method += static_cast<char>('a' + k % 26);
        more.dataHash[k] = 'c';
        addScores(sent, more);
    }
    const ModelCard nothingKnown{.model = kContent, .trained = {}, .terrain = {}, .scores = {}};
    ASSERT_TRUE(writeModelCard(model, nothingKnown));
    const auto got = readModelCard(model, kContent);
    ASSERT_TRUE(got);
    EXPECT_EQ(*got, nothingKnown);
}

TEST_F(ModelCardFile, aModelWithoutACardHasNone)
{
    const auto none = readModelCard(model, kContent);
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

TEST_F(ModelCardFile, theCardOfAnotherModelIsRefused)
{
    ASSERT_TRUE(writeModelCard(model, card()));
    EXPECT_TRUE(refused(readModelCard(model, std::string(64, 'd')), path,
                        {"another model", "aaaa", "dddd"}));
}

TEST_F(ModelCardFile, whatNoCardHoldsIsRefused)
{
    ASSERT_TRUE(writeModelCard(model, card()));
    EXPECT_TRUE(refusesWith(kContent, std::string(64, 'A'), {"line 2", "model", "SHA-256"}));
    EXPECT_TRUE(refusesWith("2026-11-22T", "2026-11-2xT", {"line 3", "trained", "date"}));
    EXPECT_TRUE(refusesWith("2026-11-23T", "23.11.2026 ", {"evaluation.date", "date"}));
    EXPECT_TRUE(refusesWith("trained =", "trainde =", {"trainde", "not a known key"}));
    EXPECT_TRUE(refusesWith("scenes = 299", "scenes = 0", {"evaluation.scenes", "0"}));
    EXPECT_TRUE(refusesWith("0.8\n", "1.01\n", {"evaluation.coverage_80", "1.01"}));
    EXPECT_TRUE(refusesWith("0.8\n", "nan\n", {"evaluation.coverage_80"}));
    EXPECT_TRUE(refusesWith("mean_error_m = ", "mean_error_m = -", {"evaluation.mean_error_m"}));
    EXPECT_TRUE(refusesWith("\"local\"", "\"lo cal\"", {"evaluation.method"}));
    EXPECT_TRUE(refusesWith("[[evaluation]]", "[evaluation]", {"evaluation", "array"}));
    EXPECT_TRUE(refusesWith("unseen.csv", "a\\u0007b", {"evaluation.data", "control"}));
}

TEST_F(ModelCardFile, aCardThatWouldBeRefusedIsNotWritten)
{
    ModelCard wrong = card();
    wrong.terrain = "two\nlines";
    EXPECT_FALSE(writeModelCard(model, wrong));
    wrong = card();
    wrong.trained = "yesterday";
    EXPECT_TRUE(refused(writeModelCard(model, wrong), path, {"yesterday"}));
    const auto none = readModelCard(model, kContent);
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

TEST(ModelCard, newScoresReplaceThoseOfTheSameMethodAndScenes)
{
    ModelCard one = card();
    CardScores again = one.scores.front();
    again.meanError = 0.02;
    addScores(one, again);
    ASSERT_EQ(one.scores.size(), 1U);
    EXPECT_EQ(one.scores.front().meanError, 0.02);
    again.method = "joint";
    addScores(one, again);
    EXPECT_EQ(one.scores.size(), 2U);
}

TEST(ModelCard, theOldestScoresMakeRoom)
{
    ModelCard full = card();
    for (std::size_t k = 0; k < kMaxCardScores; ++k) {
        CardScores more = card().scores.front();
        more.dataHash[k] = 'c';
        addScores(full, more);
    }
    ASSERT_EQ(full.scores.size(), kMaxCardScores);
    EXPECT_EQ(full.scores.front().dataHash.front(), 'c');
}

TEST(ModelCard, acceptsAnyTextFromAUser)
{
    EXPECT_EQ(cardText("varied.csv"), "varied.csv");
    EXPECT_EQ(cardText("\xff\n~"), "??~");
    EXPECT_EQ(cardText(std::string(300, 'x')).size(), 100U);
    EXPECT_EQ(cardText(""), "unnamed");
}

TEST(ModelCard, computesTrainingGroundStatistics)
{
    Eigen::MatrixXd heights = Eigen::MatrixXd::Zero(3, kBins);
    heights(0, 4) = 0.30;                 // a post: relief 0.30, steps
    heights.row(1).setLinSpaced(0, 0.4);  // a slope: relief 0.40, 0.04 a bin
    const TrainingGround ground = trainingGround(heights, 0.10);
    EXPECT_DOUBLE_EQ(ground.stepShare, 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(ground.relief, 0.30);
    EXPECT_THROW(static_cast<void>(trainingGround({}, 0.10)), std::invalid_argument);
}

}  // namespace
}  // namespace terratact
