#include "app/modelling/training/scene_mixing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/learn/data/scene_copies.h"

namespace terratact {
namespace {

constexpr std::size_t kMaxFolds = 4;

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
            if (folds.of[i] < folds.count)
                (folds.of[i] == fold ? judged : learnt).push_back(real[i]);
        const std::vector<double> errors = judge(mixedScenes(learnt, generated, weight), judged);
        if (errors.empty()) return std::nullopt;
        sum = std::accumulate(errors.begin(), errors.end(), sum);
        bins += errors.size();
    }
    return sum / static_cast<double>(bins);
}

template <class SceneType>
std::vector<SceneRepeat> repeatsOf(const std::vector<SceneType>& scenes)
{
    SceneRepeats<SceneType> known;
    std::vector<SceneRepeat> repeats;
    repeats.reserve(scenes.size());
    for (const SceneType& scene : scenes)
        repeats.push_back(known.add(scene, static_cast<int>(repeats.size())));
    return repeats;
}

/// Numbers of different labels, in the order in which they come first.
template <class Label>
std::map<Label, std::size_t> numbersOfLabels(const std::vector<Label>& labels)
{
    std::map<Label, std::size_t> numbers;
    for (const Label& label : labels) numbers.try_emplace(label, numbers.size());
    return numbers;
}

/// Returns the folds of scenes of different places. files, runs: of each scene.
HeldOutFolds foldsOfPlaces(const std::vector<std::size_t>& files,
                           const std::vector<std::string>& runs)
{
    const auto fileNumbers = numbersOfLabels(files);
    const auto runNumbers = numbersOfLabels(runs);
    const std::size_t places = files.size(), runCount = runNumbers.size();
    HeldOutFolds folds{.of = std::vector<std::size_t>(places)};
    if (fileNumbers.size() > 1) {
        folds.count = fileNumbers.size();
        for (std::size_t i = 0; i < places; ++i) folds.of[i] = fileNumbers.at(files[i]);
        folds.by = fmt::format("{} files", folds.count);
        return folds;
    }
    folds.count = std::min(kMaxFolds, runCount > 1 ? runCount : places);
    for (std::size_t i = 0; i < places; ++i)
        folds.of[i] =
            runCount > 1 ? runNumbers.at(runs[i]) % folds.count : i * folds.count / places;
    folds.by = runCount == 1           ? fmt::format("{} parts of one run", folds.count)
             : runCount == folds.count ? fmt::format("{} runs", folds.count)
                                       : fmt::format("{} groups of {} runs", folds.count, runCount);
    return folds;
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
    const std::vector<SceneRepeat> repeats = repeatsOf(real);
    std::vector<std::size_t> firsts, files;  // first scenes of all places
    std::vector<std::string> runs;
    for (std::size_t i = 0; i < real.size(); ++i) {
        if (repeats[i].isExact || repeats[i].first != static_cast<int>(i)) continue;
        firsts.push_back(i);
        files.push_back(
            static_cast<std::size_t>(std::ranges::upper_bound(filesBegin, i) - filesBegin.begin()));
        runs.push_back(real[i].run);
    }
    HeldOutFolds folds = foldsOfPlaces(files, runs);
    std::vector<std::size_t> ofAll(real.size(), folds.count);
    for (std::size_t place = 0; place < firsts.size(); ++place)
        ofAll[firsts[place]] = folds.of[place];
    for (std::size_t i = 0; i < real.size(); ++i)
        if (!repeats[i].isExact) ofAll[i] = ofAll[static_cast<std::size_t>(repeats[i].first)];
    folds.of = std::move(ofAll);
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
