#include <memory>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/commands.h"
#include "app/link/log_help.h"

namespace terratact {
namespace {

void addPanel(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("panel", "The operator's panel of buttons and lamps");
    c->require_subcommand(1);
    auto* check =
        c->add_subcommand("check", "Find the panel's lines and show its contacts: docs/panel.md");
    const auto o = std::make_shared<PanelCheckOptions>();
    addInput(*check, "file", o->file, "Panel file (resources/panels/example.toml)")->required();
    check->add_flag("--lamps", o->lamps, "Light each lamp for a second");
    auto* watch = check->add_flag("--watch", o->watch, "Print what changes, until interrupted");
    check->add_option("--seconds", o->seconds, "End watching after so long")
        ->needs(watch)
        ->check(CLI::Range(0.0, 1e9));
    check->callback([o, &job] { job = [o] { return checkPanel(*o); }; });
}

void addDemo(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "demo", "The main job on the built-in simulated robot: drive up to an unseen step, ATEM, "
                "estimate, one probe, second estimate");
    const auto o = std::make_shared<DemoOptions>();
    addRobot(*c, o->robot);
    addModel(*c, o->model);
    addFolderOutput(*c, "--out", o->out, "Directory for CSV and PNG", demoFiles)
        ->capture_default_str();
    addMethod(*c, o->settings);
    addSettings(*c, o->settings, o->seconds);
    c->callback([o, &job] {
        useShippedRobot(o->robot);
        useShippedModel(o->model);
        job = [o] { return demo(*o); };
    });
}

void addRobotCheck(CLI::App& robot, Job& job)
{
    auto* c = robot.add_subcommand("check",
                                   "Hold the numbers of a robot file against each other, and draw "
                                   "them: docs/robot.md; exit code 0: no problem");
    const auto o = std::make_shared<RobotCheckOptions>();
    addInput(*c, "file", o->file, "Robot file")->required();
    addFileOutput(*c, "--picture", o->picture, "Picture of the robot to write: PNG, SVG or PDF");
    auto* recordings =
        addInput(*c, "--recordings", o->recordings,
                 "Sessions on a flat, level floor: calibrate tracks, flippers, torque, encoders "
                 "and IMU from the poses in which the robot stands");
    addTextOutput(*c, "--out", o->out, "Robot file to write, with the calibrated numbers")
        ->needs(recordings);
    c->callback([o, &job] { job = [o] { return checkRobotFiles(*o); }; });
}

void addRobotOnBus(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand(
        "robot", "A simulated robot as a process of its own on a CAN bus: the protocol of "
                 "resources/dbc/terratact.dbc, obeys and refuses as a real one has to");
    const auto o = std::make_shared<RobotOptions>();
    addRobot(*c, o->robot);
    c->add_option("--can", o->can, "Interface, such as vcan0; required without a subcommand");
    addTerrain(
        *c, o->terrain,
        "CSV of a profile or ground lines, or 'varied' for random ground (default: the demo's)");
    c->add_option(
         "--fault", o->fault,
         "What goes wrong: silence, stuck-imu, dead-element, refuse-probe, slow-arm, reboot, or "
         "sensors that lie or are lost, KIND:SENSORS[:AMOUNT] (stuck:pitch, lost:force-6; FAULTS "
         "in the manual page), from the start or @SECONDS later")
        ->capture_default_str();
    c->add_option("--seed", o->seed, "Of terrain and sensor noise")->capture_default_str();
    c->add_option("--speed", o->speed, "Simulated seconds per second")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 1000.0));
    c->add_option("--seconds", o->seconds, "Ends after this time (default: when interrupted)")
        ->check(CLI::NonNegativeNumber);
    addRobotCheck(*c, job);
    c->callback([o, c, &job] {
        if (!c->get_subcommands().empty()) return;
        if (o->can.empty()) throw CLI::RequiredError("--can");
        useShippedRobot(o->robot);
        job = [o] { return runRobot(*o); };
    });
}

void addProtocol(CLI::App& app, CanProtocol& protocol)
{
    addChoice(app, "--protocol", protocol, canProtocolFromName, "terratact|absolem",
              "Whose frames are on the bus (default terratact)");
}

void addDbc(CLI::App& app, std::vector<std::string>& files)
{
    addInput(app, "--dbc", files,
             "DBC file for frames that are not the protocol's; may be repeated")
        ->allow_extra_args(false);
}

void addCanDecode(CLI::App& can, Job& job)
{
    auto* c = can.add_subcommand("decode", "Every frame of a log in words, and what was wrong");
    const auto o = std::make_shared<CanDecodeOptions>();
    addLog(*c, "log", o->log, kLogHelp)->required();
    c->add_option("--interface", o->interface, "Only of this one");
    addTextOutput(*c, "--csv", o->csv, "CSV to write, a row for each value");
    c->add_flag("--summary", o->summaryOnly, "No line for each frame");
    addProtocol(*c, o->protocol);
    addDbc(*c, o->dbc);
    c->callback([o, &job] { job = [o] { return decodeCanLog(*o); }; });
}

void addCanMonitor(CLI::App& can, Job& job)
{
    auto* c = can.add_subcommand("monitor", "What is on a bus: values, rates, ages, load, drops");
    const auto o = std::make_shared<CanMonitorOptions>();
    addLog(*c, "bus", o->bus, "Interface, or a log to replay (as of decode)")->required();
    c->add_option("--seconds", o->seconds, "Then it ends (default: never)")
        ->check(CLI::Range(0.0, 1e6));
    addNumber(*c, "--bitrate", o->bitrate, "Of the bus, for its load [bit/s]")
        ->check(CLI::Range(1e3, 1e6));
    c->add_option("--interface", o->interface, "Of a log that holds several");
    addNumber(*c, "--speed", o->speed, "Of a replay: seconds of the log per second")
        ->check(CLI::Range(0.001, 1000.0));
    addProtocol(*c, o->protocol);
    addDbc(*c, o->dbc);
    c->callback([o, &job] { job = [o] { return monitorCan(*o); }; });
}

void addCanCheck(CLI::App& can, Job& job)
{
    auto* c = can.add_subcommand(
        "check",
        "What is wrong with an interface, and which command mends it, or what a log holds; exit "
        "code 0: usable");
    const auto interface = std::make_shared<std::string>();
    c->add_option("interface", *interface, "Such as can0, or a log")->required();
    c->callback([interface, &job] { job = [interface] { return checkCan(*interface); }; });
}

}  // namespace

void addBuses(CLI::App& app, Job& job)
{
    addPanel(app, job);
    addDemo(app, job);
    addRobotOnBus(app, job);
    auto* can = app.add_subcommand("can", "Look at CAN buses and their logs; sends nothing");
    can->require_subcommand(1);
    addCanDecode(*can, job);
    addCanMonitor(*can, job);
    addCanCheck(*can, job);
}

}  // namespace terratact
