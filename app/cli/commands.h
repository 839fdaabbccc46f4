#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/link/can_text.h"
#include "app/modelling/evaluation/scene_evaluation.h"
#include "app/modelling/simulation/driven_grounds.h"
#include "app/modelling/simulation/simulated_scenes.h"
#include "app/modelling/trials/fault_trials.h"
#include "app/modelling/truth/laser_truth.h"
#include "core/base/result.h"
#include "core/infer/estimate/settings.h"
#include "core/learn/data/bin_set.h"
#include "core/sim/way_drive.h"

namespace terratact {

// The subcommands of `terratact`. Each returns an Error of one sentence if it fails.

struct SimulateOptions {
    std::string robot;
    std::string out;
    /// With `drives` only terrain, step, blocks, seed, softDrives and exactTruth count.
    SimulatedScenes scenes{};
    bool tracks = false;  ///< scenes of two tracks on ground lines
    /// Number of drives with telemetry on the way, without `count`, disturbance and sensor fault; 0: scenes alone.
    int drives = 0;
    WayDriveOptions way{};          ///< of these drives, without the bias of pitch
    double pitchBiasDegrees = 0.0;  ///< of these drives
};
Status simulate(const SimulateOptions& options);
/// Records options.drives with telemetry on the way (app/modelling/simulation/simulated_drives.h).
Status recordDrives(const SimulateOptions& options);

struct TruthOptions {
    LaserTruthOptions find{};
    std::string out;        ///< scenes CSV with heights
    std::string support;    ///< CSV of sd and points of each bin; empty: none
    std::string sheet;      ///< picture of the scenes; empty: none
    std::string review;     ///< truth file for the console; empty: none
    std::string decisions;  ///< CSV of a person's decisions; empty: none
};
/// Finds the heights of scenes in point clouds (docs/truth.md).
Status findTruth(const TruthOptions& options);

struct TrainOptions {
    std::string robot, out;
    std::vector<std::string> data;  ///< scenes of one plane, in one or several files
    std::vector<std::string>
        tracks;  ///< scenes of two tracks; empty: the model learns one plane only
    std::vector<std::string> generated;  ///< mixed to `data` or `tracks` by held-out error
    std::string plane;       ///< model that is kept instead of training on `data`; empty: none
    double scannerSd = 0.0;  ///< [m] sd of noise added to the conditionals' heights
    int conditionalRows = 1400;
    int inducing = 0;         ///< maximum inducing rows of the conditionals; 0: exact
    std::string commandLine;  ///< stored in the model
    std::uint64_t seed = 1;
    std::optional<BinSet> bins;  ///< writes a part of a model with these bins
    /// The command line without --bins, split around the value of --out.
    std::string commandBeforeOut, commandAfterOut;
    /// Drives in one plane and on two tracks: trail networks are trained instead of a model.
    std::vector<std::string> drives, trackDrives;
    int networks = 5, epochs = 30;  ///< of trail networks
};
/// Trains a model, or with drives the networks of the method trail.
Status train(const TrainOptions& options);

struct ReconstructOptions {
    std::string robot, model, data, out;
    Settings settings;
    double seconds = 0.0;  ///< time limit of each sampling; 0: no limit
    bool tracks = false;   ///< scenes of left and right, estimated by local or joint
};
Status reconstructScenes(const ReconstructOptions& options);

/// Evaluates and prints; writes tables and figures, or one part, into options.out.
Status evaluate(const EvaluateOptions& options);

struct MergeOptions {
    std::vector<std::string> parts;
    std::string robot;  ///< robot file of the training
    std::string out;
};
Status merge(const MergeOptions& options);
/// Returns true for parts of an evaluation, false for parts of a training.
bool isEvaluation(const MergeOptions& options);

struct TradeoffOptions {
    std::string robot, model, data, out;
    std::vector<Method> methods;
    int referenceDraws = 64'000;  ///< draws of the long reference runs
    std::uint64_t seed = 1;
};
/// Measures time and error of settings. Writes tradeoff.csv, presets.csv and a figure into `out` and prints a table.
Status tradeoff(const TradeoffOptions& options);
/// Returns the names of the files that tradeoff() writes.
std::vector<std::string> tradeoffFiles();

struct FaultsOptions {
    std::string robot, model;
    FaultTrial trial{};
    bool matrix = false;  ///< every kind of fault at every sensor, without estimates
};
/// Drives simulated robots with sensor faults. Prints per fault when SensorWatch detects it, the scenes under
/// suspicion, and the error and coverage with the fault.
Status judgeFaults(const FaultsOptions& options);

struct HazardsOptions {
    std::string robot, model;
    int drives = 40;         ///< number per kind of hazard and ground
    double stepLimit = 0.1;  ///< [m]
    /// Hazard rates per unfelt bin; the last one is printed in full. Empty: the defaults.
    std::vector<double> rates;
    bool tracks = false;  ///< both sides, with hazards on one and on both, by the last rate
    bool memory = false;  ///< of tracks: drives with telemetry on the way, by Trail and by Local
    bool manoeuvres = false;  ///< of memory: only drives that turn, reverse and probe
    Settings settings;
};
/// Drives simulated robots towards hazards and prints how often the verdict is wrong
/// (app/modelling/trials/hazard_trials.h).
Status judgeHazards(const HazardsOptions& options);

struct StripOptions {
    std::string robot, model;
    DrivenGrounds grounds;
    int drives = 40;       ///< of a file at most so many profiles
    double spacing = 0.3;  ///< [m] between two scenes
    Settings settings;
};
/// Drives simulated robots and prints the errors of the strip of felt ground (app/modelling/trials/strip_trials.h).
Status judgeStrips(const StripOptions& options);

struct FeelForwardOptions {
    std::string robot, model;
    int drives = 50;
    double stepLimit = 0.1;        ///< [m]
    double estimateSeconds = 0.2;  ///< [s] duration of an estimate in the time model
    bool isBlind = false;          ///< advances whatever the verdict is
    Settings settings;
};
/// Drives simulated robots by feel forward and prints falls, collisions, way, pace and why each loop ended
/// (app/modelling/trials/feel_forward_trials.h).
Status tryFeelForward(const FeelForwardOptions& options);

struct ContactsOptions {
    std::string robot, data;
    double threshold = Settings{}.forceThreshold;  ///< [N]
};
/// Prints the errors of contact heights, per bin and overall, for both contact rules.
Status showContacts(const ContactsOptions& options);

/// Prints an arm's measurement error from a CSV of readings (core/learn/data/probe_file.h), and the line for the robot
/// file. Error: the readings give no sd. Readings of each place that are all the same give none, even with truths:
/// copies would make it too small.
Status showProbes(const std::string& path);

struct CalibrateOptions {
    std::string robot, data;
};
/// Prints the force elements' calibration for the robot file. Input: CSV side,element,force_n,voltage_v of known forces
/// (core/robot/force_calibration.h).
Status calibrateForces(const CalibrateOptions& options);

struct PanelCheckOptions {
    std::string file;
    bool lamps = false;    ///< lights each lamp for a second
    bool watch = false;    ///< prints changes until interrupted
    double seconds = 1e9;  ///< duration of --watch
};
/// Prints where an operator's panel was found, and the state of its contacts.
Status checkPanel(const PanelCheckOptions& options);

Status showModel(const std::string& path, bool csv);

struct ModelCardOptions {
    std::string model;
    std::string trained, terrain;  ///< empty: unchanged in the card
};
/// Updates or creates the card of a model, and prints it.
Status describeModel(const ModelCardOptions& options);

/// Prints mean and sd of every conditional p(hᵢ | h_{J∖i}, s) for complete scenes, as CSV.
Status predictConditionals(const std::string& modelPath, const std::string& dataPath);

struct DemoOptions {
    std::string robot, model, out = ".";
    Settings settings;
    double seconds = 0.0;  ///< time limit of each sampling; 0: no limit
};
Status demo(const DemoOptions& options);
/// Returns the names of the files that demo() may write.
std::vector<std::string> demoFiles();

struct RobotOptions {
    std::string robot;
    std::string can;             ///< CAN interface
    std::string terrain;         ///< profile file, "varied", or empty: the demo's terrain
    std::string fault = "none";  ///< NAME or NAME@SECONDS
    std::uint64_t seed = 1;
    double speed = 1.0;    ///< simulated seconds per second
    double seconds = 0.0;  ///< run time; 0: until interrupted
};
/// Runs a simulated robot on a CAN bus, in its own process.
Status runRobot(const RobotOptions& options);

struct RobotCheckOptions {
    std::string file;                     ///< robot file
    std::string picture;                  ///< PNG, SVG or PDF to write; empty: none
    std::vector<std::string> recordings;  ///< sessions on a flat floor; empty: no calibration
    std::string out;                      ///< calibrated robot file to write; empty: none
};
/// Prints the findings about a robot file and draws it (app/modelling/robots/robot_check.h). Error if it has a
/// problem. Else calibrates it from the recordings (app/modelling/robots/robot_calibration.h).
Status checkRobotFiles(const RobotCheckOptions& options);

struct CanDecodeOptions {
    std::string log;        ///< "-": standard input
    std::string interface;  ///< empty: all interfaces
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
    std::string csv;                 ///< output file; empty: none
    bool summaryOnly = false;        ///< prints no line per frame
};
/// Prints every frame of a log as text and the faults of each interface.
Status decodeCanLog(const CanDecodeOptions& options);

struct CanMonitorOptions {
    std::string bus;        ///< an interface, or a log to replay
    std::string interface;  ///< needed if the log holds several
    double speed = 1.0;     ///< replay speed
    CanProtocol protocol = CanProtocol::Terratact;
    std::vector<std::string> dbc{};  ///< DBC files for frames outside the protocol
    double bitrate = 500'000.0;      ///< [bit/s] for the bus load
    std::optional<double> seconds;   ///< run time; empty: until the replay's end, or forever
};
/// Shows the traffic of a bus. On a terminal the table refreshes five times a second, otherwise once a second.
Status monitorCan(const CanMonitorOptions& options);

/// Prints the faults of an interface with the command that fixes each, or the content of a log. Returns an Error if it
/// cannot be used.
Status checkCan(const std::string& interfaceOrLog);

}  // namespace terratact
