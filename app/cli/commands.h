#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/modelling/findings.h"
#include "core/base/result.h"
#include "core/infer/estimate/settings.h"
#include "core/learn/data/bin_set.h"
#include "core/sim/disturbance.h"
#include "core/sim/sensor_fault.h"

namespace terratact {

// The subcommands of `terratact`.  Each returns what stood in its way, in one sentence.

struct SimulateOptions {
    std::string robot;
    std::string terrain = "boxes";  ///< "boxes", "varied", "hazards", or a file of profiles
    std::string out;
    std::uint64_t seed = 1;
    int count = 0;        ///< scenes; 0: 1400 for the presets, every stop of a file
    double step = 0.1;    ///< [m] of a file of heights
    bool blocks = false;  ///< heights of a file are flat-topped blocks
    bool exactTruth = false;
    Disturbance disturbance = Disturbance::None;
    std::optional<SensorFault> sensorFault{};  ///< of every drive, from its start
    double softDrives =
        0.0;  ///< share of drives over ground that gives way  ///< of the simulated world
};
Status simulate(const SimulateOptions& options);

struct TrainOptions {
    std::string robot, data, out;
    double scannerSd = 0.0;  ///< [m] of noise added to the conditionals' heights
    int conditionalRows = 1400;
    int inducing = 0;         ///< rows the conditionals predict through, at most; 0: all
    std::string commandLine;  ///< kept in the model
    std::uint64_t seed = 1;
    std::optional<BinSet> bins;  ///< writes the part of a model with these
    /// commandLine without --bins, around the value of --out.
    std::string commandBeforeOut, commandAfterOut;
};
Status train(const TrainOptions& options);

struct ReconstructOptions {
    std::string robot, model, data, out;
    Settings settings;
    double seconds = 0.0;  ///< of every sampling; 0: no limit
};
Status reconstructScenes(const ReconstructOptions& options);

struct EvaluateOptions {
    std::string robot, model, data, out;
    std::vector<Method> methods;
    Settings settings;
    double seconds = 0.0;               ///< of every sampling; 0: no limit
    double stepLimit = 0.10;            ///< [m] of a step that is asked for (hasStep())
    std::string classes;                ///< index file; empty: no table by class
    std::string classColumn = "class";  ///< of the index file
    bool probes = false;                ///< also simulate probes by three rules
    bool missing = false;               ///< instead: what every method errs without some sensors
    std::optional<Shard> shard;         ///< writes the findings of this part alone
    bool card = false;                  ///< also writes what the methods err into the model's card
    std::string command;                ///< without --shard and --out
};
Status evaluate(const EvaluateOptions& options);
/// The name of the file with the findings of one part.
std::string shardFile(const Shard& shard);

struct MergeOptions {
    std::vector<std::string> parts;
    std::string robot;  ///< of a training
    std::string out;
};
Status merge(const MergeOptions& options);
/// Whether they are parts of an evaluation, not of a training.
bool isEvaluation(const MergeOptions& options);

struct TradeoffOptions {
    std::string robot, model, data, out;
    std::vector<Method> methods;
    int referenceDraws = 64'000;  ///< of the long runs
    std::uint64_t seed = 1;
};
/// Measures what settings cost and err: tradeoff.csv, presets.csv and a figure in `out`, a table on stdout.
Status tradeoff(const TradeoffOptions& options);
/// The names of the files that tradeoff() writes.
std::vector<std::string> tradeoffFiles();

struct GhostOptions {
    std::string robot, model;
    std::string terrain = "varied";  ///< "boxes", "varied", or a file of profiles
    double step = 0.1;               ///< [m] of a file of heights
    bool blocks = false;             ///< heights of a file are flat-topped blocks
    int drives = 60;                 ///< over random ground, or profiles of the file at most
    double spacing = 0.3;            ///< [m] driven between two scenes
    double sdFactor = 1.0;           ///< of the ghost's sd where it is a measurement
    std::vector<Method> methods;
    Settings settings;
};
/// Drives simulated robots from scene to scene and prints what the last estimate is worth at the next: as it is
/// drawn, and as a weak measurement of the next estimate.
Status judgeGhost(const GhostOptions& options);

struct FaultsOptions {
    std::string robot, model;
    std::string terrain = "varied";  ///< "varied", or a file of profiles
    double step = 0.1;               ///< [m] of a file of heights
    bool blocks = false;             ///< heights of a file are flat-topped blocks
    int drives = 40;                 ///< over random ground, or profiles of the file at most
    double spacing = 0.3;            ///< [m] driven between two scenes
    bool comesBack = false;          ///< every drive turns round at its end and comes back
    bool matrix = false;             ///< every kind of fault at every sensor, without estimates
    Settings settings;
};
/// Drives simulated robots whose sensors lie and prints, fault by fault, when SensorWatch notices it, in how many
/// scenes it stands, and what error and cover are with it.
Status judgeFaults(const FaultsOptions& options);

struct HazardsOptions {
    std::string robot, model;
    int drives = 40;         ///< per kind of hazard and ground
    double stepLimit = 0.1;  ///< [m]
    std::vector<double>
        rates;  ///< of hazards per unfelt bin, the last is shown in full; empty: the defaults
    Settings settings;
};
/// Drives simulated robots towards hazards and prints how often the verdict is wrong (app/modelling/hazard_trials.h).
Status judgeHazards(const HazardsOptions& options);

struct ContactsOptions {
    std::string robot, data;
    double threshold = Settings{}.forceThreshold;  ///< [N]
};
/// Prints how far contact heights lie from the truth, per bin and overall, for both contact rules.
Status showContacts(const ContactsOptions& options);

/// Prints how well an arm measures, from a CSV of readings (core/learn/data/probe_file.h), and the line for the
/// robot file.
Status showProbes(const std::string& path);

struct CalibrateOptions {
    std::string robot, data;
};
/// Prints the force elements' calibration for the robot file, from a CSV side,element,force_n,voltage_v of
/// known forces laid on them (core/robot/force_calibration.h).
Status calibrateForces(const CalibrateOptions& options);

struct PanelCheckOptions {
    std::string file;
    bool lamps = false;    ///< light each for a second
    bool watch = false;    ///< print what changes, until interrupted
    double seconds = 1e9;  ///< of watching
};
/// Prints where an operator's panel was found and the state of its contacts.
Status checkPanel(const PanelCheckOptions& options);

Status showModel(const std::string& path, bool csv);

struct ModelCardOptions {
    std::string model;
    std::string trained, terrain;  ///< empty: as the card has it
};
/// Writes into the card of a model, which it begins where there is none, and prints it.
Status describeModel(const ModelCardOptions& options);

/// Prints mean and sd of every conditional p(hᵢ | h_{J∖i}, s) for complete scenes, as CSV.
Status predictConditionals(const std::string& modelPath, const std::string& dataPath);

struct DemoOptions {
    std::string robot, model, out = ".";
    Settings settings;
    double seconds = 0.0;  ///< of every sampling; 0: no limit
};
Status demo(const DemoOptions& options);
/// The names of the files that demo() may write.
std::vector<std::string> demoFiles();

struct RobotOptions {
    std::string robot;
    std::string can;             ///< interface
    std::string terrain;         ///< file of a profile, "varied", or empty: the demo's
    std::string fault = "none";  ///< NAME or NAME@SECONDS
    std::uint64_t seed = 1;
    double speed = 1.0;    ///< simulated seconds per second
    double seconds = 0.0;  ///< 0: until it is interrupted
};
/// A simulated robot as a process of its own on a CAN bus.
Status runRobot(const RobotOptions& options);

}  // namespace terratact
