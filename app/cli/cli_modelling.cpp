#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/commands.h"
#include "app/figures/report/findings_report.h"
#include "app/modelling/findings_file.h"
#include "core/learn/data/scene_file.h"
#include "core/learn/model/model_card.h"

namespace terratact {
namespace {

using Words = std::vector<std::string>;

/// Returns the command line as typed, with the program's bare name.
std::string commandLine(const Words& words)
{
    return fmt::format("terratact {}", fmt::join(words, " "));
}

/// Returns the words without an option and its value.
Words without(const std::string& option, Words words)
{
    for (auto word = words.begin(); word != words.end();)
        if (*word == option && word + 1 != words.end())
            word = words.erase(word, word + 2);
        else if (word->starts_with(option + "="))
            word = words.erase(word);
        else
            ++word;
    return words;
}

/// Splits the command around the value of --out.
void splitAtOut(const Words& words, TrainOptions& options)
{
    const auto out = std::find_if(words.begin(), words.end(), [](const std::string& word) {
        return word == "--out" || word.starts_with("--out=");
    });
    if (out == words.end()) return;
    const bool joined = *out != "--out";  // "--out=model.ttm"
    options.commandBeforeOut = commandLine({words.begin(), out}) + (joined ? " --out=" : " --out ");
    for (auto word = out + (joined ? 1 : 2); word < words.end(); ++word)
        options.commandAfterOut += " " + *word;
}

void addTrain(CLI::App& app, Job& job, const Words& words)
{
    auto* c =
        app.add_subcommand("train", "Train a model on scenes: the paper's 22 conditionals, and the "
                                    "processes over clearances");
    const auto o = std::make_shared<TrainOptions>();
    addRobot(*c, o->robot);
    auto* const data =
        addInput(*c, "--data", o->data, "Scenes CSV with all heights; several are joined");
    auto* const tracks = addInput(*c, "--tracks", o->tracks,
                                  "Scenes CSV of left and right with all heights, joined if "
                                  "several: the model also learns two "
                                  "tracks");
    auto* const generated =
        addInput(*c, "--generated", o->generated,
                 "Generated scenes CSV, mixed to the real ones of --data (one plane) or --tracks "
                 "(left and right) with the weight with the least error on held-out files, runs or "
                 "parts of a run");
    auto* const plane = addInput(*c, "--plane", o->plane,
                                 "Model that learns --tracks; it keeps what it knows of one plane")
                            ->needs(tracks)
                            ->excludes(data);
    auto* const drives =
        addInput(*c, "--drives", o->drives,
                 "Drives CSV, joined if several: train the networks of the method trail, which "
                 "remember the way, instead of a model")
            ->excludes(data)
            ->excludes(tracks)
            ->excludes(generated);
    auto* const trackDrives =
        addInput(*c, "--track-drives", o->trackDrives, "Drives CSV on two tracks, for the same")
            ->excludes(data)
            ->excludes(tracks)
            ->excludes(generated);
    addFileOutput(*c, "--out", o->out, "Model (*.ttm) or networks (*.ttn) to write")->required();
    declareFiles(*c, FileRole::Output, [o] {
        const bool hasCard = !o->bins && o->drives.empty() && o->trackDrives.empty();
        return hasCard ? Paths{cardPath(o->out)} : Paths{};
    });
    addNumber(*c, "--networks", o->networks, "Networks per kind of drives; their mean counts")
        ->check(CLI::Range(1, 16));
    addNumber(*c, "--epochs", o->epochs, "Passes of each network over all scenes of drives")
        ->check(CLI::Range(1, 1000));
    addNumber(*c, "--seed", o->seed, "Seed of the search");
    addNumber(*c, "--scanner-sd", o->scannerSd,
              "Noise added to the conditionals' heights [m]: for scenes with exact ones")
        ->check(CLI::Range(0.0, 1.0));
    addNumber(*c, "--conditional-rows", o->conditionalRows,
              "Scenes the conditionals learn from; clearances learn from all")
        ->check(CLI::Range(30, 20'000));
    addParsed(*c, "--bins", o->bins, binSetFrom, "BINS", "does not name bins 0 to 10, each once",
              "Train these bins alone (0-3 or 0,4,10; 0 is -0.3 m) and write a part of a model "
              "(*.ttp) for merge")
        ->excludes(tracks)
        ->excludes(generated);
    addNumber(*c, "--inducing", o->inducing,
              "Conditionals predict through at most so many of their scenes, and their "
              "hyperparameters come from 1400 (default 0: from all, through all)")
        ->check(CLI::Range(0, 20'000));
    for (CLI::Option* const ofDrives : {drives, trackDrives})
        for (const char* other : {"--scanner-sd", "--conditional-rows", "--bins", "--inducing"})
            ofDrives->excludes(other);
    c->callback([o, data, plane, drives, trackDrives, &job, words] {
        if (data->count() + plane->count() + drives->count() + trackDrives->count() == 0)
            throw CLI::RequiredError("--data");
        o->commandLine = commandLine(words);
        splitAtOut(without("--bins", words), *o);
        useShippedRobot(o->robot);
        job = [o] { return train(*o); };
    });
}

void addReconstruct(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("reconstruct", "Estimate the terrain of every scene of a file");
    const auto o = std::make_shared<ReconstructOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addInput(*c, "--data", o->data, "Scenes CSV")->required();
    addTextOutput(*c, "--out", o->out, "Estimates CSV to write")->required();
    c->add_flag("--tracks", o->tracks,
                "Scenes of left and right: estimates and verdicts per side by local or joint");
    addMethod(*c, o->settings);
    addSettings(*c, o->settings, o->seconds);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return reconstructScenes(*o); };
    });
}

void addEvaluate(CLI::App& app, Job& job, const Words& words)
{
    auto* c = app.add_subcommand("evaluate", "Compare methods on scenes whose terrain is known");
    const auto o = std::make_shared<EvaluateOptions>();
    const auto methods = std::make_shared<std::vector<std::string>>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    auto* const data = addInput(*c, "--data", o->data, "Scenes CSV with heights");
    auto* const drives =
        addInput(*c, "--drives", o->drives,
                 "Drives CSV: print the errors of its scenes with the memory of the way")
            ->excludes(data);
    addInput(*c, "--trail", o->trail, "Networks of the method trail (*.ttn)")->needs(drives);
    auto* const out =
        addFolderOutput(*c, "--out", o->out, "Directory for the CSV files and the figures", [o] {
            if (o->tracks) return Paths{"tracks.csv", "track_steps.csv", "missing.csv"};
            return o->shard ? Paths{shardFile(*o->shard)} : reportFiles();
        });
    declareFiles(*c, FileRole::Update,
                 [o] { return o->card ? Paths{cardPath(o->model)} : Paths{}; });
    addMethods(*c, *methods);
    o->settings.hazardRate = 0.0;  // compares the methods without hazard rate
    addNumber(*c, "--step-limit", o->stepLimit,
              "Ground that rises or falls by more within two bins is a step [m]")
        ->check(CLI::Range(0.0, 10.0));
    auto* card = c->add_flag(
        "--card", o->card, "Also write mean |error| and coverage into the model's card, beside it");
    addParsed(*c, "--shard", o->shard, shardFrom, "i/n", "is no part i/n with 1 <= i <= n <= 10000",
              "Evaluate part i of n alone (2/8) and write it (part_2_of_8.tte) for merge")
        ->excludes(card);
    auto* const tracks =
        c->add_flag("--tracks", o->tracks,
                    "Scenes of left and right: errors per side, beside those of one plane")
            ->excludes(card)
            ->excludes("--shard");
    auto* classes = addInput(*c, "--classes", o->classes,
                             "Index CSV whose column row names the scenes' runs: scores by class");
    classes->excludes(tracks);
    c->add_option("--class-column", o->classColumn, "Its column with the class")
        ->capture_default_str()
        ->needs(classes);
    c->add_flag("--probes", o->probes,
                "Simulate probes chosen by largest sd, by expected variance and by the step "
                "question")
        ->excludes(tracks);
    c->add_flag("--missing", o->missing,
                "Only print the errors of the methods without currents or forces")
        ->excludes(card);
    addSettings(*c, o->settings, o->seconds);
    for (const char* other : {"--out", "--card", "--shard", "--tracks", "--classes", "--probes",
                              "--missing", "--seconds", "--step-limit"})
        drives->excludes(other);
    c->callback([o, methods, data, out, &job, words] {
        if (o->drives.empty() && data->count() == 0) throw CLI::RequiredError("--data");
        if (o->drives.empty() && out->count() == 0) throw CLI::RequiredError("--out");
        if (o->drives.empty() && std::ranges::find(*methods, "trail") != methods->end())
            throw CLI::ValidationError("--methods", "trail needs --drives");
        if (!o->drives.empty()) useShippedTrail(o->trail);
        if (!o->drives.empty() && methods->empty())
            *methods = {std::string(name(Method::Local)), std::string(name(Method::Trail))};
        if (o->tracks && methods->empty()) methods->emplace_back(name(Method::Local));
        o->methods = methodsFrom(*methods);
        o->command = commandLine(without("--out", without("--shard", words)));
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return evaluate(*o); };
    });
}

void addHazards(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "hazards", "How often the verdict is wrong before drops, gaps, walls and ditches");
    const auto o = std::make_shared<HazardsOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addNumber(*c, "--drives", o->drives, "Drives per kind of hazard, ground and press")
        ->check(CLI::Range(1, 10'000));
    addNumber(*c, "--step-limit", o->stepLimit,
              "Ground that rises or falls by more within two bins is a step [m]")
        ->check(CLI::Range(0.0, 10.0));
    c->add_option("--rates", o->rates,
                  "Rates of hazards per unfelt bin to compare; the last one is printed in full "
                  "(default 0.002,0.01,0.05)")
        ->delimiter(',')
        ->check(CLI::Range(0.0, 1.0));
    auto* tracks =
        c->add_flag("--tracks", o->tracks,
                    "Hazards on one side and on both, judged for left and right by local or joint");
    auto* memory =
        c->add_flag("--memory", o->memory,
                    "Drives with telemetry on the way, judged by trail, and the same ones by local")
            ->needs(tracks);
    c->add_flag("--manoeuvres", o->manoeuvres,
                "With --memory: only the drives that turn, reverse and probe")
        ->needs(memory);
    addNumber(*c, "--seed", o->settings.seed, "Seed of ground, drives and noise");
    addMethod(*c, o->settings);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return judgeHazards(*o); };
    });
}

