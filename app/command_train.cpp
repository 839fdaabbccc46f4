#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "app/commands.h"
#include "app/parallel.h"
#include "app/progress.h"
#include "core/file_read.h"
#include "core/learn/clearance_conditionals.h"
#include "core/learn/clearance_training.h"
#include "core/learn/model_file.h"
#include "core/learn/model_part.h"
#include "core/learn/scene_file.h"
#include "core/learn/sha256.h"
#include "core/learn/training.h"
#include "core/robot/robot_model.h"

namespace terratact {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;
constexpr int kRowsOfSparseSearch = 1400;  // more rows move the hyper-parameters little

void printBins(const ModelData& model, const BinSet& bins)
{
    fmt::print("{:>6}  {:>22}  {:>22}\n", "bin_m", "noise sd [mm] pa, paf", "log p(y|X) pa, paf");
    for (const int bin : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(bin);
        fmt::print("{:>+6.1f}  {:>10.2f} {:>10.2f}  {:>11.1f} {:>10.1f}\n", binCentre(bin),
                   1000.0 * model.pa.bins[i].noiseSd, 1000.0 * model.paf.bins[i].noiseSd,
                   model.pa.logLikelihood[i], model.paf.logLikelihood[i]);
    }
}

/// Job `job` of two per bin, first one kind of all bins, then the other.
struct Jobs {
    std::vector<int> bins;
    int count() const { return 2 * static_cast<int>(bins.size()); }
    bool first(int job) const { return job < static_cast<int>(bins.size()); }
    int bin(int job) const { return bins[static_cast<std::size_t>(job) % bins.size()]; }
};

void trainAll(ModelData& model, const Jobs& jobs, std::uint64_t seed)
{
    TrainingOptions options;
    options.seed = seed;
    if (model.inducing > 0) options.fullRows = kRowsOfSparseSearch;
    Progress progress("training Gaussian process", jobs.count());
    parallelFor(jobs.count(), [&](int job) {
        const FeatureSet set =
            jobs.first(job) ? FeatureSet::Paf : FeatureSet::Pa;  // the larger ones first
        const int bin = jobs.bin(job);
        const TrainedBin trained = trainBin(model, set, bin, options);
        BinModelData& data = set == FeatureSet::Pa ? model.pa : model.paf;
        data.bins[static_cast<std::size_t>(bin)] = trained.hyper;
        data.logLikelihood[static_cast<std::size_t>(bin)] = trained.logLikelihood;
        progress.tick();
    });
}

void trainClearances(ModelData& model, const RobotModel& robot, const Jobs& jobs,
                     std::uint64_t seed)
{
    const Eigen::MatrixXd ceilings = bodyCeilings(model.features, robot);
    prepareClearance(model, ceilings);
    TrainingOptions options;
    options.subset = 800;
    options.seed = seed;
    std::vector<TrainedSurface> trained(static_cast<std::size_t>(jobs.count()));
    Progress progress("training surface", jobs.count());
    parallelFor(jobs.count(), [&](int job) {
        trained[static_cast<std::size_t>(job)] =
            trainSurface(model, ceilings, jobs.bin(job), jobs.first(job), options);
        progress.tick();
    });
    for (int job = 0; job < jobs.count(); ++job)
        store(model, trained[static_cast<std::size_t>(job)], jobs.bin(job), jobs.first(job));
}

/// The conditionals over clearances, wherever a regime has enough rows.
void trainClearanceConditionals(ModelData& model, const RobotModel& robot, const Jobs& jobs,
                                std::uint64_t seed)
{
    const ClearanceTraining training = clearanceTraining(model, robot);
    const ClearanceConditionalData data = prepareClearanceConditionals(training);
    TrainingOptions options;
    options.seed = seed;
    Progress progress("training clearance", jobs.count());
    parallelFor(jobs.count(), [&](int job) {
        const int bin = jobs.bin(job);
        const Regime regime = jobs.first(job) ? Regime::Covered : Regime::Open;
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

Result<std::string> hashOfFile(const std::string& path)
{
    const auto bytes = readFile(path, kMostBytes);
    if (!bytes) return bytes.error();
    return sha256Hex(*bytes);
}

Result<TrainingSet> readTraining(const TrainOptions& options)
{
    const auto file = readScenes(options.data);
    if (!file) return file.error();
    for (const std::string& notice : file->notices) fmt::print(stderr, "terratact: {}\n", notice);
    auto hash = hashOfFile(options.data);
    if (!hash) return hash.error();
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
    set.model.inducing = options.inducing;
    set.model.command = options.commandLine;
    set.model.dataHash = *std::move(hash);
    return set;
}

Status writePart(const TrainOptions& options, ModelData model)
{
    auto robotHash = hashOfFile(options.robot);
    if (!robotHash) return robotHash.error();
    const ModelPart part{
        std::move(model),
        {*options.bins, *std::move(robotHash), options.commandBeforeOut, options.commandAfterOut}};
    if (Status written = writeModelPart(options.out, part); !written) return written;
    printBins(part.model, *options.bins);
    fmt::print("bins {} of {}; written to {}, for `terratact merge`\n", text(*options.bins),
               text(kAllBins), options.out);
    return Done{};
}

void printModel(const ModelData& model, const std::string& path)
{
    printBins(model, kAllBins);
    fmt::print("a contact counts as a measurement with bias {:.1f} mm, sd {:.1f} mm\n",
               1000.0 * model.clearance.contactBias, 1000.0 * model.clearance.contactSd);
    fmt::print("{} scenes; 22 Gaussian processes on {} of them, surfaces on all; written to {}\n",
               model.heights.rows(), model.scannedHeights.rows(), path);
}

}  // namespace

Status train(const TrainOptions& options)
{
    const auto robot = readRobotModel(options.robot);
    if (!robot) return robot.error();
    auto set = readTraining(options);
    if (!set) return set.error();
    ModelData& model = set->model;
    const Jobs jobs{binsOf(options.bins.value_or(kAllBins))};
    trainAll(model, jobs, options.seed);
    trainClearances(model, *robot, jobs, options.seed);
    trainClearanceConditionals(model, *robot, jobs, options.seed);
    if (options.bins) return writePart(options, std::move(model));
    finishClearance(model, bodyCeilings(model.features, *robot), *robot);
    if (Status written = writeModel(options.out, model); !written) return written;
    printModel(model, options.out);
    return Done{};
}

}  // namespace terratact
