#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <vector>

#include "app/cli/commands.h"
#include "app/figures/profile_figure.h"
#include "app/modelling/estimate_csv.h"
#include "app/modelling/scene_estimates.h"
#include "app/runtime/parallel.h"
#include "app/runtime/print_text.h"
#include "app/runtime/time_budget.h"
#include "core/atem/probe/arm_choice.h"
#include "core/infer/verdict/estimate_text.h"
#include "core/sim/ground/terrain_shapes.h"
#include "core/sim/simulated_robot.h"
#include "core/store/file_group.h"
#include "core/store/file_write.h"
#include "core/terrain/body_ceiling.h"

namespace terratact {

namespace {

constexpr double kTick = 0.05;         // [s] telemetry period
constexpr double kStopBefore = 0.47;   // [m] distance from base to step at which the operator stops
constexpr double kPressTorque = 18.0;  // [N m]
constexpr int kMaxLength = 20 * 120;   // [ticks] two minutes, longer than any phase

/// Runs the simulation until the robot does `wanted`; returns false if it refuses or takes too long.
template <class Condition>
bool waitFor(SimulatedRobot& robot, Condition wanted)
{
    for (int tick = 0; tick < kMaxLength; ++tick) {
        robot.step(kTick);
        const Measurement m = robot.measure();
        if (wanted(m)) return true;
        if (m.refusal != Refusal::None) return false;
    }
    return false;
}

Error refused(SimulatedRobot& robot, std::string_view what)
{
    return Error{fmt::format("the simulated robot did not {}: {}", what,
                             describe(robot.measure().refusal).english),
                 0};
}

Status driveToStep(SimulatedRobot& robot)
{
    robot.command(DriveCommand{0.3});
    if (!waitFor(robot, [&](const Measurement&) {
            return robot.pose().base.x >= kDemoStep - kStopBefore;
        }))
        return refused(robot, "reach the step");
    robot.command(HaltCommand{});
    return Done{};
}

Status pressFlippers(SimulatedRobot& robot)
{
    robot.command(PressCommand{kPressTorque});
    if (!waitFor(robot, [](const Measurement& m) { return m.activity == RobotActivity::Pressed; }))
        return refused(robot, "press its flippers");
    return Done{};
}

Status probe(SimulatedRobot& robot, int bin)
{
    robot.command(ProbeCommand{bin});
    if (!waitFor(robot, [](const Measurement& m) { return m.arm.has_value(); }))
        return refused(robot, "probe");
    return Done{};
}

/// Prints an estimate and writes it to `stem`.csv and `stem`.png.
Status present(const TerrainEstimate& estimate, const Scene& scene, const RobotModel& robot,
               std::optional<int> bin, const std::string& title, const std::filesystem::path& stem)
{
    Heights truth{};
    for (std::size_t i = 0; i < kBins; ++i) truth[i] = *scene.truth[i];
    printText("\n{}\n{}", title, Lines(profileTable(estimate, truth)));
    for (const Message& sentence : hiddenByBands(estimate)) printText("  {}\n", sentence.english());
    for (const Message& warning : estimate.warnings) printText("! {}\n", warning.english());
    const std::string csv = estimateCsv({scene}, {{estimate, ""}});
    FileGroup files;
    if (Status s = files.add(stem.string() + ".csv", csv); !s) return s;
    FigureInput figure;
    figure.estimate = estimate;
    figure.outline = robotOutline(robot, scene.s.pitch, scene.s.front, scene.s.rear);
    figure.truth = truth;
    figure.title = title;
    figure.proposedBin = bin;
    if (Status s = writeProfileFigure(stem.string() + ".png", figure, files.writer()); !s) return s;
    return files.commit();
}

Scene sceneOf(const Measurement& measurement, const Heights& truth)
{
    Scene scene{
        .run = "demo", .time = measurement.time, .s = proprioception(measurement), .truth = {}};
    for (std::size_t i = 0; i < kBins; ++i) scene.truth[i] = truth[i];
    return scene;
}

}  // namespace

std::vector<std::string> demoFiles()
{
    return {"first.csv", "first.png", "second.csv", "second.png"};
}

Status demo(const DemoOptions& options)
{
    const auto bundle = openEstimatorBundle(options.robot, options.model);
    if (!bundle) return bundle.error();
    if (Status made = makeDirectory(options.out); !made) return made;
    const std::filesystem::path out(options.out);

    SimulatedRobot::Options start;
    start.startX = 1.2;
    start.seed = options.settings.seed;
    SimulatedRobot robot((*bundle)->robot, demoTerrain(), start);
    printText("SIMULATED ROBOT, method {}, seed {}\n", name(options.settings.method),
              options.settings.seed);
    if (Status s = driveToStep(robot); !s) return s;
    printText("{:6.1f} s  driven blind up to an unseen step; ATEM: halted, pressing the "
              "flippers\n",
              robot.measure().time);
    if (Status s = pressFlippers(robot); !s) return s;
    const Measurement measurement = robot.measure();
    const Scene scene = sceneOf(measurement, robot.truth());
    printText("{:6.1f} s  flippers pressed, scene captured\n", measurement.time);

    const auto estimateWith = [&](std::span<const ArmReading> arm) {
        Watch watch = endingAfter(options.seconds);
        lendProcessors(watch);
        return estimateTerrain(scene.s, arm, (*bundle)->robot, (*bundle)->models, options.settings,
                               watch);
    };
    const TerrainEstimate first = estimateWith({});
    const std::optional<int> bin = chooseProbe(first, (*bundle)->robot);
    if (Status s = present(first, scene, (*bundle)->robot, bin, "First estimate, by flippers alone",
                           out / "first");
        !s)
        return s;
    if (!bin) {
        printText("\nno bin is uncertain enough to probe\n\nwritten: {}\n",
                  (out / "first.{csv,png}").string());
        return Done{};
    }
    printText("\n{:6.1f} s  probe proposed at {:+.1f} m (sd {:.0f} mm), approved\n",
              robot.measure().time, binCentre(*bin),
              1000.0 * first.sd[static_cast<std::size_t>(*bin)]);
    if (Status s = probe(robot, *bin); !s) return s;
    const ArmReading reading = *robot.measure().arm;
    printText("{:6.1f} s  arm measured {:+.3f} m\n", robot.measure().time, reading.height);
    const TerrainEstimate second = estimateWith({&reading, 1});
    if (Status s = present(second, scene, (*bundle)->robot, std::nullopt,
                           "Second estimate, with the probe", out / "second");
        !s)
        return s;
    printText("\nwritten: {} and {}\n", (out / "first.{csv,png}").string(),
              (out / "second.{csv,png}").string());
    return Done{};
}

}  // namespace terratact