void addStrip(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "strip", "Errors of the strip of felt ground along simulated drives: docs/strip.md");
    const auto o = std::make_shared<StripOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addTerrain(*c, o->grounds.terrain, "varied, or a CSV file of profiles")->capture_default_str();
    addNumber(*c, "--drives", o->drives, "Drives; of a file every profile, at most so many")
        ->check(CLI::Range(1, 100'000));
    addNumber(*c, "--spacing", o->spacing, "Driven between two scenes [m]")
        ->check(CLI::Range(0.01, 1.0));
    addNumber(*c, "--step", o->grounds.step, "Distance of a file's heights [m]")
        ->check(CLI::Range(0.001, 1.0));
    c->add_flag("--blocks", o->grounds.blocks,
                "A file's heights are flat-topped blocks with vertical faces");
    addNumber(*c, "--seed", o->grounds.seed, "Seed of ground, drives and noise");
    addChoice(
        *c, "--method", o->settings.method, methodFromName,
        "pa|pac|pafc|pafac|clearance|joint|local|trail",
        fmt::format("Method (default {}); trail remembers the way", name(o->settings.method)));
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return judgeStrips(*o); };
    });
}

void addFeelForward(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("feel-forward",
                                 "How far and how fast feel forward goes, and whether it falls");
    const auto o = std::make_shared<FeelForwardOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addNumber(*c, "--drives", o->drives, "Drives over generated ground with hazards")
        ->check(CLI::Range(1, 10'000));
    addNumber(*c, "--step-limit", o->stepLimit,
              "Ground that rises or falls by more within two bins is a step [m]")
        ->check(CLI::Range(0.0, 10.0));
    addNumber(*c, "--estimate-seconds", o->estimateSeconds,
              "Duration of an estimate in the time model [s]")
        ->check(CLI::Range(0.0, 60.0));
    c->add_flag("--blind", o->isBlind, "Advance whatever the verdict is, for comparison");
    addNumber(*c, "--seed", o->settings.seed, "Seed of ground, drives and noise");
    addTrailMethod(*c, "--method", o->settings.method,
                   fmt::format("Method (default {})", name(o->settings.method)));
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return tryFeelForward(*o); };
    });
}

