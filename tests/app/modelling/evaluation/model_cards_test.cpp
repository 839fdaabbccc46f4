// Tests the card beside a model: its date, its scores, and a card of another model.
#include "app/modelling/evaluation/model_cards.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "core/learn/model/file/model_file.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

struct CardOfAModel : testing::Test {
    CardOfAModel() { ::setenv("SOURCE_DATE_EPOCH", "1793000000", 1); }
    ~CardOfAModel() override { ::unsetenv("SOURCE_DATE_EPOCH"); }

    TemporaryDirectory directory;
    std::string path = directory.file("mine.ttm");
    StoredModel model = *readModel(TERRATACT_SOURCE_DIR "/resources/models/default.ttm");
};

TEST_F(CardOfAModel, isDatedReproducibly)
{
    EXPECT_EQ(dateOfToday(), "2026-10-26T07:33:20Z");
    for (const char* wrong : {"-1", "soon", "99999999999999"}) {
        ::setenv("SOURCE_DATE_EPOCH", wrong, 1);
        EXPECT_NE(dateOfToday().substr(0, 2), "19") << "the clock is used: " << wrong;
        EXPECT_EQ(dateOfToday().size(), 20U);
    }
}

TEST_F(CardOfAModel, namesTheTrainingFileWithoutItsFolder)
{
    ASSERT_TRUE(writeNewCard(path, model.data, "/somebody/drive.csv"));
    const ModelFacts facts = factsOf(path, model);
    EXPECT_EQ(facts.trouble.english(), "");
    EXPECT_EQ(facts.card.terrain, "drive.csv");
    EXPECT_EQ(facts.card.trained, "2026-10-26T07:33:20Z");
    EXPECT_GT(facts.scenes, 100);
}

TEST_F(CardOfAModel, keepsTheNewestScoresOfAFile)
{
    const std::string hash(64, 'd');
    CardScores scores;
    scores.method = "local";
    scores.scenes = 30;
    scores.meanError = 0.02;
    scores.coverage = 0.8;
    ASSERT_TRUE(keepScores(path, model.contentHash, "/a/test.csv", hash, {scores}));
    scores.meanError = 0.03;
    ASSERT_TRUE(keepScores(path, model.contentHash, "/b/test.csv", hash, {scores}));
    const ModelFacts facts = factsOf(path, model);
    ASSERT_EQ(facts.card.scores.size(), 1U);
    EXPECT_EQ(facts.card.scores[0].meanError, 0.03);
    EXPECT_EQ(facts.card.scores[0].data, "test.csv");
    EXPECT_FALSE(facts.learntFrom(facts.card.scores[0]));
    CardScores own = facts.card.scores[0];
    own.dataHash = model.data.dataHash;
    EXPECT_TRUE(facts.learntFrom(own));
}

TEST_F(CardOfAModel, ofAnotherModelIsNotUsed)
{
    const std::string other(64, 'e');
    ASSERT_TRUE(keepScores(path, other, "a.csv", std::string(64, 'd'), {}));
    const ModelFacts facts = factsOf(path, model);
    EXPECT_FALSE(facts.trouble.empty());
    EXPECT_TRUE(facts.card.model.empty());
    EXPECT_FALSE(keepScores(path, model.contentHash, "a.csv", std::string(64, 'd'), {}))
        << "it is not overwritten";
}

}  // namespace
}  // namespace terratact
