#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/model/model.h"

namespace terratact {

/// How a model did, with one method, on scenes whose terrain is known.
struct CardScores {
    std::string method;              ///< its name
    std::string date;                ///< of the evaluation, as in ModelCard
    std::string data;                ///< name of the scenes file
    std::string dataHash;            ///< its SHA-256, hex
    std::size_t scenes = 0;          ///< that were estimated
    std::size_t trainingScenes = 0;  ///< of the file's scenes, that the model was trained on
    double meanError = 0.0;          ///< [m] mean |height − truth| over all bins
    double coverage = 0.0;           ///< 0 … 1: truths within the 80 % band
    bool operator==(const CardScores&) const = default;
};

/// What a model's file does not say, because it is known apart from the numbers that predict, or after them.
/// Kept beside the model, whose bytes and hash it leaves alone.
struct ModelCard {
    std::string model;               ///< contentHash() of the model it belongs to
    std::string trained;             ///< "2026-11-22T07:05:00Z"; empty: unknown
    std::string terrain;             ///< that it was trained on; empty: unknown
    std::vector<CardScores> scores;  ///< oldest first, one per method and scenes file
    bool operator==(const ModelCard&) const = default;
};

inline constexpr std::size_t kMaxCardScores = 32;

/// "models/default.ttm": "models/default.card.toml".
std::string cardPath(const std::string& modelPath);

/// The card beside a model; empty where there is none.  Errors name the card and what is wrong: no TOML, a
/// key missing, unknown or doubled, a date, hash, method or number that is none, over kMaxCardScores scores, or the
/// card of a model with other content than `contentHash`.
Result<std::optional<ModelCard>> readModelCard(const std::string& modelPath,
                                               const std::string& contentHash);

/// The same of a text at hand, which errors call `name`.
Result<ModelCard> modelCardFrom(const std::string& name, const std::string& text);

/// Puts the card beside the model.  Errors as of readModelCard for a card it would refuse, or name the file that
/// cannot be written.
Status writeModelCard(const std::string& modelPath, const ModelCard& card);

/// Adds scores in place of older ones of the same method and scenes file; the oldest make room.
void addScores(ModelCard& card, CardScores scores);

/// Somebody's words, such as a file's name, as a card takes them: at most 100 printable characters of ASCII, others
/// as '?'; "unnamed" for none.
std::string cardWords(std::string_view words);

/// What ground a model's training scenes were.
struct TrainingGround {
    double stepShare = 0.0;  ///< 0 … 1: scenes with a step (hasStep) above the limit
    double relief = 0.0;     ///< [m] median over scenes of highest − lowest bin
};

/// heights: U × 11 [m], U ≥ 1, else std::invalid_argument.  stepLimit: [m].
TrainingGround trainingGround(const Eigen::MatrixXd& heights, double stepLimit);

}  // namespace terratact
