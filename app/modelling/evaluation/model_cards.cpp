#include "app/modelling/evaluation/model_cards.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/text.h"
#include "core/infer/verdict/obstacle.h"
#include "core/learn/model/surface_rows.h"
#include "core/store/file_read.h"

namespace terratact {
namespace {

constexpr std::time_t kLastSecond = 253'402'300'799;  // end of the year 9999

/// Returns $SOURCE_DATE_EPOCH [s since 1970] (reproducible-builds.org); empty if unset or invalid.
std::optional<std::time_t> sourceDateEpoch()
{
    const char* const set = std::getenv("SOURCE_DATE_EPOCH");
    if (!set) return std::nullopt;
    const auto seconds = integerFrom<std::time_t>(set);
    return seconds && *seconds >= 0 && *seconds <= kLastSecond ? seconds : std::nullopt;
}

std::string nameOf(const std::string& path)
{
    return cardText(std::filesystem::path(path).filename().string());
}

}  // namespace

ModelFacts factsOf(const std::string& path, const StoredModel& model)
{
    ModelFacts facts{.path = path,
                     .contentHash = model.contentHash,
                     .dataHash = model.data.dataHash,
                     .command = model.data.command,
                     .scenes = model.data.heights.rows(),
                     .ground = trainingGround(
                         model.data.heights(completeRows(model.data), Eigen::all), kStepLimit),
                     .card = {},
                     .trouble = {}};
    auto card = readModelCard(path, model.contentHash);
    if (!card)
        facts.trouble = card.error().message;
    else if (*card)
        facts.card = *std::move(*card);
    return facts;
}

std::string dateOfToday()
{
    const std::time_t seconds = sourceDateEpoch().value_or(
        std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", parts.tm_year + 1900,
                       parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

Status checkCardReplaceable(const std::string& modelPath)
{
    const std::string card = cardPath(modelPath);
    std::error_code unknown;
    if (!std::filesystem::exists(card, unknown)) return Done{};
    constexpr std::size_t kMaxCardBytes = std::size_t{1} << 20U;
    const auto text = readFile(card, kMaxCardBytes);
    if (text && modelCardFrom(card, *text)) return Done{};
    return fileError(card, "is no model card, and the new model's would replace it: move it, or "
                           "name another --out");
}

Status writeNewCard(const std::string& modelPath, const ModelData& model,
                    const std::string& dataPath, const ChosenMixes& mixes)
{
    return writeModelCard(modelPath,
                          {.model = contentHash(model),
                           .trained = dateOfToday(),
                           .terrain = dataPath.empty() ? std::string() : nameOf(dataPath),
                           .mix = mixes.tracks,
                           .planeMix = mixes.plane,
                           .scores = {}});
}

Status keepScores(const std::string& modelPath, const std::string& contentHash,
                  const std::string& dataPath, const std::string& dataHash,
                  std::vector<CardScores> scores)
{
    auto found = readModelCard(modelPath, contentHash);
    if (!found) return found.error();
    ModelCard card = found->value_or(ModelCard{});
    card.model = contentHash;
    for (CardScores& one : scores) {
        one.date = dateOfToday();
        one.data = nameOf(dataPath);
        one.dataHash = dataHash;
        addScores(card, std::move(one));
    }
    return writeModelCard(modelPath, card);
}

}  // namespace terratact
