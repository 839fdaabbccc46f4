#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "app/commands.h"
#include "app/parallel.h"
#include "app/progress.h"
#include "core/file_read.h"
#include "core/learn/clearance_conditionals.h"
#include "core/learn/clearance_training.h"
#include "core/learn/model_file.h"
#include "core/learn/scene_file.h"
#include "core/learn/sha256.h"
#include "core/learn/training.h"
#include "core/robot/robot_model.h"

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

void trainClearances(ModelData& model, const RobotModel& robot, std::uint64_t seed)
{
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, robot);
    prepareClearance(model, ceilings);
    TrainingOptions options;
    options.subset = 800;
    options.seed = seed;
    std::vector<TrainedSurface> trained(std::size_t{2} * kBins);
    Progress progress("training surface", 2 * kBins);
    parallelFor(2 * kBins, [&](int job) {
        trained[static_cast<std::size_t>(job)] =
            trainSurface(model, ceilings, job % kBins, job < kBins, options);
        progress.tick();
    });
    for (int job = 0; job < 2 * kBins; ++job)
        store(model, trained[static_cast<std::size_t>(job)], job % kBins, job < kBins);
    finishClearance(model, ceilings, robot);
}

/// The conditionals over clearances, wherever a regime has enough rows.
void trainClearanceConditionals(ModelData& model, const RobotModel& robot, std::uint64_t seed)
{
    const ClearanceTraining training = clearanceTraining(model, robot);
    const ClearanceConditionalData data = prepareClearanceConditionals(training);
    TrainingOptions options;
    options.seed = seed;
    Progress progress("training clearance", 2 * kBins);
    parallelFor(2 * kBins, [&](int job) {
        const int bin = job % kBins;
        const Regime regime = job < kBins ? Regime::Covered : Regime::Open;
        if (data.at(bin, regime).rows >= kFewestTrainingRows) {
            ClearanceData& clearance = model.clearance;
            auto& hypers = regime == Regime::Covered ? clearance.conditionalCovered
                                                     : clearance.conditionalOpen;
            hypers[static_cast<std::size_t>(bin)] =
                trainClearanceConditional(training, data, bin, regime, options).hyper;
        }
        progress.tick();
    });
}

}  // namespace

Status train(const TrainOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const std::string& notice : file->notices) fmt::print(stderr, "terratact: {}\n", notice);
    const auto bytes = readFile(options.data, kMostBytes);
    if (!bytes) return bytes.error();
    TrainingSet set;
    try {
        set = prepareTraining(file->scenes, {.conditionalRows = options.conditionalRows,
                                             .scannerSd = options.scannerSd,
                                             .seed = options.seed});
    } catch (const std::invalid_argument& error) {
        return fileError(options.data, error.what());
    }
    if (set.leftOut > 0)
        fmt::print(stderr, "terratact: {} scenes with unknown values left out\n", set.leftOut);
    set.model.seed = options.seed;
    set.model.command = options.commandLine;
    set.model.dataHash = sha256Hex(*bytes);
    trainAll(set.model, options.seed);
    trainClearances(set.model, *robot, options.seed);
    trainClearanceConditionals(set.model, *robot, options.seed);
    if (Status written = writeModel(options.out, set.model); !written) return written;
    printBins(set.model);
    fmt::print("a contact counts as a measurement with bias {:.1f} mm, sd {:.1f} mm\n",
               1000.0 * set.model.clearance.contactBias, 1000.0 * set.model.clearance.contactSd);
    fmt::print("{} scenes; 22 Gaussian processes on {} of them, surfaces on all; written to {}\n",
               set.used, set.model.scannedHeights.rows(), options.out);
    return Done{};
}

}  // namespace terratact