void addMerge(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "merge", "Put the parts of one train --bins or of one evaluate --shard together");
    const auto o = std::make_shared<MergeOptions>();
    addInput(*c, "parts", o->parts, "Every part (*.ttp or *.tte), in any order")->required();
    addRobot(*c, o->robot);
    addFolderOutput(*c, "--out", o->out,
                    "Of a training the model to write (*.ttm), of an evaluation the directory",
                    [o] { return isEvaluation(*o) ? reportFiles() : Paths{}; })
        ->required();
    declareFiles(*c, FileRole::Output, [o] {
        return isEvaluation(*o) ? Paths{} : Paths{o->out, cardPath(o->out)};
    });
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        job = [o] { return merge(*o); };
    });
}

void addTradeoff(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "tradeoff", "Time and error of sweeps, chains, precision, inducing rows and presets");
    const auto o = std::make_shared<TradeoffOptions>();
    const auto methods = std::make_shared<std::vector<std::string>>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addInput(*c, "--data", o->data, "Scenes CSV with heights")->required();
    addFolderOutput(*c, "--out", o->out, "Directory for the CSV files and the figure",
                    tradeoffFiles)
        ->required();
    addMethods(*c, *methods);
    addNumber(*c, "--reference-sweeps", o->referenceDraws,
              "Kept sweeps of the long runs that the others are compared with")
        ->check(CLI::Range(64, 10'000'000));
    addNumber(*c, "--seed", o->seed, "Seed of the random numbers");
    c->callback([o, methods, &job] {
        if (std::ranges::find(*methods, "trail") != methods->end())
            throw CLI::ValidationError("--methods", "trail needs drives: evaluate --drives");
        o->methods = methodsFrom(*methods);
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return tradeoff(*o); };
    });
}

}  // namespace

void addModelling(CLI::App& app, Job& job, const Words& words)
{
    addSimulate(app, job);
    addTrain(app, job, words);
    addReconstruct(app, job);
    addEvaluate(app, job, words);
    addHazards(app, job);
    addStrip(app, job);
    addFeelForward(app, job);
    addMerge(app, job);
    addTradeoff(app, job);
}

}  // namespace terratact
