#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/cli/cli_options.h"
#include "app/cli/cli_subcommands.h"
#include "app/cli/commands.h"

namespace terratact {
namespace {

std::string disturbanceNames()
{
    std::string names;
    for (const Disturbance known : kDisturbances)
        names.append(names.empty() ? "" : "|").append(name(known));
    return names;
}

std::optional<std::variant<Disturbance, SensorFault>> disturbedFrom(const std::string& text)
{
    if (const auto known = disturbanceFromName(text)) return *known;
    if (auto fault = sensorFaultFrom(text)) return *std::move(fault);
    return std::nullopt;
}

/// Adds the options of drives with telemetry on the way. Returns --drives.
CLI::Option* addDrives(CLI::App& c, SimulateOptions& o)
{
    CLI::Option* const drives =
        c.add_option(
             "--drives", o.drives,
             "Record so many drives with telemetry on the way, over varied ground or a file")
            ->check(CLI::Range(1, 100'000));
    c.add_option("--spacing", o.way.spacing,
                 "Distance of two stops of a drive [m] (default random, 0.08 to 0.35)")
        ->check(CLI::Range(0.01, 100.0))
        ->needs(drives);
    addNumber(c, "--slip", o.way.slipShare, "Sd of the tracks' slip, as a share of the way")
        ->check(CLI::Range(0.0, 1.0))
        ->needs(drives);
    addNumber(c, "--drive-slip", o.way.driveSlip,
              "Sd of the odometry's error common to a whole drive, as a share of the way")
        ->check(CLI::Range(0.0, 1.0))
        ->needs(drives);
    addNumber(c, "--pitch-bias", o.pitchBiasDegrees, "Added to every reading of pitch [degrees]")
        ->check(CLI::Range(-45.0, 45.0))
        ->needs(drives);
    addNumber(c, "--press-share", o.way.pressShare,
              "Share of the stops at which the robot presses; the others have no scene")
        ->check(CLI::Range(0.0, 1.0))
        ->needs(drives);
    c.add_option("--press-torque", o.way.pressTorque,
                 "Torque of a press, both front flippers [N m] (default random, 12 to 24)")
        ->check(CLI::Range(0.1, 60.0))
        ->needs(drives);
    addNumber(c, "--gap", o.way.gap, "Telemetry lost once per drive [s]")
        ->check(CLI::Range(0.0, 1000.0))
        ->needs(drives);
    return drives;
}

/// Adds the options of a laser map of the simulated drives. Returns --cloud.
CLI::Option* addSimulatedMap(CLI::App& c, SimulatedMapOptions& map)
{
    auto* cloud = addFileOutput(c, "--cloud", map.cloud,
                                "Point cloud of the ground to write (PCD), for truth");
    auto* poses = addFileOutput(c, "--poses", map.poses, "CSV of the scenes' poses in it to write");
    cloud->needs(poses);
    poses->needs(cloud);
    auto* recording =
        addFileOutput(c, "--recording", map.recording,
                      "MCAP to write: the drives as a robot with ROS records them, for import")
            ->needs(cloud);
    c.add_flag("--floor-poses", map.floorPoses,
               "The recording ends with flipper poses on a flat floor, for robot check")
        ->needs(recording);
    addNumber(c, "--cloud-noise", map.made.noise, "Sd of the cloud's heights [m]")
        ->check(CLI::Range(0.0, 1.0));
    addNumber(c, "--cloud-holes", map.made.holes, "Share of the ground without points")
        ->check(CLI::Range(0.0, 0.9));
    addNumber(c, "--cloud-offset", map.made.offset,
              "Added to the cloud's heights, not to poses [m]")
        ->check(CLI::Range(-1.0, 1.0));
    addNumber(c, "--cloud-tilt", map.tilt, "Tilt of the map, cloud and poses [rad]")
        ->check(CLI::Range(-0.5, 0.5));
    addNumber(c, "--cloud-own", map.made.own, "Points of the robot itself at each pose")
        ->check(CLI::Range(0, 100'000));
    return cloud;
}

}  // namespace

void addSimulate(CLI::App& app, Job& job)
{
    auto* c =
        app.add_subcommand("simulate", "Drive a simulated robot over terrain and record scenes");
    const auto o = std::make_shared<SimulateOptions>();
    addRobot(*c, o->robot);
    addTerrain(*c, o->scenes.terrain,
               "boxes (28 runs over boxes of 0.20 and 0.28 m), varied, hazards, or a CSV file of "
               "profiles: two columns x,z in "
               "m, or rows of heights in m")
        ->required();
    addTextOutput(*c, "--out", o->out, "Scenes CSV to write; drives CSV with --drives")->required();
    addNumber(*c, "--seed", o->scenes.seed, "Seed of terrain and noise");
    CLI::Option* const count = c->add_option("--count", o->scenes.count,
                                             "Scenes (default: 1400, or every stop over a file)")
                                   ->check(CLI::Range(1, static_cast<int>(kMaxScenes)));
    CLI::Option* const drives = addDrives(*c, *o)->excludes(count);
    addNumber(*c, "--step", o->scenes.step, "Distance of a file's heights [m]")
        ->check(CLI::Range(0.001, 1.0));
    c->add_flag("--blocks", o->scenes.blocks,
                "A file's heights are flat-topped blocks with vertical faces");
    c->add_flag("--exact-truth", o->scenes.exactTruth, "No scanner noise on the true heights");
    c->add_option("--soft-drives", o->scenes.softDrives,
                  "Share of the drives over ground into which the robot sinks (default 0)")
        ->check(CLI::Range(0.0, 1.0));
    CLI::Option* const tracks =
        c->add_flag("--tracks", o->tracks,
                    "Scenes of left and right: ground under two tracks; a file may have lines "
                    "with y_m");
    addSimulatedMap(*c, o->scenes.map)->excludes(drives);
    const auto disturbed = std::make_shared<std::variant<Disturbance, SensorFault>>();
    addParsed(*c, "--disturb", *disturbed, disturbedFrom, disturbanceNames(),
              fmt::format("is none of {}, nor {}", disturbanceNames(), sensorFaultSyntax()),
              "What the estimator does not know of (default none): of the world, or of sensors "
              "that lie or are lost (stuck:pitch, lost:forces; FAULTS in the manual page)")
        ->excludes(tracks)
        ->excludes(drives);
    c->callback([o, disturbed, &job] {
        if (o->drives > 0 && (o->scenes.terrain == "boxes" || o->scenes.terrain == "hazards"))
            throw CLI::ValidationError("--drives", "needs --terrain varied or a file");
        if (const auto* known = std::get_if<Disturbance>(disturbed.get()))
            o->scenes.disturbance = *known;
        if (const auto* fault = std::get_if<SensorFault>(disturbed.get()))
            o->scenes.sensorFault = *fault;
        useShippedRobot(o->robot);
        o->scenes.map.seed = o->scenes.seed;
        job = [o] { return o->drives > 0 ? recordDrives(*o) : simulate(*o); };
    });
}

}  // namespace terratact
