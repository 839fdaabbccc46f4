#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cli/commands.h"
#include "app/modelling/evaluation/model_cards.h"
#include "app/modelling/training/model_conditions.h"
#include "app/modelling/training/model_training.h"
#include "app/modelling/training/scene_mixing.h"
#include "app/modelling/training/trail_learning.h"
#include "app/runtime/print_text.h"
#include "app/runtime/progress.h"
#include "core/learn/model/file/model_file.h"
#include "core/learn/model/file/model_part.h"
#include "core/robot/robot_model.h"
#include "core/store/file_read.h"
#include "core/store/sha256.h"
#include "core/trail/trail_file.h"

namespace terratact {

namespace {

constexpr std::size_t kMaxTrainedRobot = std::size_t{1} << 20U;

void printBins(const ModelData& model, const BinSet& bins)
{
    printText("{:>6}  {:>22}  {:>22}\n", "bin_m", "noise sd [mm] pa, paf", "log p(y|X) pa, paf");
    for (const int bin : binsOf(bins)) {
        const auto i = static_cast<std::size_t>(bin);
        printText("{:>+6.1f}  {:>10.2f} {:>10.2f}  {:>11.1f} {:>10.1f}\n", binCentre(bin),
                  1000.0 * model.pa.bins[i].noiseSd, 1000.0 * model.paf.bins[i].noiseSd,
                  model.pa.logLikelihood[i], model.paf.logLikelihood[i]);
    }
}

/// Shows the progress of each stage; one line on a terminal.
class StageProgress {
public:
    void show(const TrainingStep& step)
    {
        const std::string_view stage = stageOf(step.kind);
        if (stage != stage_) {
            stage_ = stage;
            progress_.reset();
            progress_ =
                std::make_unique<Progress>(fmt::format("training {}", stage), step.stageTotal);
        }
        if (step.event != TrainingEvent::Begun) progress_->tick();
    }

private:
    std::string_view stage_;
    std::unique_ptr<Progress> progress_;
};

/// Returns all files but the first.
std::vector<std::string> others(const std::vector<std::string>& files)
{
    return {files.begin() + (files.empty() ? 0 : 1), files.end()};
}

/// Returns the first file, and how many more there are.
std::string nameOfAll(const std::vector<std::string>& files)
{
    if (files.empty()) return {};
    return files.size() == 1 ? files.front()
                             : fmt::format("{} and {} more", files.front(), files.size() - 1);
}

Result<ModelData> trainVisibly(const TrainOptions& options, const RobotModel& robot,
                               ChosenMixes& chosen)
{
    StageProgress stages;
    return trainModel(
        {.robot = robot,
         .data = options.data.empty() ? "" : options.data.front(),
         .moreData = others(options.data),
         .tracks = options.tracks.empty() ? "" : options.tracks.front(),
         .moreTracks = others(options.tracks),
         .generated = options.generated,
         .plane = options.plane,
         .scannerSd = options.scannerSd,
         .conditionalRows = options.conditionalRows,
         .inducing = options.inducing,
         .commandLine = options.commandLine,
         .seed = options.seed,
         .bins = options.bins},
        {.cancelled = {},
         .progress = [&](const TrainingStep& step) { stages.show(step); },
         .notice =
             [](const Message& notice) { printText(stderr, "terratact: {}\n", notice.english()); },
         .mix = [&](const CardMix& mix) { chosen.tracks = mix; },
         .planeMix = [&](const CardMix& mix) { chosen.plane = mix; }});
}

Status writePart(const TrainOptions& options, ModelData model, std::string robotHash)
{
    const ModelPart part{
        std::move(model),
        {*options.bins, std::move(robotHash), options.commandBeforeOut, options.commandAfterOut}};
    if (Status written = writeModelPart(options.out, part); !written) return written;
    printBins(part.model, *options.bins);
    printText("bins {} of {}; written to {}, for `terratact merge`\n", text(*options.bins),
              text(kAllBins), options.out);
    return Done{};
}

void printModel(const ModelData& model, const std::string& path)
{
    printBins(model, kAllBins);
    for (const FeatureSet set : {FeatureSet::Pa, FeatureSet::Paf})
        printText("{}", Lines(conditionsText(model, set)));
    printText("a contact counts as a measurement with bias {:.1f} mm, sd {:.1f} mm\n",
              1000.0 * model.clearance.contactBias, 1000.0 * model.clearance.contactSd);
    printText("{} scenes; 22 Gaussian processes on {} of them, surfaces on all; written to {}\n",
              model.heights.rows(), model.scannedHeights.rows(), path);
    if (model.hasSides())
        printText("two tracks: 22 Gaussian processes for both sides; {} scenes kept\n",
                  model.sides.heights.rows() / 2);
}

Status trainTrailNetworks(const TrainOptions& options, const RobotModel& robot)
{
    TrailPlan plan{.robot = robot,
                   .drives = options.drives,
                   .trackDrives = options.trackDrives,
                   .commandLine = options.commandLine,
                   .seed = options.seed};
    plan.options.networks = options.networks;
    plan.options.network.epochs = options.epochs;
    const auto data = learnTrail(
        plan, [](const std::string& notice) { printText(stderr, "terratact: {}\n", notice); });
    if (!data) return data.error();
    if (Status written = writeTrail(options.out, *data); !written) return written;
    printText("trail networks: {} of one plane, {} of two tracks; written to {}\n",
              data->plane.networks.size(), data->side.networks.size(), options.out);
    return Done{};
}

}  // namespace

Status train(const TrainOptions& options)
{
    const auto bytes = readFile(options.robot, kMaxTrainedRobot);
    if (!bytes) return bytes.error();
    const auto robot = robotModelFrom(options.robot, *bytes);
    if (!robot) return robot.error();
    if (!options.drives.empty() || !options.trackDrives.empty())
        return trainTrailNetworks(options, *robot);
    if (!options.bins)
        if (Status s = checkCardReplaceable(options.out); !s) return s;
    ChosenMixes mixes;
    auto model = trainVisibly(options, *robot, mixes);
    if (!model) return model.error();
    if (options.bins) return writePart(options, *std::move(model), sha256Hex(*bytes));
    if (Status written = writeModel(options.out, *model); !written) return written;
    if (Status card = writeNewCard(options.out, *model, nameOfAll(options.data), mixes); !card)
        return card;
    printModel(*model, options.out);
    if (mixes.plane) printText("{}", Lines(mixText(*mixes.plane, "one plane: ")));
    if (mixes.tracks) printText("{}", Lines(mixText(*mixes.tracks)));
    return Done{};
}

}  // namespace terratact
