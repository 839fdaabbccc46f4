#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "app/commands.h"
#include "app/parallel.h"
#include "app/progress.h"
#include "core/file_read.h"
#include "core/learn/model_file.h"
#include "core/learn/scene_file.h"
#include "core/learn/sha256.h"
#include "core/learn/training.h"

namespace terratact {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

void printBins(const ModelData& model)
{
    fmt::print("{:>6}  {:>22}  {:>22}\n", "bin_m", "noise sd [mm] pa, paf", "log p(y|X) pa, paf");
    for (std::size_t i = 0; i < kBins; ++i)
        fmt::print("{:>+6.1f}  {:>10.2f} {:>10.2f}  {:>11.1f} {:>10.1f}\n",
                   binCentre(static_cast<int>(i)), 1000.0 * model.pa.bins[i].noiseSd,
                   1000.0 * model.paf.bins[i].noiseSd, model.pa.logLikelihood[i],
                   model.paf.logLikelihood[i]);
}

void trainAll(ModelData& model, std::uint64_t seed)
{
    TrainingOptions options;
    options.seed = seed;
    Progress progress("training Gaussian process", 2 * kBins);
    parallelFor(2 * kBins, [&](int job) {
        const FeatureSet set =
            job < kBins ? FeatureSet::Paf : FeatureSet::Pa;  // the larger ones first
        const int bin = job % kBins;
        const TrainedBin trained = trainBin(model, set, bin, options);
        BinModelData& data = set == FeatureSet::Pa ? model.pa : model.paf;
        data.bins[static_cast<std::size_t>(bin)] = trained.hyper;
        data.logLikelihood[static_cast<std::size_t>(bin)] = trained.logLikelihood;
        progress.tick();
    });
}

}  // namespace

Status train(const TrainOptions& options)
{
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const std::string& notice : file->notices) fmt::print(stderr, "terratact: {}\n", notice);
    const auto bytes = readFile(options.data, kMostBytes);
    if (!bytes) return bytes.error();
    TrainingSet set;
    try {
        set = prepareTraining(file->scenes);
    } catch (const std::invalid_argument& error) {
        return fileError(options.data, error.what());
    }
    if (set.leftOut > 0)
        fmt::print(stderr, "terratact: {} scenes with unknown values left out\n", set.leftOut);
    set.model.seed = options.seed;
    set.model.command = options.commandLine;
    set.model.dataHash = sha256Hex(*bytes);
    trainAll(set.model, options.seed);
    if (Status written = writeModel(options.out, set.model); !written) return written;
    printBins(set.model);
    fmt::print("{} scenes, 22 Gaussian processes written to {}\n", set.used, options.out);
    return Done{};
}

}  // namespace terratact
