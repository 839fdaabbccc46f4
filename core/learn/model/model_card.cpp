#include "core/learn/model/model_card.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/robot/toml_section.h"
#include "core/store/file_read.h"
#include "core/store/file_write.h"
#include "core/terrain/step.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxCardText = 100;
constexpr double kMaxEvaluated = 1e9;
constexpr double kMaxError = 10.0;  // [m]: heights are within ±5 m

/// Returns true for a date such as "0000-00-00T00:00:00Z", with digits only in place of the zeros.
bool isDate(const std::string& text)
{
    constexpr std::string_view kForm = "dddd-dd-ddTdd:dd:ddZ";
    return std::equal(text.begin(), text.end(), kForm.begin(), kForm.end(), [](char c, char form) {
        return form == 'd' ? c >= '0' && c <= '9' : c == form;
    });
}

bool isHash(const std::string& text)
{
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool isMethod(const std::string& text)
{
    return text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
}

std::string checked(TomlSection& section, std::string_view key, bool (*holds)(const std::string&),
                    SourceText refusal)
{
    std::string text = section.text(key);
    if (holds(text)) return text;
    throw TomlRefused{
        Message(refusal, tomlLine(section.node(key)), section.path(key), shown(text))};
}

CardScores scoresFrom(TomlSection& section)
{
    CardScores scores;
    scores.method = checked(section, "method", isMethod,
                            TR_NOOP("core", "%1: %2 is not the name of a method: %3"));
    scores.date = checked(section, "date", isDate,
                          TR_NOOP("core", "%1: %2 is not a date such as 2026-11-22T07:05:00Z: %3"));
    scores.data = section.text("data");
    scores.dataHash =
        checked(section, "data_sha256", isHash, TR_NOOP("core", "%1: %2 is not a SHA-256: %3"));
    scores.scenes = static_cast<std::size_t>(section.number("scenes", {1.0, kMaxEvaluated}));
    if (section.has("training_scenes"))
        scores.trainingScenes =
            static_cast<std::size_t>(section.number("training_scenes", {1.0, kMaxEvaluated}));
    scores.meanError = section.number("mean_error_m", {0.0, kMaxError});
    scores.coverage = section.number("coverage_80", {0.0, 1.0});
    return scores;
}

CardMix mixFrom(TomlSection& section)
{
    CardMix mix{.weight = section.number("weight", {0.0, 1.0}),
                .heldOut = section.text("held_out")};
    const std::string path = section.path("mean_errors_m");
    const toml::array& trials = tomlArray(section.node("mean_errors_m"), path, 1, kMaxMixTrials);
    mix.trials.reserve(trials.size());
    for (const toml::node& node : trials) {
        const toml::array& pair = tomlArray(node, path, 2, 2);
        mix.trials.push_back(
            {tomlNumber(pair[0], path, {0.0, 1.0}), tomlNumber(pair[1], path, {0.0, kMaxError})});
    }
    return mix;
}

void readCard(TomlSection& file, ModelCard& card)
{
    card.model = checked(file, "model", isHash, TR_NOOP("core", "%1: %2 is not a SHA-256: %3"));
    if (file.has("trained"))
        card.trained =
            checked(file, "trained", isDate,
                    TR_NOOP("core", "%1: %2 is not a date such as 2026-11-22T07:05:00Z: %3"));
    if (file.has("terrain")) card.terrain = file.text("terrain");
    if (file.has("generated"))
        file.section("generated", [&](TomlSection& section) { card.mix = mixFrom(section); });
    if (file.has("generated_planes"))
        file.section("generated_planes",
                     [&](TomlSection& section) { card.planeMix = mixFrom(section); });
    if (!file.has("evaluation")) return;
    for (const toml::node& node :
         tomlArray(file.node("evaluation"), "evaluation", 1, kMaxCardScores)) {
        const toml::table* const table = node.as_table();
        if (!table)
            throw TomlRefused{
                Message(TR_NOOP("core", "%1: %2 is not a table"), tomlLine(node), "evaluation")};
        TomlSection section(*table, "evaluation.");
        card.scores.push_back(scoresFrom(section));
        section.refuseUnknown();
    }
}

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string mixSection(const char* name, const CardMix& mix)
{
    std::string errors;
    for (const CardMix::Trial& trial : mix.trials)
        errors += (errors.empty() ? "[[" : ", [") + numberText(trial.weight) + ", "
                + numberText(trial.meanError) + ']';
    return std::string("\n[") + name + "]\nweight = " + numberText(mix.weight)
         + "\nheld_out = " + quoted(mix.heldOut) + "\nmean_errors_m = " + errors + "]\n";
}

std::string textOf(const ModelCard& card)
{
    std::string text =
        "# Of the model beside it: when and on what it was trained, and how it did.\nmodel = "
        + quoted(card.model) + '\n';
    const auto line = [&text](const char* key, const std::string& value) {
        text.append(key).append(" = ").append(value).append("\n");
    };
    if (!card.trained.empty()) line("trained", quoted(card.trained));
    if (!card.terrain.empty()) line("terrain", quoted(card.terrain));
    if (card.mix) text += mixSection("generated", *card.mix);
    if (card.planeMix) text += mixSection("generated_planes", *card.planeMix);
    for (const CardScores& scores : card.scores) {
        text += "\n[[evaluation]]\n";
        line("method", quoted(scores.method));
        line("date", quoted(scores.date));
        line("data", quoted(scores.data));
        line("data_sha256", quoted(scores.dataHash));
        line("scenes", std::to_string(scores.scenes));
        if (scores.trainingScenes > 0)
            line("training_scenes", std::to_string(scores.trainingScenes));
        line("mean_error_m", numberText(scores.meanError));
        line("coverage_80", numberText(scores.coverage));
    }
    return text;
}

}  // namespace

