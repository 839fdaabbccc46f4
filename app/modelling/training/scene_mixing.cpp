#include "app/modelling/training/scene_mixing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace terratact {
namespace {

constexpr std::size_t kMostFolds = 4;

/// Returns the mean |error| of a weight over all folds; empty if one of them cannot be trained.
template <class SceneType>
std::optional<double> mixError(const std::vector<SceneType>& real, const HeldOutFolds& folds,
                               const std::vector<SceneType>& generated, double weight,
                               const MixJudge<SceneType>& judge)
{
    double sum = 0.0;
    std::size_t bins = 0;
    for (std::size_t fold = 0; fold < folds.count; ++fold) {
        std::vector<SceneType> learnt, judged;
        for (std::size_t i = 0; i < real.size(); ++i)
            (folds.of[i] == fold ? judged : learnt).push_back(real[i]);
        const std::vector<double> errors = judge(mixedScenes(learnt, generated, weight), judged);
        if (errors.empty()) return std::nullopt;
        sum = std::accumulate(errors.begin(), errors.end(), sum);
        bins += errors.size();
    }
    return sum / static_cast<double>(bins);
}

}  // namespace

template <class SceneType>
std::vector<SceneType> mixedScenes(const std::vector<SceneType>& real,
                                   const std::vector<SceneType>& generated, double weight)
{
    std::vector<SceneType> mixed = real;
    for (std::size_t i = 0; i < generated.size(); ++i)
        if (std::floor(weight * static_cast<double>(i + 1))
            > std::floor(weight * static_cast<double>(i)))
            mixed.push_back(generated[i]);
    return mixed;
}

template <class SceneType>
HeldOutFolds heldOutFolds(const std::vector<SceneType>& real,
                          const std::vector<std::size_t>& filesBegin)
{
    HeldOutFolds folds{.of = std::vector<std::size_t>(real.size())};
    if (filesBegin.size() > 1) {
        folds.count = filesBegin.size();
        for (std::size_t i = 0; i < real.size(); ++i)
            folds.of[i] = static_cast<std::size_t>(std::ranges::upper_bound(filesBegin, i)
                                                   - filesBegin.begin() - 1);
        folds.by = fmt::format("{} files", folds.count);
        return folds;
    }
    std::map<std::string, std::size_t> runs;  // in the order of the scenes
    for (const SceneType& scene : real) runs.try_emplace(scene.run, runs.size());
    folds.count = std::min(kMostFolds, runs.size() > 1 ? runs.size() : real.size());
    for (std::size_t i = 0; i < real.size(); ++i)
        folds.of[i] =
            runs.size() > 1 ? runs.at(real[i].run) % folds.count : i * folds.count / real.size();
    folds.by = runs.size() == 1 ? fmt::format("{} parts of one run", folds.count)
             : runs.size() == folds.count
                 ? fmt::format("{} runs", folds.count)
                 : fmt::format("{} groups of {} runs", folds.count, runs.size());
    return folds;
}

template <class SceneType>
Result<CardMix> chooseMix(const std::vector<SceneType>& real, const HeldOutFolds& folds,
                          const std::vector<SceneType>& generated,
                          const std::type_identity_t<MixJudge<SceneType>>& judge)
{
    CardMix mix{.heldOut = folds.by};
    double least = INFINITY;
    for (const double weight : kMixWeights) {
        const auto error = mixError(real, folds, generated, weight, judge);
        if (!error) continue;
        mix.trials.push_back({weight, *error});
        if (*error > least) continue;
        least = *error;
        mix.weight = weight;
    }
    if (mix.trials.empty())
        return Error{fmt::format("are too few to hold {} out, with any weight of generated scenes",
                                 folds.by),
                     0};
    return mix;
}

template std::vector<Scene> mixedScenes(const std::vector<Scene>&, const std::vector<Scene>&,
                                        double);
template HeldOutFolds heldOutFolds(const std::vector<Scene>&, const std::vector<std::size_t>&);
template Result<CardMix> chooseMix(const std::vector<Scene>&, const HeldOutFolds&,
                                   const std::vector<Scene>&, const MixJudge<Scene>&);
template std::vector<TwoTrackScene> mixedScenes(const std::vector<TwoTrackScene>&,
                                                const std::vector<TwoTrackScene>&, double);
template HeldOutFolds heldOutFolds(const std::vector<TwoTrackScene>&,
                                   const std::vector<std::size_t>&);
template Result<CardMix> chooseMix(const std::vector<TwoTrackScene>&, const HeldOutFolds&,
                                   const std::vector<TwoTrackScene>&,
                                   const MixJudge<TwoTrackScene>&);

std::string mixText(const CardMix& mix, std::string_view of)
{
    std::string text =
        fmt::format("{}mean |error| on real scenes, held out in {}\n", of, mix.heldOut);
    for (const CardMix::Trial& trial : mix.trials)
        text += fmt::format("  generated scenes with weight {:<4}  {:6.1f} mm{}\n", trial.weight,
                            1000.0 * trial.meanError, trial.weight == mix.weight ? "  chosen" : "");
    return text;
}

}  // namespace terratact
