#include <memory>
#include <string>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/commands.h"

namespace terratact {
namespace {

void addTruthInputs(CLI::App& c, LaserTruthOptions& o)
{
    addInput(c, "clouds", o.clouds,
             "Point clouds: PCD, PLY or text of x y z; with --topic recordings")
        ->required();
    addInput(c, "--scenes", o.scenes, "Scenes CSV, of one plane or of left and right")->required();
    addInput(c, "--poses", o.poses,
             "Robot's poses in the cloud: TUM, CSV, or a recording with --mapping")
        ->required();
    addInput(c, "--mapping", o.mapping, "Mapping file whose [odometry] names the poses' topic");
    c.add_option("--topic", o.topic, "Topic of PointCloud2 messages in recordings");
    addRobot(c, o.robot);
    c.add_flag("--scans", o.scans,
               "Each cloud is in the sensor's frame; the last number of its name is its time");
    addInput(c, "--session", o.session, "Session of the scenes: its begin is t_s = 0");
    c.add_option("--start", o.start, "Time of the poses' clock at t_s = 0 [s]; default 0")
        ->excludes("--session");
    c.add_option("--run", o.run, "Only the scenes of this run");
}

void addTruthMounts(CLI::App& c, LaserTruthOptions& o)
{
    const std::string kind = "\"X Y Z ROLL PITCH YAW\"";
    const std::string complaint = "is not six numbers: x y z in m, roll pitch yaw in degrees";
    addParsed(c, "--pose-mount", o.poseMount, mountFrom, kind, complaint,
              "Pose of the poses' frame in the base [m, degrees]; default: the base itself");
    addParsed(c, "--sensor-mount", o.sensorMount, mountFrom, kind, complaint,
              "Pose of the sensor of scans in the base [m, degrees]");
    c.add_option("--tf-base", o.tfBase,
                 "Frame of the base: /tf and /tf_static say where the sensor of --topic is")
        ->needs("--topic")
        ->excludes("--sensor-mount");
}

void addTruthRules(CLI::App& c, LaserTruthOptions& o)
{
    addNumber(c, "--percentile", o.rule.percentile,
              "Percentile of a cell's points that is the ground: 50, or less among plants")
        ->check(CLI::Range(1.0, 99.0));
    addNumber(c, "--max-sd", o.rule.maxSd, "Bins with a larger sd stay empty [m]")
        ->check(CLI::Range(0.001, 1.0));
    c.add_flag("--align", o.align, "Remove offset and tilt between cloud and robot");
    addNumber(c, "--max-speed", o.limits.maxSpeed, "A faster pose jumps, and is refused [m/s]")
        ->check(CLI::Range(0.01, 1000.0));
    addNumber(c, "--max-gap", o.limits.maxGap, "Longest time between two poses around a scene [s]")
        ->check(CLI::Range(0.001, 3600.0));
}

}  // namespace

void addTruth(CLI::App& app, Job& job)
{
    auto* c = app.add_subcommand("truth",
                                 "Find the true heights of scenes in laser clouds: docs/truth.md");
    const auto o = std::make_shared<TruthOptions>();
    addTruthInputs(*c, o->find);
    addTextOutput(*c, "--out", o->out, "Scenes CSV with heights to write")->required();
    addTextOutput(*c, "--support", o->support, "CSV to write: sd, points and cells of each bin");
    addFileOutput(*c, "--sheet", o->sheet, "Picture of the scenes to write: PNG, SVG or PDF");
    addFileOutput(*c, "--review", o->review,
                  "Truth file to write, for terratact-console: accept, exclude, nudge scenes");
    addInput(*c, "--decisions", o->decisions,
             "CSV of decisions on scenes, as terratact-console writes it");
    addTruthMounts(*c, o->find);
    addTruthRules(*c, o->find);
    c->callback([o, &job] {
        useShippedRobot(o->find.robot);
        if (o->find.scans && !o->find.topic.empty())
            throw CLI::ValidationError("--scans",
                                       "is for files; clouds of a --topic are scans already");
        job = [o] { return findTruth(*o); };
    });
}

}  // namespace terratact