std::string cardPath(const std::string& modelPath)
{
    return std::filesystem::path(modelPath).replace_extension(".card.toml").string();
}

Result<ModelCard> modelCardFrom(const std::string& name, const std::string& text)
{
    ModelCard card;
    const Status read = readToml(name, text, [&card](TomlSection& file) { readCard(file, card); });
    if (!read) return read.error();
    return card;
}

Result<std::optional<ModelCard>> readModelCard(const std::string& modelPath,
                                               const std::string& contentHash)
{
    const std::string path = cardPath(modelPath);
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown) && !unknown) return std::optional<ModelCard>();
    ModelCard card;
    const Status read = readTomlFile(path, [&card](TomlSection& file) { readCard(file, card); });
    if (!read) return read.error();
    if (card.model != contentHash)
        return fileError(
            path,
            Message(TR_NOOP("core",
                            "is the card of another model: of content %1, and the model's is %2"),
                    card.model.substr(0, 16), contentHash.substr(0, 16)));
    return std::optional(std::move(card));
}

Status writeModelCard(const std::string& modelPath, const ModelCard& card)
{
    const std::string path = cardPath(modelPath);
    const std::string text = textOf(card);
    if (const auto again = modelCardFrom(path, text); !again) return again.error();
    return writeFileAtomically(path, text, Access::Everybody);
}

void addScores(ModelCard& card, CardScores scores)
{
    std::erase_if(card.scores, [&scores](const CardScores& old) {
        return old.method == scores.method && old.dataHash == scores.dataHash;
    });
    card.scores.push_back(std::move(scores));
    if (card.scores.size() > kMaxCardScores) card.scores.erase(card.scores.begin());
}

std::string cardText(std::string_view words)
{
    std::string out(words.substr(0, kMaxCardText));
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return out.empty() ? "unnamed" : out;
}

TrainingGround trainingGround(const Eigen::MatrixXd& heights, double stepLimit)
{
    if (heights.rows() < 1 || heights.cols() != kBins)
        throw std::invalid_argument("trainingGround: no heights");
    const Eigen::Index rows = heights.rows();
    Eigen::Index stepped = 0;
    for (Eigen::Index row = 0; row < rows; ++row) {
        Heights h{};
        for (int i = 0; i < kBins; ++i) h[static_cast<std::size_t>(i)] = heights(row, i);
        if (hasStep(h, stepLimit)) ++stepped;
    }
    Eigen::VectorXd relief = heights.rowwise().maxCoeff() - heights.rowwise().minCoeff();
    const auto middle = relief.begin() + rows / 2;
    std::nth_element(relief.begin(), middle, relief.end());
    return {static_cast<double>(stepped) / static_cast<double>(rows), *middle};
}

}  // namespace terratact
