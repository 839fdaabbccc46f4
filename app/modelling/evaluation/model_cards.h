#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/model_card.h"

namespace terratact {

/// Facts about a model, including its card.
struct ModelFacts {
    std::string path;
    std::string contentHash;
    std::string dataHash;  ///< SHA-256 of the training scenes
    std::string command;   ///< command that trained it
    long scenes = 0;       ///< number of training scenes
    TrainingGround ground;
    ModelCard card;
    Message trouble;  ///< reason that the card is not used; empty: usable, or no card

    bool learntFrom(const CardScores& scores) const { return scores.dataHash == dataHash; }
};

/// Returns a model's facts, with the card beside the file at `path`.
ModelFacts factsOf(const std::string& path, const StoredModel& model);

/// Returns today's UTC date for a card: that of $SOURCE_DATE_EPOCH if set, else of the clock.
std::string dateOfToday();

/// Weights of generated scenes that a training chose; empty: it did not choose.
struct ChosenMixes {
    std::optional<CardMix> tracks{}, plane{};
};

/// Checks that the file in the place of a new model's card is a card, or that there is none. Errors name it.
Status checkCardReplaceable(const std::string& modelPath);

/// Writes the card of a new model. dataPath: its training scenes; empty if unknown.
Status writeNewCard(const std::string& modelPath, const ModelData& model,
                    const std::string& dataPath, const ChosenMixes& mixes = {});

/// Adds scores to the model's card, or creates the card. It fills in date (today), data (file name of dataPath) and
/// dataHash (hash of the scenes as read).
Status keepScores(const std::string& modelPath, const std::string& contentHash,
                  const std::string& dataPath, const std::string& dataHash,
                  std::vector<CardScores> scores);

}  // namespace terratact
