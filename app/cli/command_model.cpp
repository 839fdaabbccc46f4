#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/cli/commands.h"
#include "app/modelling/evaluation/model_cards.h"
#include "app/modelling/training/model_conditions.h"
#include "app/modelling/training/scene_mixing.h"
#include "app/runtime/print_text.h"
#include "core/infer/verdict/obstacle.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/gp/projected_process.h"
#include "core/learn/model/bin_models.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/training.h"
#include "core/store/csv_text.h"

namespace terratact {

namespace {

/// Prints every number that predictions need, one per line: set,bin_m,name,value.
void printCsv(const ModelData& model, const BinModelData& data)
{
    const auto inputs = featureNames(data.set);
    const auto columnName = [&](Eigen::Index d) {
        return d < kBins ? fmt::format("h_{:+.1f}_m", binCentre(static_cast<int>(d)))
                         : std::string(inputs[static_cast<std::size_t>(d - kBins)]);
    };
    const auto line = [&](const CsvValue& bin, std::string_view what, double value) {
        printText("{}", Lines(csvLine({name(data.set), bin, what, value})));
    };
    for (Eigen::Index d = 0; d < data.mean.size(); ++d) {
        line("", "mean " + columnName(d), data.mean[d]);
        line("", "sd " + columnName(d), data.sd[d]);
    }
    for (int i = 0; i < kBins; ++i) {
        const Hyperparameters& hyper = data.bins[static_cast<std::size_t>(i)];
        const CsvValue bin = signedTenth(binCentre(i));
        Eigen::Index k = 0;
        for (Eigen::Index d = 0; d < data.mean.size(); ++d)
            if (d != i) line(bin, "length_scale " + columnName(d), hyper.lengthScale[k++]);
        line(bin, "signal_sd_m", hyper.signalSd);
        line(bin, "noise_sd_m", hyper.noiseSd);
        line(bin, "log_likelihood", data.logLikelihood[static_cast<std::size_t>(i)]);
    }
    if (data.set == FeatureSet::Pa) return;
    for (Eigen::Index u = 0; u < model.scannedHeights.rows(); ++u)
        for (Eigen::Index d = 0; d < data.mean.size(); ++d)
            printText("{}", Lines(csvLine({"row", u + 1, columnName(d),
                                           d < kBins ? model.scannedHeights(u, d)
                                                     : model.features(u, d - kBins)})));
}

void printTable(const BinModelData& data)
{
    printText("\n{} models: input in standard deviations; length scale per input and bin\n{:>18}",
              name(data.set), "");
    for (int i = 0; i < kBins; ++i) printText(" {:>+8.1f}", binCentre(i));
    printText("\n");
    const auto inputs = featureNames(data.set);
    for (Eigen::Index d = 0; d < data.mean.size(); ++d) {
        printText("{:>18}", d < kBins ? fmt::format("h_{:+.1f}_m", binCentre(static_cast<int>(d)))
                                      : std::string(inputs[static_cast<std::size_t>(d - kBins)]));
        for (int i = 0; i < kBins; ++i) {
            const Eigen::Index k = d < i ? d : d - 1;
            if (d == i)
                printText(" {:>8}", "-");
            else
                printText(" {:>8.3g}", data.bins[static_cast<std::size_t>(i)].lengthScale[k]);
        }
        printText("\n");
    }
    const auto row = [&](std::string_view what, auto value) {
        printText("{:>18}", what);
        for (std::size_t i = 0; i < kBins; ++i) printText(" {:>8.4g}", value(i));
        printText("\n");
    };
    row("signal sd [m]", [&](std::size_t i) { return data.bins[i].signalSd; });
    row("noise sd [m]", [&](std::size_t i) { return data.bins[i].noiseSd; });
    row("log likelihood", [&](std::size_t i) { return data.logLikelihood[i]; });
}

/// Prints the processes over clearances given s; bins with too few scenes in a regime stay empty.
void printSurfaces(const ClearanceData& data, bool covered)
{
    const auto& processes = covered ? data.covered : data.open;
    printText("\n{}; input in standard deviations; length scale per input and bin\n{:>18}",
              covered ? "clearance under the robot, asinh((ceiling - height) / 10 mm)"
                      : "height where nothing of the robot is above [m]",
              "");
    for (int i = 0; i < kBins; ++i) printText(" {:>+8.1f}", binCentre(i));
    printText("\n");
    const auto row = [&](std::string_view what, auto value) {
        printText("{:>18}", what);
        for (const SurfaceProcess& p : processes)
            printText(" {:>8}", p.weights.size() == 0 ? "-" : fmt::format("{:.4g}", value(p)));
        printText("\n");
    };
    const auto inputs = featureNames(FeatureSet::Paf);
    for (std::size_t d = 0; d < inputs.size(); ++d)
        row(inputs[d], [d](const SurfaceProcess& p) {
            return p.hyper.lengthScale[static_cast<Eigen::Index>(d)];
        });
    row("signal sd", [](const SurfaceProcess& p) { return p.hyper.signalSd; });
    row("noise sd", [](const SurfaceProcess& p) { return p.hyper.noiseSd; });
    row("residual sd", [](const SurfaceProcess& p) { return p.residualSd; });
}

/// Prints the facts that the model's card adds.
void printCard(const ModelFacts& facts)
{
    const auto known = [](const std::string& text) { return text.empty() ? "unknown" : text; };
    printText("trained  {}\nground   {}; {:.0f} % of the scenes with a step above {:.2f} m, "
              "median relief "
              "{:.2f} m\n",
              known(facts.card.trained), known(facts.card.terrain), 100.0 * facts.ground.stepShare,
              kStepLimit, facts.ground.relief);
    if (facts.card.planeMix) printText("{}", Lines(mixText(*facts.card.planeMix, "one plane: ")));
    if (facts.card.mix) printText("{}", Lines(mixText(*facts.card.mix)));
    if (facts.card.scores.empty())
        printText("errors   unknown; `terratact evaluate --card` finds them\n");
    for (const CardScores& s : facts.card.scores)
        printText(
            "errors   {}: mean {:.1f} mm, the 80 % band holds {:.0f} %; {} scenes of {} "
            "({}), {}{}\n",
            s.method, 1000.0 * s.meanError, 100.0 * s.coverage, s.scenes, s.data,
            s.dataHash.substr(0, 16), s.date,
            s.trainingScenes > 0
                ? fmt::format("; {} of them are training scenes or near copies", s.trainingScenes)
                : std::string(facts.learntFrom(s) ? "; the scenes it was trained on" : ""));
    if (!facts.trouble.empty()) printText(stderr, "terratact: {}\n", facts.trouble.english());
}

/// Prints p(hᵢ | h_{J∖i}, s) of every bin, with the other heights taken from the scene.
void printConditionals(const Scene& scene, const BinModels& models)
{
    Heights h{};
    for (std::size_t i = 0; i < kBins; ++i) h[i] = *scene.truth[i];
    const Eigen::VectorXd s = features(models.set(), scene.s);
    for (int i = 0; i < kBins; ++i) {
        const Normal p = models.bin(i).predict(models.input(i, h, s));
        printText("{}", Lines(csvLine({scene.run, scene.time, name(models.set()),
                                       signedTenth(binCentre(i)), p.mean, std::sqrt(p.variance)})));
    }
}

}  // namespace

Status predictConditionals(const std::string& modelPath, const std::string& dataPath)
{
    const auto stored = readModel(modelPath);
    if (!stored) return stored.error();
    const auto file = readScenes(dataPath);
    if (!file) return file.error();
    const BinModels pa(stored->data, FeatureSet::Pa);
    const BinModels paf(stored->data, FeatureSet::Paf);
    printText("run,t_s,set,bin_m,mean_m,sd_m\n");
    int leftOut = 0;
    for (const Scene& scene : file->scenes) {
        if (!isComplete(scene)) {
            ++leftOut;
            continue;
        }
        printConditionals(scene, pa);
        printConditionals(scene, paf);
    }
    if (leftOut > 0)
        printText(stderr, "terratact: {} scenes with unknown values left out\n", leftOut);
    return Done{};
}

Status describeModel(const ModelCardOptions& options)
{
    const auto stored = readModel(options.model);
    if (!stored) return stored.error();
    auto found = readModelCard(options.model, stored->contentHash);
    if (!found) return found.error();
    ModelCard card = found->value_or(ModelCard{});
    card.model = stored->contentHash;
    if (!options.trained.empty()) card.trained = options.trained;
    if (!options.terrain.empty()) card.terrain = options.terrain;
    if (Status written = writeModelCard(options.model, card); !written) return written;
    printCard(factsOf(options.model, *stored));
    return Done{};
}

Status showModel(const std::string& path, bool csv)
{
    const auto stored = readModel(path);
    if (!stored) return stored.error();
    const ModelData& model = stored->data;
    if (csv) {
        printText("set,bin_m,name,value\n");
        printCsv(model, model.pa);
        printCsv(model, model.paf);
        return Done{};
    }
    printText("{}\ncontent  {}\nmade by  {}\nseed     {}\nscenes   {}, {} of them for pa and "
              "paf\ndata     {}\n",
              path, stored->contentHash, model.command, model.seed, model.heights.rows(),
              model.scannedHeights.rows(), model.dataHash);
    if (model.repeats > 0)
        printText("repeats  {} of the scenes measure a place again\n", model.repeats);
    if (model.inducing > 0)
        printText("sparse   pa and paf predict through at most {} scenes\n", model.inducing);
    printCard(factsOf(path, *stored));
    for (const BinModelData* data : {&model.pa, &model.paf}) {
        printTable(*data);
        printText("{}", Lines(conditionsText(model, data->set)));
    }
    printSurfaces(model.clearance, true);
    printSurfaces(model.clearance, false);
    printText(
        "\nthe two above with a jitter of {:.0e} of the signal's variance at the inducing scenes\n",
        kProjectionJitter);
    printText("\ncontact: bias {:.1f} mm, sd {:.1f} mm; novelty scale {:.3f}\n",
              1000.0 * model.clearance.contactBias, 1000.0 * model.clearance.contactSd,
              model.clearance.noveltyScale);
    return Done{};
}

}  // namespace terratact
