#pragma once

#include <string>

#include "core/base/result.h"
#include "core/learn/model/model_card.h"
#include "core/learn/model/model_file.h"

namespace terratact {

/// What there is to say about a model, its card included.
struct ModelFacts {
    std::string path;
    std::string contentHash;
    std::string dataHash;  ///< of the scenes it was trained on
    std::string command;   ///< that made it
    long scenes = 0;       ///< it was trained on
    TrainingGround ground;
    ModelCard card;
    std::string
        trouble;  ///< why the card beside it says nothing; empty: it is good, or there is none

    bool learntFrom(const CardScores& scores) const { return scores.dataHash == dataHash; }
};

/// With the card beside the file at `path`.
ModelFacts factsOf(const std::string& path, const StoredModel& model);

/// The date in UTC as cards have it: of the environment's SOURCE_DATE_EPOCH where that is set, else now.
std::string dateOfToday();

/// The card of a model just trained; dataPath: its scenes, empty where they are not known.
Status writeNewCard(const std::string& modelPath, const ModelData& model,
                    const std::string& dataPath);

/// Adds to the card of the model, or begins one.  date, data and dataHash of the scores are filled in: today, the
/// file name of dataPath, and the hash that its scenes came with.
Status keepScores(const std::string& modelPath, const std::string& contentHash,
                  const std::string& dataPath, const std::string& dataHash,
                  std::vector<CardScores> scores);

}  // namespace terratact
