// Tests what the operator reads about a model.
#include "app/mission/text/model_text.h"

#include <gtest/gtest.h>

#include <string>

namespace terratact {
namespace {

ModelFacts facts()
{
    ModelFacts facts;
    facts.path = "/models/mine.ttm";
    facts.contentHash = std::string(64, 'c');
    facts.dataHash = std::string(64, 'd');
    facts.command = "terratact train";
    facts.scenes = 1200;
    facts.ground = {.stepShare = 0.25, .relief = 0.3};
    facts.card.trained = "2026-11-22T07:05:00Z";
    facts.card.terrain = "drive.csv";
    return facts;
}

CardScores scores(const std::string& dataHash, std::size_t trainingScenes = 0)
{
    return {.method = "local",
            .date = "2026-11-23T07:05:00Z",
            .data = "test.csv",
            .dataHash = dataHash,
            .scenes = 90,
            .trainingScenes = trainingScenes,
            .meanError = 0.0214,
            .coverage = 0.79};
}

TEST(ModelTexts, nameTheTrainingDataOfAModel)
{
    const QString card = ModelWords::card(facts());
    EXPECT_TRUE(card.startsWith("/models/mine.ttm\ntrained 2026-11-22; ground: drive.csv\n"))
        << card.toStdString();
    EXPECT_TRUE(card.contains("1200 scenes, 25 % with a step above 0.10 m; median relief 0.30 m"));
    EXPECT_TRUE(card.contains("never evaluated: its errors are unknown"));
}

TEST(ModelTexts, scoresOnTrainingScenesAreMarked)
{
    ModelFacts some = facts();
    some.card.scores = {scores(std::string(64, 'e'))};
    const QString fair = ModelWords::card(some);
    EXPECT_TRUE(fair.contains("local: mean error 21.4 mm, the 80 % band holds 79 %"))
        << fair.toStdString();
    EXPECT_FALSE(fair.contains("trained on"));
    some.card.scores = {scores(some.dataHash)};
    EXPECT_TRUE(ModelWords::card(some).contains("the scenes it was trained on"));
    some.card.scores = {scores(std::string(64, 'e'), 40)};
    EXPECT_TRUE(ModelWords::card(some).contains("40 of them are training scenes or near copies"));
}

TEST(ModelTexts, aModelWithoutACardIsUnknown)
{
    ModelFacts some = facts();
    some.card = {};
    some.trouble = Message::verbatim("mine.card.toml: line 3");
    const QString card = ModelWords::card(some);
    EXPECT_TRUE(card.contains("trained unknown; ground: unknown")) << card.toStdString();
    EXPECT_TRUE(card.contains("its card is not used: mine.card.toml: line 3"));
}

}  // namespace
}  // namespace terratact
