#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/model/model.h"

namespace terratact {

/// Accuracy of a model with one method, on scenes whose terrain is known.
struct CardScores {
    std::string method;              ///< its name
    std::string date;                ///< date of the evaluation, as in ModelCard
    std::string data;                ///< name of the scenes file
    std::string dataHash;            ///< SHA-256 of that file, hex
    std::size_t scenes = 0;          ///< number of estimated scenes
    std::size_t trainingScenes = 0;  ///< evaluated scenes of its training, or near copies
    double meanError = 0.0;          ///< [m] mean |height − truth| over all bins
    double coverage = 0.0;           ///< 0 … 1: share of truths within the 80 % band
    bool operator==(const CardScores&) const = default;
};

/// How much of the generated scenes a training kept beside real ones. The error on held-out real scenes chose
/// it.
struct CardMix {
    struct Trial {
        double weight = 0.0;     ///< 0 … 1: share of the generated scenes
        double meanError = 0.0;  ///< [m] mean |height − truth| on the held-out scenes
        bool operator==(const Trial&) const = default;
    };
    double weight = 0.0;          ///< the chosen one
    std::string heldOut{};        ///< what was held out in turn, such as "2 files"
    std::vector<Trial> trials{};  ///< 1 to kMaxMixTrials
    bool operator==(const CardMix&) const = default;
};
inline constexpr std::size_t kMaxMixTrials = 16;

/// Model card: facts about a model that its file does not hold. They do not affect predictions, or
/// are known later. It is a file beside the model, whose bytes and hash do not change.
struct ModelCard {
    std::string model;    ///< contentHash() of its model
    std::string trained;  ///< "2026-11-22T07:05:00Z"; empty: unknown
    std::string terrain;  ///< terrain of the training; empty: unknown
    /// Generated scenes of two tracks, and of one plane; empty: the training did not choose.
    std::optional<CardMix> mix{}, planeMix{};
    std::vector<CardScores> scores;  ///< oldest first, one per method and scenes file
    bool operator==(const ModelCard&) const = default;
};

inline constexpr std::size_t kMaxCardScores = 32;

/// Returns "models/default.card.toml" for "models/default.ttm".
std::string cardPath(const std::string& modelPath);

/// Reads the card beside a model; empty if there is none. Errors name the card and the cause.
/// Causes: no TOML, a missing, unknown or duplicate key, an invalid date, hash, method or number.
/// It may also have more than kMaxCardScores scores, or belong to a model with another content than
/// `contentHash`.
Result<std::optional<ModelCard>> readModelCard(const std::string& modelPath,
                                               const std::string& contentHash);

/// Reads the same from a text; errors call it `name`.
Result<ModelCard> modelCardFrom(const std::string& name, const std::string& text);

/// Writes the card beside the model. Errors as readModelCard for a card that it would refuse, or
/// name the file that cannot be written.
Status writeModelCard(const std::string& modelPath, const ModelCard& card);

/// Adds scores. They replace older ones of the same method and scenes file; the oldest are dropped
/// beyond kMaxCardScores.
void addScores(ModelCard& card, CardScores scores);

/// Returns a text from a user, such as a file name, in the form of a card. It has at most 100
/// printable ASCII characters; others become '?'. An empty text becomes "unnamed".
std::string cardText(std::string_view words);

/// Statistics of a model's training ground.
struct TrainingGround {
    double stepShare = 0.0;  ///< 0 … 1: share of scenes with a step (hasStep) above the limit
    double relief = 0.0;     ///< median over scenes of highest − lowest bin [m]
};

/// Returns the statistics. heights: U × 11 [m]. stepLimit: [m]. Throws std::invalid_argument unless
/// U ≥ 1.
TrainingGround trainingGround(const Eigen::MatrixXd& heights, double stepLimit);

}  // namespace terratact
