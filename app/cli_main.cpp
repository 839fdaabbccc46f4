#include <cblas.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "app/can_commands.h"
#include "app/commands.h"
#include "app/resources.h"
#include "app/session_commands.h"
#include "core/infer/quality.h"
#include "core/learn/scene_file.h"

namespace terratact {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongArguments = 2;

template <class Enum, class FromName>
CLI::Validator named(Enum& value, FromName fromName, const std::string& choices)
{
    return CLI::Validator(
        [&value, fromName, choices](std::string& text) -> std::string {
            const auto found = fromName(text);
            if (!found) return fmt::format("{} is none of {}", text, choices);
            value = *found;
            return {};
        },
        choices);
}

CLI::Option* addNumber(CLI::App& app, const std::string& flag, auto& value, const std::string& text)
{
    return app.add_option(flag, value, text)->capture_default_str();
}

/// What an estimate costs: a preset, or each number by itself.
void addEffort(CLI::App& app, Settings& settings, std::string& scratch)
{
    const std::vector<CLI::Option*> numbers{
        addNumber(app, "--sweeps", settings.draws, "Most kept sweeps K, all chains together")
            ->check(CLI::Range(1, 10'000'000)),
        addNumber(app, "--chains", settings.chains, "Independent chains")
            ->check(CLI::Range(1, 4096)),
        addNumber(app, "--burn-in", settings.burnIn, "Sweeps thrown away per chain")
            ->check(CLI::Range(0, 1'000'000)),
        addNumber(app, "--inducing", settings.inducing,
                  "Predict through at most so many training rows (0: as trained)")
            ->check(CLI::Range(0, 20'000)),
        app.add_option("--precision", scratch, "Of sampled variances (default single)")
            ->check(named(settings.precision, precisionFromName, "single|double"))};
    auto* quality = app.add_option("--quality", scratch,
                                   "A preset of the five above; what it costs: docs/tradeoff.md");
    quality->check(CLI::Validator(
        [&settings](std::string& text) -> std::string {
            const auto found = qualityFromName(text);
            if (!found) return text + " is none of fast|balanced|accurate";
            settings = withQuality(settings, *found);
            return {};
        },
        "fast|balanced|accurate"));
    for (CLI::Option* number : numbers) quality->excludes(number);
}

/// Options that all estimating commands share.
void addSettings(CLI::App& app, Settings& settings, double& seconds, std::string& scratch)
{
    app.add_option("--ceiling", scratch, "How the robot's body bounds samples (default truncate)")
        ->check(named(settings.ceiling, ceilingRuleFromName, "truncate|clamp|none"));
    app.add_option("--contacts", scratch, "Which force elements fix a bin (default isolated)")
        ->check(named(settings.contacts, contactRuleFromName, "isolated|any|none"));
    addNumber(app, "--threshold", settings.forceThreshold, "Force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
    addEffort(app, settings, scratch);
    app.add_flag_callback(
        "--full", [&settings] { settings.stopEarly = false; },
        "Draw all K, even once the chains have converged (R-hat <= 1.01, ESS >= 400)");
    addNumber(app, "--seconds", seconds,
              "Most seconds of sampling per estimate (default 0: no limit); results then depend on "
              "the machine")
        ->check(CLI::Range(0.0, 86'400.0));
    app.add_option("--scan", scratch, "Order in which a sweep visits the bins (default forward)")
        ->check(named(settings.scan, scanOrderFromName, "forward|reverse|random"));
    addNumber(app, "--seed", settings.seed, "Seed of the random numbers");
}

void addMethod(CLI::App& app, Settings& settings, std::string& scratch)
{
    app.add_option("--method", scratch, fmt::format("Method (default {})", name(settings.method)))
        ->check(named(settings.method, methodFromName, "pa|pac|pafc|pafac|clearance|joint|local"));
}

void addMethods(CLI::App& app, std::vector<std::string>& methods)
{
    app.add_option("--methods", methods, "Methods to compare (default: all)")
        ->delimiter(',')
        ->check(CLI::IsMember({"pa", "pac", "pafc", "pafac", "clearance", "joint", "local"}));
}

/// Each once, in the order given; all of them where none is.
std::vector<Method> methodsFrom(const std::vector<std::string>& names)
{
    std::vector<Method> methods;
    for (const std::string& text : names)
        if (const Method method = *methodFromName(text);
            std::find(methods.begin(), methods.end(), method) == methods.end())
            methods.push_back(method);
    if (methods.empty()) methods.assign(kMethods.begin(), kMethods.end());
    return methods;
}

void addRobot(CLI::App& app, std::string& robot)
{
    app.add_option("--robot", robot, "Robot file")->default_str("the shipped Absolem");
}

/// The command as a person would type it, with the program's bare name.
std::string commandLine(const std::vector<std::string>& words)
{
    return fmt::format("terratact {}", fmt::join(words, " "));
}

/// Takes an option and its value out of the words.
void drop(std::vector<std::string>& words, const std::string& option)
{
    for (auto word = words.begin(); word != words.end();)
        if (*word == option && word + 1 != words.end())
            word = words.erase(word, word + 2);
        else if (word->starts_with(option + "="))
            word = words.erase(word);
        else
            ++word;
}

/// The command around the value of --out.
void splitAtOut(std::vector<std::string> words, TrainOptions& options)
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

struct Arguments {
    SimulateOptions simulate;
    TrainOptions train;
    ReconstructOptions reconstruct;
    EvaluateOptions evaluate;
    DemoOptions demo;
    MergeOptions merge;
    TradeoffOptions tradeoff;
    ContactsOptions contacts;
    GhostOptions ghost;
    std::string probes;
    CalibrateOptions calibrate;
    RobotOptions onBus;
    PanelCheckOptions panelCheck;
    CanDecodeOptions canDecode;
    CanMonitorOptions canMonitor;
    std::string canCheck;
    std::vector<std::string> sessions;  ///< of session info and recover
    VerifyOptions sessionVerify;
    SessionExportOptions sessionExport;
    SessionScenesOptions sessionScenes;
    SessionReportOptions sessionReport;
    SessionMergeOptions sessionMerge;
    SessionImportOptions sessionImport;
    WhatIfOptions whatIf;
    std::string modelPath;
    std::string modelData;
    ModelCardOptions modelCard;
    bool modelCsv = false;
    std::string scratch;
    std::vector<std::string> methods;
};

void addSimulate(CLI::App& app, Arguments& a)
{
    auto* c =
        app.add_subcommand("simulate", "Drive a simulated robot over terrain and record scenes");
    addRobot(*c, a.simulate.robot);
    c->add_option("--terrain", a.simulate.terrain,
                  "boxes (28 runs over boxes of 0.20 and 0.28 m), varied, or a CSV file of "
                  "profiles: two columns x,z in "
                  "m, or rows of heights in m")
        ->required();
    c->add_option("--out", a.simulate.out, "Scenes CSV to write")->required();
    addNumber(*c, "--seed", a.simulate.seed, "Seed of terrain and noise");
    c->add_option("--count", a.simulate.count, "Scenes (default: 1400, or every stop over a file)")
        ->check(CLI::Range(1, static_cast<int>(kMostScenes)));
    addNumber(*c, "--step", a.simulate.step, "Distance of a file's heights [m]")
        ->check(CLI::Range(0.001, 1.0));
    c->add_flag("--blocks", a.simulate.blocks,
                "A file's heights are flat-topped blocks with vertical faces");
    c->add_flag("--exact-truth", a.simulate.exactTruth, "No scanner noise on the true heights");
    c->add_option("--soft-drives", a.simulate.softDrives,
                  "Share of the drives over ground into which the robot sinks (default 0)")
        ->check(CLI::Range(0.0, 1.0));
    c->add_option("--disturb", a.scratch, "What the estimator does not know of (default none)")
        ->check(named(a.simulate.disturbance, disturbanceFromName,
                      "none|imu-noise|forces-high|forces-low|dead-element|soft-ground|light-robot|"
                      "heavy-robot|friction-free"));
}

void addTrain(CLI::App& app, Arguments& a)
{
    auto* c =
        app.add_subcommand("train", "Train a model on scenes: the paper's 22 conditionals, and the "
                                    "processes over clearances");
    addRobot(*c, a.train.robot);
    c->add_option("--data", a.train.data, "Scenes CSV with all heights")->required();
    c->add_option("--out", a.train.out, "Model to write (*.ttm)")->required();
    addNumber(*c, "--seed", a.train.seed, "Seed of the search");
    addNumber(*c, "--scanner-sd", a.train.scannerSd,
              "Noise added to the conditionals' heights [m]: for scenes with exact ones")
        ->check(CLI::Range(0.0, 1.0));
    addNumber(*c, "--conditional-rows", a.train.conditionalRows,
              "Scenes the conditionals learn from; clearances learn from all")
        ->check(CLI::Range(30, 20'000));
    c->add_option("--bins", a.scratch,
                  "Train these bins alone (0-3 or 0,4,10; 0 is -0.3 m) and write a part of a model "
                  "(*.ttp) for merge")
        ->check(CLI::Validator(
            [&a](std::string& list) -> std::string {
                a.train.bins = binSetFrom(list);
                return a.train.bins ? "" : list + " does not name bins 0 to 10, each once";
            },
            "BINS"));
    addNumber(*c, "--inducing", a.train.inducing,
              "Conditionals predict through at most so many of their scenes, and their "
              "hyper-parameters come from 1400 (default 0: from all, through all)")
        ->check(CLI::Range(0, 20'000));
}

void addReconstruct(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("reconstruct", "Estimate the terrain of every scene of a file");
    addRobot(*c, a.reconstruct.robot);
    c->add_option("--model", a.reconstruct.model, "Model (*.ttm)")->default_str("the shipped one");
    c->add_option("--data", a.reconstruct.data, "Scenes CSV")->required();
    c->add_option("--out", a.reconstruct.out, "Estimates CSV to write")->required();
    addMethod(*c, a.reconstruct.settings, a.scratch);
    addSettings(*c, a.reconstruct.settings, a.reconstruct.seconds, a.scratch);
}

void addEvaluate(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("evaluate", "Compare methods on scenes whose terrain is known");
    addRobot(*c, a.evaluate.robot);
    c->add_option("--model", a.evaluate.model, "Model (*.ttm)")->default_str("the shipped one");
    c->add_option("--data", a.evaluate.data, "Scenes CSV with heights")->required();
    c->add_option("--out", a.evaluate.out, "Directory for the CSV files and the figures")
        ->required();
    addMethods(*c, a.methods);
    addNumber(*c, "--step-limit", a.evaluate.stepLimit,
              "Ground that rises or falls by more within two bins is a step [m]")
        ->check(CLI::Range(0.0, 10.0));
    auto* card =
        c->add_flag("--card", a.evaluate.card,
                    "Also write mean |error| and coverage into the model's card, beside it");
    c->add_option("--shard", a.scratch,
                  "Evaluate part i of n alone (2/8) and write it (part_2_of_8.tte) for merge")
        ->check(CLI::Validator(
            [&a](std::string& text) -> std::string {
                const auto shard = shardFrom(text);
                if (!shard) return text + " is no part i/n with 1 <= i <= n <= 10000";
                a.evaluate.shard = shard;
                return {};
            },
            "i/n"))
        ->excludes(card);
    auto* classes =
        c->add_option("--classes", a.evaluate.classes,
                      "Index CSV whose column row names the scenes' runs: scores by class");
    c->add_option("--class-column", a.evaluate.classColumn, "Its column with the class")
        ->capture_default_str()
        ->needs(classes);
    c->add_flag("--probes", a.evaluate.probes,
                "Simulate probes chosen by largest sd, by expected variance and by the step "
                "question");
    addSettings(*c, a.evaluate.settings, a.evaluate.seconds, a.scratch);
}

void addTradeoff(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "tradeoff", "What sweeps, chains, precision, inducing rows and presets cost and err");
    addRobot(*c, a.tradeoff.robot);
    c->add_option("--model", a.tradeoff.model, "Model (*.ttm)")->default_str("the shipped one");
    c->add_option("--data", a.tradeoff.data, "Scenes CSV with heights")->required();
    c->add_option("--out", a.tradeoff.out, "Directory for the CSV files and the figure")
        ->required();
    addMethods(*c, a.methods);
    addNumber(*c, "--reference-sweeps", a.tradeoff.referenceDraws,
              "Kept sweeps of the long runs that the others are compared with")
        ->check(CLI::Range(64, 10'000'000));
    addNumber(*c, "--seed", a.tradeoff.seed, "Seed of the random numbers");
}

void addMerge(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "merge", "Put the parts of one train --bins or of one evaluate --shard together");
    c->add_option("parts", a.merge.parts, "Every part (*.ttp or *.tte), in any order")->required();
    addRobot(*c, a.merge.robot);
    c->add_option("--out", a.merge.out,
                  "Of a training the model to write (*.ttm), of an evaluation the directory")
        ->required();
}

void addContacts(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "contacts", "Bias and sd of contact heights, from scenes whose terrain is known");
    addRobot(*c, a.contacts.robot);
    c->add_option("--data", a.contacts.data, "Scenes CSV with heights")->required();
    addNumber(*c, "--threshold", a.contacts.threshold, "Force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
}

void addGhost(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "ghost", "What the last estimate is worth at the next scene of simulated drives");
    addRobot(*c, a.ghost.robot);
    c->add_option("--model", a.ghost.model, "Model (*.ttm)")->default_str("the shipped one");
    c->add_option("--terrain", a.ghost.terrain, "boxes, varied, or a CSV file of profiles")
        ->capture_default_str();
    addNumber(*c, "--drives", a.ghost.drives, "Drives; of a file every profile, at most so many")
        ->check(CLI::Range(1, 100'000));
    addNumber(*c, "--spacing", a.ghost.spacing, "Driven between two scenes [m]")
        ->check(CLI::Range(0.01, 1.0));
    addNumber(*c, "--step", a.ghost.step, "Distance of a file's heights [m]")
        ->check(CLI::Range(0.001, 1.0));
    c->add_flag("--blocks", a.ghost.blocks,
                "A file's heights are flat-topped blocks with vertical faces");
    c->add_option("--methods", a.methods, "Methods to compare (default: local and clearance)")
        ->delimiter(',')
        ->check(CLI::IsMember({"clearance", "joint", "local"}));
    addNumber(*c, "--sd-factor", a.ghost.sdFactor,
              "Of the ghost's sd where it is a measurement of the next estimate")
        ->check(CLI::Range(0.1, 100.0));
    addNumber(*c, "--seed", a.ghost.settings.seed, "Seed of terrain, noise and estimates");
}

void addProbes(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("probes", "The sd of an arm's readings, from a recording of them");
    c->add_option("--data", a.probes, "CSV with place,height_m,truth_m")->required();
}

void addCalibrate(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "calibrate", "The force elements' bias and curve, from a recording of known forces");
    c->add_option("--data", a.calibrate.data, "CSV with side,element,force_n,voltage_v")
        ->required();
    addRobot(*c, a.calibrate.robot);
}

void addPanel(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("panel", "The operator's panel of buttons and lamps");
    c->require_subcommand(1);
    auto* check =
        c->add_subcommand("check", "Find the panel's lines and show its contacts: docs/panel.md");
    check->add_option("file", a.panelCheck.file, "Panel file (resources/panels/example.toml)")
        ->required();
    check->add_flag("--lamps", a.panelCheck.lamps, "Light each lamp for a second");
    auto* watch =
        check->add_flag("--watch", a.panelCheck.watch, "Print what changes, until interrupted");
    check->add_option("--seconds", a.panelCheck.seconds, "End watching after so long")
        ->needs(watch)
        ->check(CLI::Range(0.0, 1e9));
}

void addDemo(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "demo", "The main job on the built-in simulated robot: drive up to an unseen step, ATEM, "
                "estimate, one probe, second estimate");
    addRobot(*c, a.demo.robot);
    c->add_option("--model", a.demo.model, "Model (*.ttm)")->default_str("the shipped one");
    c->add_option("--out", a.demo.out, "Directory for CSV and PNG")->capture_default_str();
    addMethod(*c, a.demo.settings, a.scratch);
    addSettings(*c, a.demo.settings, a.demo.seconds, a.scratch);
}

void addRobotOnBus(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand(
        "robot", "A simulated robot as a process of its own on a CAN bus: the protocol of "
                 "resources/dbc/terratact.dbc, obeys and refuses as a real one has to");
    addRobot(*c, a.onBus.robot);
    c->add_option("--can", a.onBus.can, "Interface, such as vcan0")->required();
    c->add_option("--terrain", a.onBus.terrain,
                  "File with a profile, or 'varied' for random ground (default: the demo's)");
    c->add_option("--fault", a.onBus.fault,
                  "What goes wrong: silence, stuck-imu, dead-element, refuse-probe, slow-arm or "
                  "reboot, from the start or @SECONDS later")
        ->capture_default_str();
    c->add_option("--seed", a.onBus.seed, "Of terrain and sensor noise")->capture_default_str();
    c->add_option("--speed", a.onBus.speed, "Simulated seconds per second")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 1000.0));
    c->add_option("--seconds", a.onBus.seconds, "Ends after this time (default: when interrupted)")
        ->check(CLI::NonNegativeNumber);
}

void addModel(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("model", "Look at models");
    c->require_subcommand(1);
    auto* show = c->add_subcommand("show", "Every hyper-parameter, and how the model was made");
    show->add_option("model", a.modelPath, "Model (*.ttm)")->required();
    show->add_flag("--csv", a.modelCsv, "Everything a prediction needs, as CSV");
    auto* card = c->add_subcommand(
        "card", "Write into the card beside a model when and on what ground it was trained");
    card->add_option("model", a.modelCard.model, "Model (*.ttm)")->required();
    card->add_option("--trained", a.modelCard.trained, "When, such as 2026-11-22T07:05:00Z");
    card->add_option("--terrain", a.modelCard.terrain, "On what ground, in 1 to 100 characters");
    auto* predict = c->add_subcommand(
        "predict", "Mean and sd of each bin given the scene's other bins, as CSV: to check "
                   "the model against another program");
    predict->add_option("model", a.modelPath, "Model (*.ttm)")->required();
    predict->add_option("--data", a.modelData, "Scenes CSV with heights")->required();
}

void addProtocol(CLI::App& app, CanProtocol& protocol, std::string& scratch)
{
    app.add_option("--protocol", scratch, "Whose frames are on the bus (default terratact)")
        ->check(named(protocol, canProtocolFromName, "terratact|absolem"));
}

void addDbc(CLI::App& app, std::vector<std::string>& files)
{
    app.add_option("--dbc", files,
                   "DBC file for frames that are not the protocol's; may be repeated")
        ->allow_extra_args(false);
}

void addCanDecode(CLI::App& can, Arguments& a)
{
    auto* c = can.add_subcommand("decode", "Every frame of a log in words, and what was wrong");
    c->add_option("log", a.canDecode.log, "Log of candump or python-can")->required();
    c->add_option("--interface", a.canDecode.interface, "Only of this one");
    c->add_option("--csv", a.canDecode.csv, "CSV to write, a row for each value");
    c->add_flag("--summary", a.canDecode.summaryOnly, "No line for each frame");
    addProtocol(*c, a.canDecode.protocol, a.scratch);
    addDbc(*c, a.canDecode.dbc);
}

void addCanMonitor(CLI::App& can, Arguments& a)
{
    auto* c = can.add_subcommand("monitor", "What is on a bus: values, rates, ages, load, drops");
    c->add_option("bus", a.canMonitor.bus, "Interface, or a log to replay")->required();
    c->add_option("--seconds", a.canMonitor.seconds, "Then it ends (default: never)")
        ->check(CLI::Range(0.0, 1e6));
    addNumber(*c, "--bitrate", a.canMonitor.bitrate, "Of the bus, for its load [bit/s]")
        ->check(CLI::Range(1e3, 1e6));
    c->add_option("--interface", a.canMonitor.interface, "Of a log that holds several");
    addNumber(*c, "--speed", a.canMonitor.speed, "Of a replay: seconds of the log per second")
        ->check(CLI::Range(0.001, 1000.0));
    addProtocol(*c, a.canMonitor.protocol, a.scratch);
    addDbc(*c, a.canMonitor.dbc);
}

void addCan(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("can", "Look at CAN buses and their logs; sends nothing");
    c->require_subcommand(1);
    addCanDecode(*c, a);
    addCanMonitor(*c, a);
    auto* check = c->add_subcommand(
        "check",
        "What is wrong with an interface, and which command mends it; exit code 0: usable");
    check->add_option("interface", a.canCheck, "Such as can0")->required();
}

CLI::Option* addSessionFiles(CLI::App& app, std::vector<std::string>& files)
{
    return app.add_option("files", files, "Sessions (*.tts)")->required();
}

/// Takes the place of a value by one of a set of names.
template <class Enum, class FromName>
CLI::Validator maybeNamed(std::optional<Enum>& value, FromName fromName, const std::string& choices)
{
    return CLI::Validator(
        [&value, fromName, choices](std::string& text) -> std::string {
            value = fromName(text);
            return value ? "" : fmt::format("{} is none of {}", text, choices);
        },
        choices);
}

void addSessionExport(CLI::App& session, Arguments& a)
{
    auto* c = session.add_subcommand("export", "Write frames, signals, estimates or events for "
                                               "other programs");
    SessionExportOptions& o = a.sessionExport;
    c->add_option("file", o.file, "Session (*.tts)")->required();
    c->add_option("--out", o.out, "File to write")->required();
    c->add_option("--format", a.scratch,
                  "Of the file; without it by the ending .log, .asc, .csv or "
                  ".mcap")
        ->check(maybeNamed(o.format, exportFormatFromName, "candump|asc|csv|mcap"));
    c->add_option("--what", a.scratch, "Which rows (CSV: frames if not said; MCAP: all)")
        ->check(
            maybeNamed(o.selection.what, exportKindFromName, "frames|signals|estimates|events"));
    c->add_option("--from", o.selection.from, "Seconds since the session's start");
    c->add_option("--to", o.selection.to, "Seconds since the session's start");
}

void addSessionScenes(CLI::App& session, Arguments& a)
{
    auto* c =
        session.add_subcommand("scenes", "Write captured scenes as CSV for train, reconstruct "
                                         "and evaluate");
    addSessionFiles(*c, a.sessionScenes.files);
    c->add_option("--out", a.sessionScenes.out, "Scenes CSV to write")->required();
    c->add_flag("--measured", a.sessionScenes.measured,
                "Where no truth is known, the heights that contacts and the arm measured");
}

void addSessionWhatIf(CLI::App& session, Arguments& a)
{
    auto* c = session.add_subcommand("what-if", "Compute recorded estimates again, as they were or "
                                                "with other settings");
    WhatIfOptions& o = a.whatIf;
    c->add_option("files", o.files, "Sessions (*.tts), or folders of them")->required();
    auto* one = c->add_option("--estimate", o.estimate, "This one alone, by its number")
                    ->check(CLI::Range(1, 1'000'000'000));
    c->add_flag_callback(
         "--all", [] {}, "All estimates, which is so without it")
        ->excludes(one);
    c->add_option("--method", a.scratch, "Another method")
        ->check(maybeNamed(o.method, methodFromName, "pa|pac|pafc|pafac|clearance|joint|local"));
    c->add_option("--quality", a.scratch,
                  "Draws, chains, burn-in, precision and inducing rows of a "
                  "preset")
        ->check(maybeNamed(o.quality, qualityFromName, "fast|balanced|accurate"));
    c->add_option("--threshold", o.threshold, "Another force of a contact [N]")
        ->check(CLI::Range(0.0, 1000.0));
    c->add_option("--seed", o.seed, "Another seed of the random numbers");
    c->add_option("--model", o.model,
                  "Another model (*.ttm), or where the session's is, if it is "
                  "not the shipped one");
    c->add_option("--out", o.out, "CSV to write, a row for each bin");
}

void addSession(CLI::App& app, Arguments& a)
{
    auto* c = app.add_subcommand("session", "Look at recorded sessions, check and export them: "
                                            "docs/sessions.md");
    c->require_subcommand(1);
    addSessionFiles(*c->add_subcommand("info", "What is in them, and whether it holds"),
                    a.sessions);
    auto* verify = c->add_subcommand("verify", "Check every hash; exit code 0: all is as it was "
                                               "recorded");
    addSessionFiles(*verify, a.sessionVerify.files);
    verify->add_option("--link", a.sessionVerify.link,
                       "Last link of the chain as it was noted elsewhere: shows that nothing was "
                       "cut off");
    addSessionFiles(*c->add_subcommand("recover", "Close sessions whose program died"), a.sessions);
    addSessionExport(*c, a);
    addSessionScenes(*c, a);
    auto* report =
        c->add_subcommand("report", "One page about a scene: profile, numbers, settings, "
                                    "decisions");
    report->add_option("file", a.sessionReport.file, "Session (*.tts)")->required();
    report->add_option("--scene", a.sessionReport.scene, "Its number; without it the last")
        ->check(CLI::Range(1, 1'000'000'000));
    report
        ->add_option("--out", a.sessionReport.out, "PDF, SVG, PNG or HTML to write, by the ending")
        ->required();
    auto* merge = c->add_subcommand("merge", "Put sessions of one drive together");
    addSessionFiles(*merge, a.sessionMerge.files);
    merge->add_option("--out", a.sessionMerge.out, "Session to write (*.tts)")->required();
    addSessionWhatIf(*c, a);
    auto* import = c->add_subcommand("import", "Make a session of a log of candump or python-can");
    import->add_option("log", a.sessionImport.log, "Log to read")->required();
    import->add_option("--out", a.sessionImport.out, "Session to write (*.tts)")->required();
    import->add_option("--interface", a.sessionImport.interface, "Of a log that holds several");
    addRobot(*import, a.sessionImport.robot);
}

Status runSession(const CLI::App& session, const Arguments& a)
{
    if (session.got_subcommand("info")) return showSessions(a.sessions);
    if (session.got_subcommand("verify")) return verifySessions(a.sessionVerify);
    if (session.got_subcommand("recover")) return recoverSessions(a.sessions);
    if (session.got_subcommand("export")) return exportSession(a.sessionExport);
    if (session.got_subcommand("scenes")) return exportScenes(a.sessionScenes);
    if (session.got_subcommand("report")) return reportSession(a.sessionReport);
    if (session.got_subcommand("merge")) return mergeSessions(a.sessionMerge);
    if (session.got_subcommand("import")) return importLog(a.sessionImport);
    return whatIf(a.whatIf);
}

Status runCan(const CLI::App& can, const Arguments& a)
{
    if (can.got_subcommand("decode")) return decodeCanLog(a.canDecode);
    if (can.got_subcommand("monitor")) return monitorCan(a.canMonitor);
    return checkCan(a.canCheck);
}

Status run(const CLI::App& app, Arguments& a)
{
    if (app.got_subcommand("simulate")) return simulate(a.simulate);
    if (app.got_subcommand("train")) return train(a.train);
    if (app.got_subcommand("reconstruct")) return reconstructScenes(a.reconstruct);
    if (app.got_subcommand("evaluate")) {
        a.evaluate.methods = methodsFrom(a.methods);
        return evaluate(a.evaluate);
    }
    if (app.got_subcommand("tradeoff")) {
        a.tradeoff.methods = methodsFrom(a.methods);
        return tradeoff(a.tradeoff);
    }
    if (app.got_subcommand("merge")) return merge(a.merge);
    if (app.got_subcommand("contacts")) return showContacts(a.contacts);
    if (app.got_subcommand("ghost")) {
        if (a.methods.empty()) a.methods = {"local", "clearance"};
        a.ghost.methods = methodsFrom(a.methods);
        return judgeGhost(a.ghost);
    }
    if (app.got_subcommand("probes")) return showProbes(a.probes);
    if (app.got_subcommand("calibrate")) return calibrateForces(a.calibrate);
    if (app.got_subcommand("robot")) return runRobot(a.onBus);
    if (app.got_subcommand("panel")) return checkPanel(a.panelCheck);
    if (app.got_subcommand("demo")) return demo(a.demo);
    if (app.got_subcommand("can")) return runCan(*app.get_subcommand("can"), a);
    if (app.got_subcommand("session")) return runSession(*app.get_subcommand("session"), a);
    if (app.get_subcommand("model")->got_subcommand("predict"))
        return predictConditionals(a.modelPath, a.modelData);
    if (app.get_subcommand("model")->got_subcommand("card")) return describeModel(a.modelCard);
    return showModel(a.modelPath, a.modelCsv);
}

void useShippedFiles(Arguments& a)
{
    for (std::string* robot :
         {&a.simulate.robot, &a.train.robot, &a.reconstruct.robot, &a.evaluate.robot,
          &a.merge.robot, &a.demo.robot, &a.contacts.robot, &a.tradeoff.robot, &a.calibrate.robot,
          &a.onBus.robot, &a.ghost.robot, &a.sessionImport.robot})
        if (robot->empty()) *robot = resourcePath("robots/absolem.toml");
    for (std::string* model : {&a.reconstruct.model, &a.evaluate.model, &a.demo.model,
                               &a.tradeoff.model, &a.ghost.model, &a.whatIf.shippedModel})
        if (model->empty()) *model = resourcePath("models/default.ttm");
}

/// What models and parts remember of the command.
void keepCommand(std::vector<std::string> words, Arguments& a)
{
    a.train.commandLine = commandLine(words);
    for (const char* option : {"--bins", "--shard"}) drop(words, option);
    splitAtOut(words, a.train);
    drop(words, "--out");
    a.evaluate.command = commandLine(words);
}

int realMain(int argc, char** argv)
{
    openblas_set_num_threads(1);  // our own threads run side by side, one Gaussian process each
    CLI::App app("Terrain profile by touch for tracked robots that see nothing", "terratact");
    app.set_version_flag("--version", "terratact " TERRATACT_VERSION);
    app.require_subcommand(1);
    Arguments arguments;
    addSimulate(app, arguments);
    addTrain(app, arguments);
    addReconstruct(app, arguments);
    addEvaluate(app, arguments);
    addMerge(app, arguments);
    addTradeoff(app, arguments);
    addContacts(app, arguments);
    addGhost(app, arguments);
    addProbes(app, arguments);
    addCalibrate(app, arguments);
    addModel(app, arguments);
    addPanel(app, arguments);
    addDemo(app, arguments);
    addRobotOnBus(app, arguments);
    addCan(app, arguments);
    addSession(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kDone : kWrongArguments;
    }
    useShippedFiles(arguments);
    keepCommand({argv + 1, argv + argc}, arguments);
    if (const Status done = run(app, arguments); !done) {
        fmt::print(stderr, "terratact: {}\n", done.error().text);
        return kFailed;
    }
    return kDone;
}

}  // namespace

}  // namespace terratact

int main(int argc, char** argv)
{
    try {
        return terratact::realMain(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "terratact: {}\n", error.what());
        return 1;
    }
}
